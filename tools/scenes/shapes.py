"""Shapes: triangles over points, and what their corners have beside a place."""
import math
from typing import NamedTuple

from scenes.vectors import added, cross, rotated, taken, unit


class Shape(NamedTuple):
    points: list
    triangles: list
    normals: list = None
    texcoords: list = None
    colours: list = None

    def mapped(self, place, direct=None):
        """With each point, and each normal if there are any, where a function puts it."""
        normals = self.normals and [direct(n) if direct else n for n in self.normals]
        return self._replace(points=[place(p) for p in self.points], normals=normals)

    def moved(self, x, y, z):
        return self.mapped(lambda p: added(p, (x, y, z)))

    def sized(self, factor):
        return self.mapped(lambda p: [x * factor for x in p])

    def turned(self, q):
        return self.mapped(lambda p: rotated(p, q), lambda n: rotated(n, q))


def sheet(rows, columns, point, wrap=(False, False)):
    """A grid of quads: point(u, v) for u, v in [0, 1]; `wrap` joins the last row (column) to the first. Its front is
    where v turns to u counterclockwise."""
    down, across = rows + (not wrap[0]), columns + (not wrap[1])
    points = [point(i / rows, j / columns) for i in range(down) for j in range(across)]
    triangles = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * across + j, i * across + (j + 1) % across
            c, d = (i + 1) % down * across + j, (i + 1) % down * across + (j + 1) % across
            triangles += [(a, b, d), (a, d, c)]
    return Shape(points, triangles)


def flipped(shape):
    """With its front where its back was."""
    return shape._replace(triangles=[(a, c, b) for a, b, c in shape.triangles])


def joined(*shapes):
    """One shape of many, all of which have the same attributes."""
    triangles, count = [], 0
    for shape in shapes:
        triangles += [tuple(i + count for i in triple) for triple in shape.triangles]
        count += len(shape.points)
    columns = [[x for column in group for x in column] if group and group[0] is not None else None
               for group in zip(*((s.points, s.normals, s.texcoords, s.colours) for s in shapes))]
    points, normals, texcoords, colours = columns or ([], None, None, None)
    return Shape(points, triangles, normals, texcoords, colours)


def face_normal(a, b, c):
    """As long as twice the triangle's area."""
    return cross(taken(b, a), taken(c, a))


def without_slivers(shape):
    """Without triangles that have (next to) no area, where a sheet comes together in a point."""
    def area(t):
        return sum(x * x for x in face_normal(*(shape.points[i] for i in t)))
    return shape._replace(triangles=[t for t in shape.triangles if area(t) > 1e-18])


def smoothed(shape):
    """With normals: at each point the mean of those of the triangles about it, by area."""
    sums = {}
    places = [tuple(round(x, 6) for x in p) for p in shape.points]
    for t in shape.triangles:
        n = face_normal(*(shape.points[i] for i in t))
        for place in {places[i] for i in t}:
            sums[place] = added(sums.get(place, (0, 0, 0)), n)
    return shape._replace(normals=[unit(sums.get(place, (0, 1, 0))) for place in places])


def box_mapped(shape, size):
    """With texture coordinates: each triangle as seen along the axis that it faces, a texture every `size`. Points are
    doubled where triangles see the texture along different axes."""
    numbers, texcoords, triangles = {}, [], []
    for t in shape.triangles:
        n = [abs(x) for x in face_normal(*(shape.points[i] for i in t))]
        axis = n.index(max(n))
        for i in t:
            if (i, axis) not in numbers:
                x, y, z = shape.points[i]
                u, v = ((z, -y), (x, z), (x, -y))[axis]
                numbers[i, axis] = len(texcoords)
                texcoords.append([u / size, v / size])
        triangles.append(tuple(numbers[i, axis] for i in t))
    normals = shape.normals and [shape.normals[i] for i, _ in numbers]
    return Shape([shape.points[i] for i, _ in numbers], triangles, normals, texcoords)


def sphere(rows, columns):
    """Of radius 1 about (0, 1, 0): it stands on the ground."""
    def point(u, v):
        theta, phi = math.pi * u, 2 * math.pi * v
        return [math.sin(theta) * math.sin(phi), 1 + math.cos(theta), math.sin(theta) * math.cos(phi)]
    points, triangles = flipped(sheet(rows, columns, point, (False, True)))[:2]
    first, last = range(columns), range(rows * columns, (rows + 1) * columns)
    # The poles' rows of triangles without area are left away.
    return Shape(points, [t for t in triangles if sum(i in first for i in t) < 2 and sum(i in last for i in t) < 2])


def turned(profile, columns):
    """A profile of (radius, height) pairs, from bottom to top, turned about the y axis, closed by flat ends."""
    rows = len(profile)
    points = [[r * math.sin(2 * math.pi * j / columns), y, r * math.cos(2 * math.pi * j / columns)]
              for r, y in profile for j in range(columns)]
    triangles = []
    for i in range(rows - 1):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            triangles += [(a, b, b + columns), (a, b + columns, a + columns)]
    top = (rows - 1) * columns
    triangles += [(0, j + 1, j) for j in range(1, columns - 1)]
    triangles += [(top, top + j, top + j + 1) for j in range(1, columns - 1)]
    return Shape(points, triangles)


def lathed(lines, columns):
    """Profiles of (radius, height) pairs turned about the y axis, smooth along each line, with an edge between them.
    What a line has on its left when it goes up is inside."""
    def line_sheet(line):
        def point(u, v):
            r, y = line[round(u * (len(line) - 1))]
            return [r * math.sin(2 * math.pi * v), y, r * math.cos(2 * math.pi * v)]
        return smoothed(without_slivers(sheet(len(line) - 1, columns, point, (False, True))))
    return joined(*(line_sheet(line) for line in lines))


def box(lo, hi):
    points = [[(lo, hi)[i >> a & 1][a] for a in range(3)] for i in range(8)]
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Shape(points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def quad(a, b, c, d):
    return Shape([a, b, c, d], [(0, 1, 2), (0, 2, 3)])


def torus_knot(p, q, rows, columns, radius):
    """A tube around the (p, q) torus knot, its frame made from the curve and its neighbour."""
    def curve(t):
        r = 2 + math.cos(q * t)
        return [r * math.cos(p * t) / 3, r * math.sin(p * t) / 3, math.sin(q * t) / 3]

    def point(u, v):
        t, angle = 2 * math.pi * u, 2 * math.pi * v
        here, ahead = curve(t), curve(t + 0.01)
        tangent = unit([b - a for a, b in zip(here, ahead)])
        side = unit(cross(tangent, [b + a for a, b in zip(here, ahead)]))
        over = cross(side, tangent)
        return [h + radius * (math.cos(angle) * o + math.sin(angle) * s) for h, o, s in zip(here, over, side)]
    return sheet(rows, columns, point, (True, True))
