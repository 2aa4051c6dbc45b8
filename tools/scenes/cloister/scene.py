"""A cloister in the sun: the scene that is shown when none is named."""
from scenes.cloister.arcade import add_arcade
from scenes.cloister.door import add_doors
from scenes.cloister.fountain import add_fountain
from scenes.cloister.ground import add_ground
from scenes.cloister.materials import Materials
from scenes.cloister.plants import add_plants
from scenes.cloister.roof import add_roof
from scenes.cloister.tower import add_tower
from scenes.gltf import Gltf


def cloister():
    g = Gltf(decimals=5)
    materials = Materials(g)
    g.camera("main", [2.4, 1.95, 7.0], [-0.2, 2.5, 0], 51)
    g.camera("arcade", [-8.6, 1.75, -9.25], [2, 2.0, -8.3], 52)
    g.camera("fountain", [2.6, 1.9, 3.2], [0, 1.5, 0], 45)
    add_ground(g, materials)
    add_arcade(g, materials)
    add_doors(g, materials)
    add_roof(g, materials)
    add_fountain(g, materials)
    add_plants(g, materials)
    add_tower(g, materials)
    return g.glb()
