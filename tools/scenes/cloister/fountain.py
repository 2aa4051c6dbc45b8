"""The fountain: an eight-sided basin, a bowl on a baluster, a bronze knot."""
import math

from scenes.cloister.arcade import bulge
from scenes.masonry import prism, rectangle
from scenes.shapes import joined, lathed, sheet, smoothed, torus_knot, turned
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


def panel():
    """A glazed panel on each side of the basin, in a frame of the basin's stone."""
    apothem = 1.60 * math.cos(math.pi / 8)
    tile = prism(rectangle(-0.42, 0.44, 0.42, 0.60), apothem - 0.01, apothem + 0.012, 0.008)
    return joined(*(tile.turned(quaternion([0, 1, 0], 45 * k + 22.5)) for k in range(8)))


def jet(turn):
    """Water that falls from the lip of the bowl into the basin, thinner as it gets faster."""
    def point(u, v):
        fall = 1.16 * u * u
        out, y = 0.76 + 0.50 * u, 1.83 - fall + 0.06 * math.sin(math.pi * u)
        radius, angle = 0.011 - 0.004 * u, 2 * math.pi * v
        return [radius * math.sin(angle), y, out + radius * math.cos(angle)]
    return smoothed(sheet(16, 6, lambda u, v: point(1 - u, v), (False, True))).turned(quaternion([0, 1, 0], turn))


def add_fountain(g, materials):
    step = turned([(2.35, -0.05), (2.35, 0.12), (2.32, 0.15), (2.05, 0.15)], 8)
    # Eight sides: out over the mouldings, over the rim, and down inside.
    basin = turned([(1.72, 0.14), (1.72, 0.26), (1.66, 0.30), (1.62, 0.34), (1.60, 0.40), (1.60, 0.62), (1.63, 0.66),
                    (1.70, 0.70), (1.73, 0.74), (1.73, 0.81), (1.71, 0.83), (1.50, 0.83), (1.48, 0.81), (1.48, 0.3)], 8)
    baluster = lathed([[(0.34, 0.25), (0.34, 0.75)], bulge(0.28, 0.75, 0.83),
                       [(0.27, 0.83), (0.17, 0.90), (0.14, 0.96)],
                       [(0.14, 0.96), (0.16, 1.02), (0.20, 1.10), (0.215, 1.18), (0.20, 1.26), (0.15, 1.34),
                        (0.11, 1.42)],
                       bulge(0.115, 1.42, 1.47, 4)], 40)
    bowl = lathed([[(0.12, 1.47), (0.30, 1.50), (0.52, 1.56), (0.70, 1.66), (0.79, 1.76)], bulge(0.785, 1.76, 1.81),
                   [(0.785, 1.81), (0.73, 1.81)], [(0.73, 1.81), (0.70, 1.75), (0.6, 1.68), (0.40, 1.62)]], 64)
    finial = lathed([[(0.13, 1.6), (0.13, 1.78)], bulge(0.12, 1.78, 1.83, 4),
                     [(0.12, 1.83), (0.07, 1.88), (0.10, 1.93)],
                     [(0.10, 1.93), (0.10, 1.95)], [(0.10, 1.95), (0, 1.96)]], 32)
    parts = [materials.part(s, "limestone") for s in (joined(step, basin), joined(baluster, bowl, finial))]
    g.node(name="fountain", mesh=g.mesh(*parts, materials.part(panel(), "glaze blue")),
           rotation=[round(x, 7) for x in quaternion([0, 1, 0], 22.5)])
    g.node(name="water", mesh=g.mesh(materials.part(water(1.53, 0.70, 1), "water"),
                                     materials.part(water(0.72, 1.765, 0.5), "water"),
                                     materials.part(joined(*(jet(45 * k) for k in range(8))), "falling water")))
    knot = smoothed(torus_knot(2, 3, 240, 24, 0.2).sized(0.42))
    g.node(name="knot", mesh=g.mesh(materials.part(knot, "bronze")), translation=[0, 2.41, 0],
           rotation=[round(x, 7) for x in quaternion([0, 1, 0], 35)])
