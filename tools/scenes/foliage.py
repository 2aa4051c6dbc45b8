"""Leaves, and what many of them make. Random directions come from a seed, so that a plant is the same each time."""
import math

from scenes.shapes import Shape, joined
from scenes.vectors import added, cross, scaled, unit


def anywhere(random):
    """A direction, all alike."""
    y, angle = 2 * random.random() - 1, 2 * math.pi * random.random()
    r = math.sqrt(1 - y * y)
    return [r * math.cos(angle), y, r * math.sin(angle)]


def leaf(foot, along, facing, length, width, fold=0.25):
    """Four triangles from the foot to the tip, folded along the middle; its upper side is where `facing` is."""
    along = unit(along)
    side = unit(cross(along, facing))
    up = cross(side, along)

    def at(far, across, high):
        beside = added(scaled(side, width * across), scaled(up, width * high))
        return added(foot, added(scaled(along, length * far), beside))
    points = [at(0, 0, 0), at(0.45, 0.5, fold), at(1, 0, 0), at(0.45, -0.5, fold), at(0.5, 0, 0)]
    return Shape(points, [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])


def needle(foot, along, facing, length, width):
    """Two triangles."""
    side = scaled(unit(cross(along, facing)), width / 2)
    ahead = added(foot, scaled(along, 0.45 * length))
    points = [foot, added(ahead, side), added(foot, scaled(along, length)), added(ahead, scaled(side, -1))]
    return Shape(points, [(0, 1, 2), (0, 2, 3)])


def clump(random, centre, radii, count, length, width, droop, shape=leaf):
    """Leaves near the surface of an ellipsoid, which look outwards and hang a little."""
    leaves = []
    for _ in range(count):
        out = anywhere(random)
        reach = 0.55 + 0.45 * random.random()
        foot = [c + r * o * reach for c, r, o in zip(centre, radii, out)]
        along = added(scaled(out, 0.5), added(scaled(anywhere(random), 0.8), [0, -droop, 0]))
        size = 0.75 + 0.5 * random.random()
        leaves.append(shape(foot, along, added(out, [0, 0.6, 0]), length * size, width * size))
    return joined(*leaves)
