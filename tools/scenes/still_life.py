"""A still life: a golden knot on steps, spheres and cubes, columns on a checkered ground."""
import math

from scenes.gltf import Gltf
from scenes.shapes import box, joined, quad, sphere, torus_knot, turned


def checkers(tiles, size):
    """Two geometries, the light and the dark tiles of a square ground."""
    shapes = ([], [])
    for i in range(tiles):
        for j in range(tiles):
            x, z = (i - tiles / 2) * size, (j - tiles / 2) * size
            shapes[(i + j) % 2].append(quad([x, 0, z], [x, 0, z + size], [x + size, 0, z + size], [x + size, 0, z]))
    return [joined(*s) for s in shapes]


def column_profile():
    """Plinth, base moulding, a shaft that narrows a little, capital."""
    profile = [(0.50, 0), (0.50, 0.12), (0.44, 0.16), (0.44, 0.24), (0.36, 0.32)]
    profile += [(0.34 - 0.06 * (i / 8) ** 2, 0.36 + 2.9 * i / 8) for i in range(9)]
    return profile + [(0.36, 3.34), (0.44, 3.42), (0.48, 3.50), (0.48, 3.64)]


def still_life():
    g = Gltf()
    light, dark = checkers(40, 1.25)
    g.node(name="ground", mesh=g.mesh((g.geometry(light), g.material("cream", 0.80, 0.76, 0.68)),
                                      (g.geometry(dark), g.material("slate", 0.20, 0.24, 0.29))))
    stone = g.material("stone", 0.72, 0.68, 0.60)
    steps = joined(*[turned([(r, y), (r, y + 0.25)], 96) for r, y in ((2.6, 0), (2.1, 0.25), (1.6, 0.5))])
    g.node(name="steps", mesh=g.mesh((g.geometry(steps), stone)))
    knot = g.geometry(torus_knot(2, 3, 400, 28, 0.2))
    g.node(name="knot", mesh=g.mesh((knot, g.material("gold", 0.90, 0.56, 0.12))), translation=[0, 2.12, 0],
           rotation=[0, 0.2588190, 0, 0.9659258], scale=[1.25, 1.25, 1.25])
    column = g.mesh((g.geometry(turned(column_profile(), 40)), stone))
    for i in range(7):
        angle = math.radians(-170 + 23.5 * i)
        g.node(mesh=column, translation=[round(5.6 * math.cos(angle), 4), 0, round(5.6 * math.sin(angle), 4)])
    ball = g.geometry(sphere(40, 80))
    balls = (("red", (0.75, 0.09, 0.07), 2.9, 2.6, 0.95), ("blue", (0.07, 0.22, 0.62), -3.3, 1.5, 0.8),
             ("teal", (0.05, 0.48, 0.45), -2.1, 3.5, 0.5), ("white", (0.85, 0.85, 0.83), 0.5, 3.9, 0.4),
             ("plum", (0.38, 0.10, 0.38), 4.5, 0.4, 0.6))
    for name, colour, x, z, r in balls:
        g.node(name=name, mesh=g.mesh((ball, g.material(name, *colour))), translation=[x, 0, z], scale=[r, r, r])
    cube = g.geometry(box([-0.5, 0, -0.5], [0.5, 1, 0.5]))
    g.node(name="green cube", mesh=g.mesh((cube, g.material("green", 0.22, 0.50, 0.12))), translation=[-0.9, 0, 4.6],
           rotation=[0, 0.3420201, 0, 0.9396926], scale=[0.55, 0.55, 0.55])
    g.node(name="orange cube", mesh=g.mesh((cube, g.material("orange", 0.85, 0.30, 0.06))), translation=[-4.3, 0, 3.2],
           rotation=[0, -0.1736482, 0, 0.9848078], scale=[0.8, 0.8, 0.8])
    g.camera("main", [3.6, 4.6, 11.6], [-0.1, 1.4, 0], 35)
    return g.glb()
