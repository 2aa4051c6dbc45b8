"""Vectors as lists of numbers, and rotations as quaternions (x, y, z, w)."""
import math


def added(a, b):
    return [x + y for x, y in zip(a, b)]


def taken(a, b):
    return [x - y for x, y in zip(a, b)]


def scaled(v, s):
    return [x * s for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def quaternion(axis, degrees):
    half = math.radians(degrees) / 2
    return [*scaled(unit(axis), math.sin(half)), math.cos(half)]


def product(p, q):
    """The rotation q, then p."""
    return [*added(cross(p[:3], q[:3]), added(scaled(q[:3], p[3]), scaled(p[:3], q[3]))),
            p[3] * q[3] - dot(p[:3], q[:3])]


def rotated(v, q):
    twice = scaled(cross(q[:3], v), 2)
    return added(v, added(scaled(twice, q[3]), cross(q[:3], twice)))
