"""The arcade: columns, arches, vaults, the wall behind, the cornice above."""
import math

from scenes.cloister.plan import (BACK, BAY, BAYS, COLUMNS, FLOOR, RADIUS, REACH, RIDGE, SIDES, SPRINGING, THICK,
                                  WALL_TOP, place)
from scenes.masonry import arched_wall, block, half_circle, moulding, prism, ring_of_stones, slab, upright
from scenes.shapes import flipped, joined, lathed, sheet, smoothed, without_slivers
from scenes.vectors import quaternion

COLUMN = SPRINGING - FLOOR  # height


def bulge(radius, bottom, top, steps=6):
    """The profile of a round moulding that stands out by half its height."""
    half = (top - bottom) / 2
    angles = [math.pi * (i / steps - 0.5) for i in range(steps + 1)]
    return [(radius + half * math.cos(a), bottom + half + half * math.sin(a)) for a in angles]


def capital_leaf(turn, bottom, height, lean):
    """A leaf on the bell of the capital, that curls over at its tip."""
    def point(u, v):
        across = 2 * v - 1
        width = 0.085 * (1 - 0.75 * u ** 3)
        bell = 0.172 + 0.055 * (bottom + height * u - 2.27) / 0.3
        out = bell + 0.012 + lean * u ** 3 - 0.012 * across * across
        y = bottom + height * (u - 0.25 * u ** 5)
        angle = turn + across * width / bell
        return [out * math.sin(angle), y, out * math.cos(angle)]
    return smoothed(sheet(7, 4, point))


def column(g, materials):
    shaft = [(0.180 - 0.025 * (i / 6) ** 2, 0.34 + 1.86 * i / 6) for i in range(7)]
    bell = [(0.160 + 0.10 * (i / 5) ** 2.2, 2.27 + 0.29 * i / 5) for i in range(6)]
    round_parts = lathed([bulge(0.225, 0.12, 0.21), [(0.225, 0.21), (0.205, 0.215), (0.195, 0.24), (0.205, 0.265)],
                          bulge(0.195, 0.265, 0.32), [(0.195, 0.32), (0.185, 0.325), shaft[0]], shaft,
                          bulge(0.155, 2.2, 2.25, 4), [(0.155, 2.25), bell[0]], bell, [bell[-1], (0.05, 2.56)]], 28)
    square = joined(block(0.29, 0, 0.12, 0.012), block(0.27, 2.555, 2.63, 0.01), block(0.31, 2.63, COLUMN, 0.014))
    leaves = [capital_leaf(math.pi * (i + 0.5 * row) / 4, 2.275 + 0.11 * row, 0.17, 0.075 + 0.01 * row)
              for row in (0, 1) for i in range(8)]
    return g.mesh(materials.part(round_parts, "limestone"), materials.part(square, "limestone"),
                  materials.part(joined(*leaves), "limestone leaf"))


def pier(g, materials):
    """In the corners of the court."""
    h, c = 0.29, 0.07
    plan = [[h, -h + c], [h, h - c], [h - c, h], [-h + c, h], [-h, h - c], [-h, -h + c], [-h + c, -h], [h - c, -h]]
    shaft = upright(prism(plan, 0.22, 2.56))
    stones = joined(block(0.36, 0, 0.16, 0.015), block(0.33, 0.16, 0.22, 0.012), shaft,
                    block(0.32, 2.555, 2.63, 0.01), block(0.36, 2.63, COLUMN, 0.014))
    return g.mesh(materials.part(stones, "limestone"))


def bay(g, materials):
    """An arch between two columns, its stones of two colours in turn."""
    wall = arched_wall(BAY, SPRINGING - 0.06, SPRINGING, RADIUS, WALL_TOP, THICK)
    pale, rose = (s.moved(0, SPRINGING, 0) for s in ring_of_stones(RADIUS - 0.02, RADIUS + 0.235, 15, -THICK / 2 - 0.03,
                                                                   THICK / 2 + 0.03))
    return g.mesh(materials.part(joined(wall, pale), "limestone"), materials.part(rose, "rose stone"))


def medallion(g, materials):
    """A glazed disc in a rim, facing +z."""
    rim = lathed([[(0.25, 0), (0.25, 0.03)],
                  [(0.25, 0.03), (0.24, 0.045), (0.22, 0.05), (0.20, 0.045), (0.19, 0.02)]], 32)
    disc = lathed([[(0.195, 0.02), (0.15, 0.03), (0.08, 0.037), (0, 0.04)]], 32)
    boss = lathed([[(0.07, 0.03), (0.065, 0.05), (0.04, 0.065), (0, 0.07)]], 24)
    towards = quaternion([1, 0, 0], 90)
    return g.mesh(materials.part(joined(rim.turned(towards), boss.turned(towards)), "glaze white"),
                  materials.part(disc.turned(towards), "glaze blue"))


def groin_vault(half_x, half_z, rise, steps=20):
    """Two half barrels that meet in two diagonals, seen from below; it springs from y = 0."""
    def panel(swapped, sign):
        def point(u, v):
            s = math.sin(math.pi * (u - 0.5))
            t = sign * (abs(s) + (1 - abs(s)) * v)
            y = rise * math.cos(math.pi * (u - 0.5))
            return [half_x * s, y, half_z * t] if swapped else [half_x * t, y, half_z * s]
        shape = without_slivers(sheet(steps, 1, point))
        if swapped != (sign > 0):
            return smoothed(shape)
        return smoothed(flipped(shape))
    return joined(*(panel(swapped, sign) for swapped in (False, True) for sign in (1, -1)))


