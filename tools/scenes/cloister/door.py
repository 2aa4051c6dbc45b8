"""Doors of planks in frames of stone."""
import math

from scenes.cloister.plan import BACK, FLOOR, place
from scenes.masonry import prism, rectangle, ring_of_stones
from scenes.shapes import joined

HALF = 0.62
SPRINGING = 1.75
PLANKS = 8


def plank(i):
    """One of the upright boards, cut round at its top."""
    width = 2 * HALF / PLANKS
    left, right = -HALF + i * width + 0.003, -HALF + (i + 1) * width - 0.003
    tops = [[x, SPRINGING + math.sqrt(HALF * HALF - x * x)] for x in (right, (left + right) / 2, left)]
    return prism([[left, 0], [right, 0], *tops], -0.02, 0.08, 0.006)


def door(g, materials):
    """Faces +z from the plane z = 0, on the floor."""
    pale, rose = (s.moved(0, SPRINGING, 0) for s in ring_of_stones(HALF, HALF + 0.26, 11, -0.02, 0.14))
    course = SPRINGING / 5
    jambs = []
    for k in range(5):
        wide = HALF + 0.20 + 0.10 * (k % 2)
        for left, right in ((-wide, -HALF), (HALF, wide)):
            stone = rectangle(left, k * course + 0.004, right, (k + 1) * course - 0.004)
            jambs.append(prism(stone, -0.02, 0.14, 0.012))
    straps = [prism(rectangle(-HALF + 0.02, y - 0.035, HALF - 0.02, y + 0.035), 0.06, 0.09, 0.004) for y in (0.4, 1.45)]
    nails = [prism(rectangle(x - 0.018, y - 0.018, x + 0.018, y + 0.018), 0.08, 0.105, 0.01)
             for y in (0.4, 1.45) for x in (HALF * (2 * (i + 0.5) / PLANKS - 1) for i in range(PLANKS))]
    return g.mesh(materials.part(joined(*(plank(i) for i in range(PLANKS))), "wood"),
                  materials.part(joined(pale, *jambs), "limestone"), materials.part(rose, "rose stone"),
                  materials.part(joined(*straps, *nails), "iron"))


def add_doors(g, materials):
    """In the middle of the far wall, and at both ends of the arcade there."""
    one = door(g, materials)
    end = (BACK + 7.2) / 2
    for side, x in ((0, 0), (3, -end), (1, end)):
        place(g, one, side, x, FLOOR, -BACK, name="door")
