"""What one walks on: the paved court, its steps, the marble of the arcade."""
from random import Random

from scenes.cloister.plan import BACK, FLOOR, SIDES, place
from scenes.masonry import slab
from scenes.shapes import joined, quad

EDGE = 6.3     # of the court's paving
STEP = 6.65
MARBLE = 7.2
TILE = 0.4


def level(half, y):
    return quad([-half, y, -half], [-half, y, half], [half, y, half], [half, y, -half])


def paving():
    """Rows of stones of any length, by tone."""
    random = Random(11)
    tones = ([], [], [], [])
    rows = 22
    deep = 2 * EDGE / rows
    for row in range(rows):
        z, x = -EDGE + row * deep, -EDGE
        while x < EDGE:
            end = x + 0.5 + 0.6 * random.random()
            if end > EDGE - 0.4:
                end = EDGE
            # The fountain stands on those in the middle.
            if max(abs(z), abs(z + deep)) > 1.5 or max(abs(x), abs(end)) > 1.5:
                tone = tones[(0, 0, 0, 1, 1, 2, 2, 3)[int(8 * random.random())]]
                top = 0.006 * (random.random() - 0.5)
                tone.append(slab(x + 0.006, z + 0.006, end - 0.006, z + deep - 0.006, -0.04, top, 0.009))
            x = end
    return [joined(*stones) for stones in tones]


def kerb(inner, outer, bottom, top, stones):
    """Long stones along one side, so that four of them close at the corners."""
    length = (inner + outer) / stones
    ends = [-outer + i * length for i in range(stones + 1)]
    return joined(*(slab(left + 0.004, -outer, right - 0.004, -inner, bottom, top, 0.018)
                    for left, right in zip(ends, ends[1:])))


def marble():
    """The squares of the arcade's floor, light and dark."""
    squares = ([], [])
    count = round(2 * BACK / TILE)
    for i in range(count):
        for j in range(count):
            x, z = -BACK + i * TILE, -BACK + j * TILE
            if max(abs(x + TILE / 2), abs(z + TILE / 2)) > MARBLE:
                squares[(i + j) % 2].append(quad([x, FLOOR, z], [x, FLOOR, z + TILE], [x + TILE, FLOOR, z + TILE],
                                                 [x + TILE, FLOOR, z]))
    return [joined(*s) for s in squares]


def add_ground(g, materials):
    g.node(name="meadow", mesh=g.mesh(materials.part(level(26, -0.1), "meadow")))
    names = ("paving light", "paving warm", "paving grey", "paving dark")
    g.node(name="paving", mesh=g.mesh(*(materials.part(stones, name) for stones, name in zip(paving(), names)),
                                      materials.part(level(EDGE + 0.1, -0.018), "mortar")))
    light, dark = marble()
    g.node(name="marble", mesh=g.mesh(materials.part(light, "cream marble"),
                                      materials.part(dark, "red marble")))
    steps = joined(kerb(EDGE, STEP, -0.04, FLOOR / 2, 9), kerb(STEP, MARBLE, -0.04, FLOOR, 10))
    border = g.mesh(materials.part(steps, "limestone"))
    for side in SIDES:
        place(g, border, side, 0, 0, 0)
