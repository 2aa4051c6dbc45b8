"""Small scenes that each stress one thing, and large ones that are not kept."""
import math

from scenes.gltf import Gltf
from scenes.shapes import Shape, box, joined, quad, torus_knot
from scenes.vectors import unit


def cornell():
    """A room of 2 x 2 x 2 with its front open."""
    g = Gltf()
    white, red, green = (g.material("white", 0.73, 0.73, 0.73), g.material("red", 0.63, 0.06, 0.05),
                         g.material("green", 0.14, 0.45, 0.09))
    a, b, c, d, e, f, h, i = [[x, y, z] for z in (-1, 1) for y in (0, 2) for x in (-1, 1)]
    shell = joined(quad(a, e, f, b), quad(c, d, i, h), quad(a, b, d, c))
    lamp = quad([-0.4, 1.99, -0.3], [0.4, 1.99, -0.3], [0.4, 1.99, 0.3], [-0.4, 1.99, 0.3])
    g.node(name="room", mesh=g.mesh((g.geometry(shell), white), (g.geometry(quad(a, c, h, e)), red),
                                    (g.geometry(quad(b, f, i, d)), green),
                                    (g.geometry(lamp), g.material("lamp", 1, 1, 1))))
    block = g.mesh((g.geometry(box([-0.3, 0, -0.3], [0.3, 0.6, 0.3])), white))
    g.node(name="short", mesh=block, translation=[0.35, 0, 0.35], rotation=[0, -0.1478094, 0, 0.9890159])
    g.node(name="tall", mesh=block, translation=[-0.35, 0, -0.3], rotation=[0, 0.1564345, 0, 0.9876883],
           scale=[1, 2, 1])
    g.camera("main", [0, 1, 4.4], [0, 1, 0], 39)
    return g.glb()


def grid():
    """All faces of 4 x 4 x 4 unit cubes, each once."""
    shapes = []
    for axis in range(3):
        for plane in range(5):
            for i in range(4):
                for j in range(4):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        corner = [0, 0, 0]
                        corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = plane, i + di, j + dj
                        corners.append(corner)
                    shapes.append(quad(*corners))
    g = Gltf()
    g.node(mesh=g.mesh((g.geometry(joined(*shapes)), g.material("grey", 0.7, 0.7, 0.7))))
    return g.glb()


def triangle():
    g = Gltf()
    g.node(mesh=g.mesh((g.geometry(Shape([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [(0, 1, 2)])), g.material("grey", 0.7, 0.7, 0.7))))
    return g.gltf()


def empty():
    g = Gltf()
    g.node(name="nothing")
    return g.gltf()


def needles():
    """Needles about the y axis: 64 of length 1 and width 1e-6, and 64 of length 10 and the same width."""
    points, triangles = [], []
    for i in range(128):
        angle, length = math.pi * i / 64, 1 if i < 64 else 10
        x, z = length * math.cos(angle), length * math.sin(angle)
        triangles.append((len(points), len(points) + 1, len(points) + 2))
        points += [[0, 0, 0], [x, 0.1, z], [x, 0.100001, z]]
    g = Gltf()
    g.node(mesh=g.mesh((g.geometry(Shape(points, triangles)), g.material("grey", 0.7, 0.7, 0.7))))
    return g.glb()


def shells():
    """Eight cubes about the origin, each one float larger than the one before."""
    g = Gltf()
    mesh = g.mesh((g.geometry(box([-1, -1, -1], [1, 1, 1])), g.material("grey", 0.7, 0.7, 0.7)))
    for i in range(8):
        size = 1 + i * 2.0 ** -23
        g.node(mesh=mesh, scale=[size, size, size])
    return g.glb()


def stack():
    """One unit square, five hundred times in the same place."""
    g = Gltf()
    square = quad([0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0])
    g.node(mesh=g.mesh((g.geometry(square._replace(triangles=square.triangles * 500)), g.material("grey", 0.7, 0.7, 0.7))))
    return g.glb()


def place_knot(g, knot, i, j, x, z):
    """Puts a knot on the ground at (x, z), turned in a way of its own, by the numbers of its row and column."""
    # The quaternion's length is not exactly 1, and need not be.
    q = unit([math.sin(1 + 7 * i + 3 * j), math.sin(2 + 5 * i - 2 * j), math.sin(3 + i + 11 * j), math.sin(4 - 3 * i + j)])
    g.node(mesh=knot, translation=[x, 1.3, z], rotation=[round(c, 7) for c in q])


def golden_knot(g, along=254, around=25):
    return g.mesh((g.geometry(torus_knot(2, 3, along, around, 0.2)), g.material("gold", 0.90, 0.56, 0.12)))


def field(rows, columns, along=254, around=25):
    """Knots (of 12,700 triangles) in rows on a ground, each turned its own way: small files, large scenes."""
    g = Gltf()
    sides = [x * 1.25 for x in (-columns, columns, -rows, rows)]
    ground = quad(*[[x, 0, z] for x, z in ((sides[0], sides[2]), (sides[0], sides[3]), (sides[1], sides[3]),
                                           (sides[1], sides[2]))])
    g.node(name="ground", mesh=g.mesh((g.geometry(ground), g.material("slate", 0.20, 0.24, 0.29))))
    knot = golden_knot(g, along, around)
    for i in range(rows):
        for j in range(columns):
            place_knot(g, knot, i, j, 2.5 * (j - columns / 2 + 0.5), 2.5 * (i - rows / 2 + 0.5))
    return g.glb()


def halls(count=5, side=4):
    """Halls one behind the other, each full of knots; the camera looks into the first, which hides the others."""
    g = Gltf()
    half, depth = 1.25 * side + 0.1, 2.5 * side + 0.2
    walls = [box([-half, -0.1, -count * depth], [half, 0, 0]), box([-half, 2.7, -count * depth], [half, 2.8, 0])]
    walls += [box([x - 0.1, 0, -count * depth], [x + 0.1, 2.7, 0]) for x in (-half, half)]
    walls += [box([-half, 0, -n * depth - 0.1], [half, 2.7, -n * depth]) for n in range(1, count + 1)]
    g.node(name="walls", mesh=g.mesh((g.geometry(joined(*walls)), g.material("plaster", 0.6, 0.6, 0.58))))
    knot = golden_knot(g)
    for n in range(count):
        for i in range(side):
            for j in range(side):
                place_knot(g, knot, n * side + i, j, 2.5 * (j - side / 2 + 0.5), -n * depth - 2.5 * (i + 0.5))
    g.camera("main", [0, 1.5, 8], [0, 1.3, 0], 45)
    return g.glb()
