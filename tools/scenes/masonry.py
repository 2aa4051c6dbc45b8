"""What stones are cut to: prisms with bevelled edges, walls with an arch in them."""
import math

from scenes.shapes import Shape, joined, quad, sheet, without_slivers
from scenes.vectors import dot, unit


def inset(polygon, by):
    """A polygon, counterclockwise, with its edges moved inwards."""
    moved = []
    for i, p in enumerate(polygon):
        before, after = polygon[i - 1], polygon[(i + 1) % len(polygon)]
        edges = unit([p[0] - before[0], p[1] - before[1]]), unit([after[0] - p[0], after[1] - p[1]])
        inwards = [[-e[1], e[0]] for e in edges]
        share = by / (1 + dot(*inwards))
        moved.append([p[k] + share * (inwards[0][k] + inwards[1][k]) for k in (0, 1)])
    return moved


def prism(polygon, back, front, bevel=0, has_back=True):
    """A polygon of the x-y plane, counterclockwise and such that its first corner sees all of it, from z = back to
    front, with the edges of its ends bevelled."""
    small = inset(polygon, bevel) if bevel else polygon
    rings = [(polygon, back), (polygon, front)]
    if bevel:
        rings = [(polygon, back), (polygon, front - bevel), (small, front)]
    if bevel and has_back:
        rings = [(small, back), (polygon, back + bevel)] + rings[1:]
    n = len(polygon)
    points = [[*p, z] for ring, z in rings for p in ring]
    triangles = []
    for i in range(len(rings) - 1):
        for j in range(n):
            a, b = i * n + j, i * n + (j + 1) % n
            triangles += [(a, b, b + n), (a, b + n, a + n)]
    top = (len(rings) - 1) * n
    triangles += [(top, top + j, top + j + 1) for j in range(1, n - 1)]
    if has_back:
        triangles += [(0, j + 1, j) for j in range(1, n - 1)]
    return Shape(points, triangles)


def upright(shape):
    """What was made in the x-y plane, as a plan: y becomes -z, z becomes y."""
    return shape.mapped(lambda p: [p[0], p[2], -p[1]])


def rectangle(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def slab(x0, z0, x1, z1, bottom, top, bevel, has_back=False):
    """A stone that lies on the ground, its underside left away unless it is asked for."""
    return upright(prism(rectangle(x0, -z1, x1, -z0), bottom, top, bevel, has_back))


def block(half, bottom, top, bevel):
    """A square stone about the y axis."""
    return slab(-half, -half, half, half, bottom, top, bevel, True)


def half_circle(radius, springing, steps, lift=1):
    """From +x over the top to -x; `lift` makes half an ellipse of it."""
    return [[radius * math.cos(math.pi * i / steps), springing + lift * radius * math.sin(math.pi * i / steps)]
            for i in range(steps + 1)]


def ring_of_stones(inner, outer, count, back, front, first=0.0, last=math.pi, gap=0.012, bevel=0.012):
    """Wedges about the z axis, those of even and those of odd number."""
    stones = ([], [])
    step = (last - first) / count
    for i in range(count):
        def corner(radius, share):
            angle = first + step * (i + 0.5) + (step / 2 - gap / 2 / radius) * share
            return [radius * math.cos(angle), radius * math.sin(angle)]
        wedge = [corner(inner, 0), corner(inner, -1), corner(outer, -1), corner(outer, 0), corner(outer, 1),
                 corner(inner, 1)]
        stones[i % 2].append(prism(wedge, back, front, bevel))
    return [joined(*s) for s in stones]


def arched_wall(width, bottom, springing, radius, top, thickness, steps=24):
    """A wall about the plane z = 0 with a round arch in its middle that is open at the bottom."""
    arch = [[radius, bottom], *half_circle(radius, springing, steps), [-radius, bottom]]
    half, deep = width / 2, thickness / 2
    last = len(arch) - 1

    def face(z, towards):
        path = arch[::-1] if towards > 0 else arch
        above = sheet(1, last, lambda u, v: [path[round(v * last)][0], (path[round(v * last)][1], top)[round(u)], z])
        ends = [quad(*(c if towards > 0 else c[::-1])) for c in
                ([[x0, bottom, z], [x1, bottom, z], [x1, top, z], [x0, top, z]]
                 for x0, x1 in ((-half, -radius), (radius, half)))]
        return joined(without_slivers(above), *ends)

    def side(x, z):
        return quad([x, bottom, z], [x, bottom, -z], [x, top, -z], [x, top, z])
    under = sheet(1, last, lambda u, v: [*arch[round(v * last)], deep * (1 - 2 * round(u))])
    lid = quad([-half, top, deep], [half, top, deep], [half, top, -deep], [-half, top, -deep])
    return joined(face(deep, 1), face(-deep, -1), under, side(half, deep), side(-half, -deep), lid)


def moulding(profile, reach):
    """A profile of (out, y) pairs, from bottom to top, along a wall in the plane z = -reach that faces +z, mitred for
    walls at its ends that stand at right angles to it."""
    last = len(profile) - 1

    def point(u, v):
        out, y = profile[round(u * last)]
        return [(reach - out) * (2 * v - 1), y, out - reach]
    return sheet(last, 1, point)
