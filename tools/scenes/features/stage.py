"""What scenes that show a feature of glTF have in common."""
from scenes.gltf import Gltf
from scenes.shapes import quad, smoothed, sphere
from scenes.vectors import quaternion


def stage(half=10.0):
    """A document with a floor."""
    g = Gltf(decimals=5)
    floor = quad([-half, 0, -half], [-half, 0, half], [half, 0, half], [half, 0, -half])
    g.node(name="floor", mesh=g.mesh((g.geometry(floor), g.material("floor", 0.55, 0.53, 0.50, 0, 0.8))))
    return g


def panel(width, height, low=(0, 0), high=(1, 1)):
    """Stands on the floor and faces +z, with texture coordinates from its top left corner to its bottom right one."""
    w = width / 2
    shape = quad([-w, 0, 0], [w, 0, 0], [w, height, 0], [-w, height, 0])
    return shape._replace(texcoords=[[low[0], high[1]], [high[0], high[1]], [high[0], low[1]], [low[0], low[1]]])


def ball(rows=14, columns=24):
    return smoothed(sphere(rows, columns))


def turn(axis, degrees):
    return [round(x, 7) for x in quaternion(axis, degrees)]
