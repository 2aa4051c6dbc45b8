"""A cloister in the sun: the scene that is shown when none is named."""
from scenes.cloister.arcade import add_arcade
from scenes.cloister.door import add_doors
from scenes.cloister.fountain import add_fountain
from scenes.cloister.ground import add_ground
from scenes.cloister.materials import Materials
from scenes.cloister.plants import add_plants
from scenes.cloister.roof import add_roof
from scenes.cloister.tower import add_tower
from scenes.features.motion import animate
from scenes.features.stage import turn
from scenes.gltf import Gltf
from scenes.shapes import torus_knot


def built():
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
    return g


def cloister():
    return built().glb()


def with_mobile():
    """A knot of 20,320 triangles turns above the fountain and goes up and down, in four seconds."""
    g = built()
    knot = g.mesh((g.geometry(torus_knot(2, 3, 254, 40, 0.2)), g.material("gold", 0.90, 0.56, 0.12, 1, 0.3)))
    mobile = g.node(name="mobile", mesh=knot, translation=[0, 4.2, 0])
    turns = [turn([0, 1, 0], degrees) for degrees in (0, 90, 180, 270, 360)]
    heights = [[0, y, 0] for y in (4.2, 4.8, 4.2, 3.9, 4.2)]
    animate(g, "turn", (mobile, "rotation", [0, 1, 2, 3, 4], turns, "LINEAR"),
            (mobile, "translation", [0, 1, 2, 3, 4], heights, "LINEAR"))
    return g.glb()
