"""The fountain: an eight-sided basin, a bowl on a baluster, a bronze knot."""
import math

from scenes.cloister.arcade import bulge
from scenes.shapes import lathed, sheet, smoothed, torus_knot, turned
from scenes.vectors import quaternion


def water(radius, y, waves):
    """A disc with rings of waves that run out from its middle."""
    def point(u, v):
        r = radius * (1 - u)
        lift = 0.0035 * waves * math.sin(26 * r) * math.exp(-1.2 * r) if r > 0 else 0
        return [r * math.sin(2 * math.pi * v), y + lift, r * math.cos(2 * math.pi * v)]
    rows = round(40 * radius)
    shape = sheet(rows, 64, point, (False, True))
    return smoothed(shape._replace(triangles=[t for t in shape.triangles if not sum(i >= rows * 64 for i in t) > 1]))


def add_fountain(g, materials):
    step = turned([(2.3, -0.05), (2.3, 0.15), (2.28, 0.17)], 64)
    # Eight sides: out over the mouldings, over the rim, and down inside.
    basin = turned([(1.72, 0.16), (1.72, 0.26), (1.66, 0.30), (1.62, 0.34), (1.60, 0.40), (1.60, 0.62), (1.63, 0.66),
                    (1.70, 0.70), (1.73, 0.74), (1.73, 0.81), (1.71, 0.83), (1.50, 0.83), (1.48, 0.81), (1.48, 0.3)], 8)
    baluster = lathed([[(0.34, 0.25), (0.34, 0.75)], bulge(0.28, 0.75, 0.83), [(0.27, 0.83), (0.17, 0.90), (0.14, 0.96)],
                       [(0.14, 0.96), (0.16, 1.02), (0.20, 1.10), (0.215, 1.18), (0.20, 1.26), (0.15, 1.34), (0.11, 1.42)],
                       bulge(0.115, 1.42, 1.47, 4)], 40)
    bowl = lathed([[(0.12, 1.47), (0.30, 1.50), (0.52, 1.56), (0.70, 1.66), (0.79, 1.76)], bulge(0.785, 1.76, 1.81),
                   [(0.785, 1.81), (0.73, 1.81)], [(0.73, 1.81), (0.70, 1.75), (0.6, 1.68), (0.40, 1.62)]], 64)
    finial = lathed([[(0.13, 1.6), (0.13, 1.80)], bulge(0.12, 1.80, 1.86, 4), [(0.12, 1.86), (0.07, 1.92), (0.06, 2.0)],
                     [(0.06, 2.0), (0.08, 2.06), (0.10, 2.09)], [(0.10, 2.09), (0.10, 2.12)], [(0.10, 2.12), (0, 2.14)]], 32)
    flat = g.geometry(step), g.geometry(basin)
    g.node(name="fountain", mesh=g.mesh((flat[0], materials["limestone"]), (flat[1], materials["limestone"]),
                                        *((g.geometry(s), materials["limestone"]) for s in (baluster, bowl, finial))),
           rotation=[0, round(math.sin(math.pi / 16), 7), 0, round(math.cos(math.pi / 16), 7)])
    g.node(name="water", mesh=g.mesh((g.geometry(water(1.53, 0.70, 1)), materials["water"]),
                                     (g.geometry(water(0.72, 1.765, 0.5)), materials["water"])))
    knot = smoothed(torus_knot(2, 3, 240, 24, 0.2).sized(0.42))
    g.node(name="knot", mesh=g.mesh((g.geometry(knot), materials["bronze"])), translation=[0, 2.60, 0],
           rotation=[round(x, 7) for x in quaternion([0, 1, 0], 35)])
