"""The plan: a square court with an arcade of five bays on each side. Metres, y up; a side is described where it
faces +z, its columns in the plane z = -REACH, and put in four places."""
from scenes.vectors import product, quaternion, rotated

REACH = 7.0          # from the middle of the court to the axes of the columns
BAY = 2.8
BAYS = [BAY * (i - 2) for i in range(5)]
COLUMNS = [BAY * (i - 1.5) for i in range(4)]
FLOOR = 0.36         # of the arcade, above the court
SPRINGING = 3.1      # of arches and vaults
RADIUS = 1.15
WALL_TOP = 4.8
THICK = 0.44         # of the arcade's wall
BACK = 10.4          # from the middle of the court to the wall behind the arcade
EAVES = 5.22
RIDGE = 7.05

SIDES = range(4)     # far, left, near, right as one looks along -z


def turn(side):
    return quaternion([0, 1, 0], 90 * side)


def place(g, mesh, side, x, y, z, rotation=None, name=None, scale=None):
    """A node with a mesh, at a place given as the side sees it."""
    fields = {"mesh": mesh, "translation": [round(c, 5) + 0.0 for c in rotated([x, y, z], turn(side))]}
    q = product(turn(side), rotation) if rotation else turn(side)
    if side or rotation:
        fields["rotation"] = [round(c, 7) + 0.0 for c in q]
    if scale:
        fields["scale"] = [scale] * 3
    if name:
        fields["name"] = name
    return g.node(**fields)
