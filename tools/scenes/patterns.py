"""Patterns that textures are made of. Whole numbers only, so that they are the same on every machine; each repeats."""
import math


def hashed(*numbers):
    """A number of 8 bits."""
    h = 0
    for n in numbers:
        h = (h ^ n) * 0x9E3779B1 & 0xFFFFFFFF
        h = (h ^ h >> 15) * 0x2C1B3C6D & 0xFFFFFFFF
        h ^= h >> 13
    return h & 255


def noise(size, cells, seed):
    """Rows of values from 0 to 255, smooth between so many cells a side."""
    step = size // cells
    eased = [t * t * (3 * step - 2 * t) * 256 // step ** 3 for t in range(step)]
    corners = [[hashed(seed, x % cells, y % cells) for x in range(cells + 1)] for y in range(cells + 1)]
    rows = []
    for y in range(size):
        above, below, t = corners[y // step], corners[y // step + 1], eased[y % step]
        column = [a * (256 - t) + b * t for a, b in zip(above, below)]
        rows.append([(column[x // step] * (256 - eased[x % step]) + column[x // step + 1] * eased[x % step]) >> 16
                     for x in range(size)])
    return rows


def mixed(*weighted):
    """The sum of patterns, each with a weight of so many parts of 16."""
    weights = [weight for weight, _ in weighted]
    return [[sum(w * v for w, v in zip(weights, values)) >> 4 for values in zip(*rows)]
            for rows in zip(*(pattern for _, pattern in weighted))]


def tinted(pattern, low, high):
    """Colours from `low` to `high` in 16 steps."""
    steps = [tuple(a + (b - a) * i // 15 for a, b in zip(low, high)) for i in range(16)]
    return [[steps[max(0, min(15, v >> 4))] for v in row] for row in pattern]


def spread(pattern):
    """With its contrast doubled about the middle."""
    return [[max(0, min(255, 2 * v - 128)) for v in row] for row in pattern]


def normal_map(heights, strength):
    """Of a height field, in steps, so that there are few colours; strength in parts of 256."""
    size = len(heights)

    def slope(difference):
        return max(-7, min(7, (difference * strength // 256 + 3) // 6)) * 6
    rows = []
    for y in range(size):
        above, here, below = heights[y - 1], heights[y], heights[(y + 1) % size]
        rows.append([])
        for x in range(size):
            # Rows of a picture run down, and in tangent space y runs up.
            dx, dy = slope(here[(x + 1) % size] - here[x - 1]), slope(above[x] - below[x])
            rows[-1].append((128 - dx, 128 - dy, 128 + math.isqrt(127 * 127 - dx * dx - dy * dy)))
    return rows
