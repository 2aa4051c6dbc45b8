"""A cloister in the sun: the scene that is shown when none is named."""
from scenes.cloister.arcade import add_arcade
from scenes.cloister.fountain import add_fountain
from scenes.cloister.ground import add_ground
from scenes.cloister.materials import add_materials
from scenes.cloister.roof import add_roof
from scenes.gltf import Gltf


def cloister():
    g = Gltf(decimals=5)
    materials = add_materials(g)
    g.camera("main", [2.4, 1.95, 9.4], [-0.6, 2.35, 0], 46)
    g.camera("court", [5.8, 2.2, 5.9], [-1.2, 2.2, -2.5], 55)
    g.camera("arcade", [-8.9, 1.9, 9.2], [-8.6, 2.0, 0], 50)
    g.camera("fountain", [2.6, 1.9, 3.2], [0, 1.5, 0], 45)
    add_ground(g, materials)
    add_arcade(g, materials)
    add_roof(g, materials)
    add_fountain(g, materials)
    return g.glb()
