"""The roof over the arcade: barrel tiles in rows on a slope, four slopes that meet in valleys."""
import math
from random import Random

from scenes.cloister.plan import BACK, EAVES, REACH, RIDGE, SIDES, place
from scenes.masonry import moulding
from scenes.shapes import Shape, joined, sheet, smoothed
from scenes.vectors import quaternion

SPACING = 0.25
FIRST = 0.56          # how far the tiles reach into the court
RUN = BACK + FIRST - REACH
ROWS = 10
PITCH = math.atan2(RIDGE - EAVES, RUN)
STEP = RUN / math.cos(PITCH) / ROWS
TONES = ("tile", "tile pale", "tile dark")


def tile():
    """Half a cone that opens towards +z, closed at that end, as eaves are with mortar."""
    def point(u, v):
        radius = 0.112 - 0.022 * u
        angle = math.pi * (v - 0.5)
        return [radius * math.sin(angle), 0.028 * (1 - u) + radius * math.cos(angle), (0.5 - u) * (STEP + 0.05)]
    back = sheet(1, 8, lambda u, v: point(1 - u, 1 - v))
    shell = smoothed(sheet(1, 8, lambda u, v: point(u, v)))
    rim = [point(0, j / 8) for j in range(9)]
    cap = Shape(rim, [(0, j + 1, j) for j in range(1, 8)], [[0, 0, 1]] * 9)
    return shell, cap


def tile_column(rows, seed):
    """Tiles up the slope from its foot at the origin, by their tones."""
    random = Random(seed)
    by_tone = ([], [], [])
    shell, cap = tile()
    for row in range(ROWS - rows, ROWS):
        tone = (0, 0, 0, 1, 1, 2)[int(6 * random.random())]
        swing = quaternion([0, 1, 0], 3 * (random.random() - 0.5))
        for part in (shell, cap):
            turned = part.turned(swing).moved(0.014 * (random.random() - 0.5), 0, -(row + 0.5) * STEP)
            by_tone[tone].append(turned.turned(quaternion([1, 0, 0], math.degrees(PITCH))))
    return [joined(*parts) if parts else None for parts in by_tone]


def add_roof(g, materials):
    """Columns of tiles begin where the valley crosses them; a deck lies below."""
    meshes = {}

    def mesh_of(rows, variant):
        if (rows, variant) not in meshes:
            parts = zip(tile_column(rows, 100 * rows + variant), TONES)
            meshes[rows, variant] = g.mesh(*(materials.part(shape, tone) for shape, tone in parts if shape))
        return meshes[rows, variant]
    deck = moulding([(0.3, EAVES - 0.03), (FIRST - 0.02, EAVES - 0.03), (FIRST - 0.02, EAVES), (REACH - BACK, RIDGE)],
                    REACH)
    deck = g.mesh(materials.part(deck, "tile dark"))
    random = Random(7)
    columns = int(BACK / SPACING)
    for side in SIDES:
        place(g, deck, side, 0, 0, 0)
        for i in range(-columns, columns + 1):
            x = i * SPACING
            covered = max(0.0, abs(x) - (REACH - FIRST))
            rows = ROWS - math.ceil(covered / RUN * ROWS - 0.6)
            if rows > 0:
                variant = int(5 * random.random()) if rows >= ROWS else 0
                place(g, mesh_of(min(rows, ROWS), variant), side, x, EAVES, FIRST - REACH)