def rib(half, rise, width, depth=0.2, steps=24):
    """Half an ellipse that stands across the arcade, in the plane x = 0, below the vaults."""
    outer = half_circle(half, 0, steps, rise / half)
    inner = half_circle(half - depth, 0, steps, (rise - depth) / (half - depth))

    def strip(first, second, x0, x1):
        def point(u, v):
            z, y = (first, second)[round(u)][round(v * steps)]
            return [(x0, x1)[round(u)], y, -z]
        return sheet(1, steps, point)
    w = width / 2
    return joined(strip(inner, inner, w, -w), strip(outer, inner, w, w), strip(inner, outer, -w, -w))


def corbel(g, materials):
    """Carries a rib at the wall; its back is at z = 0."""
    profile = [[-0.02, 0], [0.06, 0], [0.10, 0.05], [0.22, 0.16], [0.24, 0.22], [0.24, 0.30], [-0.02, 0.30]]
    part = prism(profile, -0.2, 0.2, 0.01)
    return g.mesh(materials.part(part.turned(quaternion([0, 1, 0], -90)), "limestone"))


def back_wall():
    """The wall behind the arcade and its coping, one side of it, so that four of them close at the corners."""
    wall = slab(-BACK - 0.4, -BACK - 0.4, BACK, -BACK, -0.2, RIDGE, 0, True)
    return wall, slab(-BACK - 0.5, -BACK - 0.5, BACK - 0.1, -BACK + 0.1, RIDGE, RIDGE + 0.14, 0.03, True)


def dado(g, materials):
    """The painted foot of the wall, and the moulding that ends it."""
    paint = moulding([(0, FLOOR - 0.01), (0.015, FLOOR - 0.01), (0.015, 1.36), (0, 1.36)], BACK)
    edge = moulding([(0, 1.34), (0.04, 1.35), (0.055, 1.38), (0.055, 1.41), (0.03, 1.43), (0, 1.45)], BACK)
    skirting = moulding([(0, FLOOR - 0.01), (0.05, FLOOR - 0.01), (0.05, 0.50), (0.035, 0.53), (0, 0.54)], BACK)
    return g.mesh(materials.part(paint, "dado"), materials.part(joined(edge, skirting), "limestone"))


def cornice(g, materials):
    d = THICK / 2
    rail = moulding([(d, 4.66), (d + 0.03, 4.67), (d + 0.04, 4.70), (d + 0.04, 4.74), (d, 4.75)], REACH)
    crown = moulding([(d, WALL_TOP - 0.01), (d + 0.05, WALL_TOP), (d + 0.05, 4.97), (d + 0.10, 4.985), (d + 0.20, 5.04),
                      (d + 0.23, 5.09), (d + 0.23, 5.15), (d + 0.27, 5.16), (d + 0.27, 5.2), (-0.4, 5.2)], REACH)
    spacing = 0.2
    count = int((REACH - 0.4) / spacing)
    teeth = [slab(x - 0.05, d + 0.045 - REACH, x + 0.05, d + 0.135 - REACH, 4.85, 4.965, 0.006, True)
             for x in (spacing * (i + 0.5) for i in range(-count, count))]
    return g.mesh(materials.part(joined(rail, crown, *teeth), "limestone"))


def add_arcade(g, materials):
    depth = BACK - REACH - THICK / 2
    middle = -(BACK + REACH + THICK / 2) / 2
    rise = SPRINGING + 1.4
    over = g.mesh(materials.part(groin_vault(BAY / 2, depth / 2, 1.4), "vault"))
    over_corner = g.mesh(materials.part(groin_vault(depth / 2, depth / 2, 1.4), "vault"))
    ribs = [g.mesh(materials.part(rib(depth / 2, 1.405, width), "limestone")) for width in (0.3, 0.5)]
    wall, coping = back_wall()
    walls = g.mesh(materials.part(wall, "plaster"), materials.part(coping, "limestone"))
    meshes = [f(g, materials) for f in (column, pier, bay, medallion, corbel, dado, cornice)]
    one_column, one_pier, one_bay, one_medallion, one_corbel, feet, top = meshes
    for side in SIDES:
        place(g, walls, side, 0, 0, 0)
        place(g, feet, side, 0, 0, 0)
        place(g, top, side, 0, 0, 0)
        place(g, one_pier, side, -REACH, FLOOR, -REACH)
        place(g, over_corner, side, -REACH - THICK / 2 - depth / 2, SPRINGING, middle)
        for x in BAYS:
            place(g, one_bay, side, x, 0, -REACH)
            place(g, over, side, x, SPRINGING, middle)
        for x in COLUMNS:
            place(g, one_column, side, x, FLOOR, -REACH)
            place(g, one_medallion, side, x, 4.22, -REACH + THICK / 2)
        for x in (*COLUMNS, -REACH - 0.1, REACH + 0.1):
            place(g, ribs[x not in COLUMNS], side, x, SPRINGING, middle)
            place(g, one_corbel, side, x, SPRINGING - 0.3, -BACK)
