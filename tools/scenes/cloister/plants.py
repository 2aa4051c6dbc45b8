"""What grows in the cloister: lemon trees and agaves in pots, a bougainvillea on the arcade, cypresses behind it."""
import math
from random import Random

from scenes.foliage import anywhere, clump, needle
from scenes.shapes import flipped, joined, lathed, sheet, smoothed, sphere
from scenes.vectors import added, quaternion, scaled, unit


def pot(radius, height, columns=36):
    """The pot and the soil in it; it stands on the ground."""
    foot = 0.68 * radius
    body = [(foot + (radius - foot) * (i / 6) ** 0.8, 0.85 * height * i / 6) for i in range(7)]
    rim, top = 1.08 * radius, height
    clay = lathed([body, [body[-1], (rim, 0.86 * height)],
                   [(rim, 0.86 * height), (1.01 * rim, 0.93 * height), (rim, top)],
                   [(rim, top), (0.9 * radius, top)], [(0.9 * radius, top), (0.88 * radius, 0.8 * height)]], columns)
    soil = lathed([[(0.9 * radius, 0.9 * height), (0, 0.93 * height)]], columns // 2)
    return clay, soil


def stem(points, radii, columns=8):
    """A tube through places, each with its radius."""
    def point(u, v):
        k = round(u * (len(points) - 1))
        angle = 2 * math.pi * v
        return added(points[k], [radii[k] * math.sin(angle), 0, radii[k] * math.cos(angle)])
    return smoothed(sheet(len(points) - 1, columns, point, (False, True)))


def lemon_tree(g, materials):
    random = Random(5)
    clay, soil = pot(0.36, 0.56)
    trunk = stem([[0, 0.5, 0], [0.02, 0.8, 0.01], [-0.02, 1.1, 0], [0.01, 1.45, 0.02], [0, 1.9, 0]],
                 [0.045, 0.035, 0.032, 0.03, 0.012])
    middle, radii = [0, 1.85, 0], [0.58, 0.55, 0.58]
    old = clump(random, middle, radii, 560, 0.15, 0.07, 0.25)
    young = clump(random, middle, [1.05 * r for r in radii], 200, 0.13, 0.06, 0.0)
    fruit = sphere(8, 12).moved(0, -1, 0).mapped(lambda p: [0.036 * p[0], 0.046 * p[1], 0.036 * p[2]])
    lemons = []
    for _ in range(16):
        out = anywhere(random)
        lemons.append(smoothed(fruit).moved(*(m + 0.97 * r * o for m, r, o in zip(middle, radii, out))))
    return g.mesh(materials.part(clay, "pot"), materials.part(soil, "soil"),
                  materials.part(trunk, "bark"), materials.part(old, "leaf"),
                  materials.part(young, "leaf young"), materials.part(joined(*lemons), "lemon"))


def agave(g, materials):
    """Thick pointed leaves in a spiral, the inner ones steeper."""
    def blade(turn, rise, length):
        def point(u, v):
            angle, width = 2 * math.pi * v, 0.065 * (1 - u) ** 0.6 * (0.55 + 1.4 * u * (1 - u)) + 0.001
            steep = rise - 0.35 * u
            out, up = 0.04 + length * u * math.cos(steep), length * u * math.sin(steep)
            across, thick = width * math.cos(angle), 0.22 * width * math.sin(angle) - 0.5 * width * abs(math.cos(angle))
            return [out - thick * math.sin(steep), up + thick * math.cos(steep) + 0.02, across]
        return smoothed(flipped(sheet(8, 6, point, (False, True)))).turned(quaternion([0, 1, 0], math.degrees(turn)))
    blades = [blade(2.39996 * i, 0.35 + 1.05 * i / 25, 0.62 - 0.008 * i) for i in range(26)]
    clay, soil = pot(0.27, 0.36)
    return g.mesh(materials.part(clay, "pot"), materials.part(soil, "soil"),
                  materials.part(joined(*blades).moved(0, 0.33, 0), "agave"))


def bougainvillea(g, materials):
    """Up a pier in the origin, that stands in the corner towards -x and -z, and along the cornice on both sides."""
    random = Random(23)
    places = [([0.34, 0.5 + 0.62 * i, 0.34], [0.24, 0.42, 0.24], 46) for i in range(7)]
    for i in range(7):
        hang = 4.72 - 0.13 * i * (i % 2)
        size = 0.46 - 0.045 * i
        places += [([0.5 + 0.52 * i, hang, 0.42], [0.42, size, 0.34], 120 - 12 * i),
                   ([0.42, hang + 0.1, 0.5 + 0.46 * i], [0.34, size, 0.40], 110 - 13 * i)]
    leaves = joined(*(clump(random, c, r, n, 0.12, 0.075, 0.3) for c, r, n in places if n > 0))
    bracts = joined(*(clump(random, c, [1.1 * x for x in r], int(1.7 * n), 0.085, 0.08, 0.2, needle)
                      for c, r, n in places[3:] if n > 0))
    trunk = stem([[0.38, 0.0, 0.38], [0.33, 1.2, 0.36], [0.36, 2.4, 0.33], [0.34, 3.6, 0.36], [0.42, 4.7, 0.4]],
                 [0.045, 0.04, 0.035, 0.03, 0.02])
    return g.mesh(materials.part(trunk, "bark"), materials.part(leaves, "leaf"),
                  materials.part(bracts, "bract"))


def cypress(g, materials):
    """Ten metres high and narrow: a dark body, and sprays that stand up from it."""
    random = Random(3)

    def radius(h):
        return 0.95 * math.sin(math.pi * min(1, 0.12 + 0.88 * h)) ** 0.8 * (1 - 0.45 * h) + 0.03
    body = lathed([[(0.8 * radius(i / 16) if i < 16 else 0, 10 * i / 16) for i in range(17)]], 14)
    sprays = []
    for _ in range(1500):
        h, angle = random.random() ** 1.2, 2 * math.pi * random.random()
        out = [math.sin(angle), 0, math.cos(angle)]
        foot = added(scaled(out, radius(h) * (0.72 + 0.2 * random.random())), [0, 10 * h - 0.3, 0])
        outwards = scaled(out, 0.28 + 0.3 * random.random())
        along = unit(added(outwards, [0.2 * (random.random() - 0.5), 1, 0.2 * (random.random() - 0.5)]))
        sprays.append(needle(foot, along, out, 0.75 + 0.5 * random.random(), 0.26))
    return g.mesh(materials.part(joined(body), "cypress"), materials.part(joined(*sprays), "cypress"))


def add_plants(g, materials):
    tree, aloe = lemon_tree(g, materials), agave(g, materials)
    for x, z, degrees in ((-4.9, -4.9, 20), (4.9, -4.9, 110), (-4.9, 4.9, 200), (5.1, 2.6, 290)):
        g.node(name="lemon tree", mesh=tree, translation=[x, 0, z],
               rotation=[round(q, 7) for q in quaternion([0, 1, 0], degrees)])
    for x, z in ((-1.95, -6.1), (1.95, -6.1)):
        g.node(name="agave", mesh=aloe, translation=[x, 0.0, z + 0.2])
    g.node(name="bougainvillea", mesh=bougainvillea(g, materials), translation=[7.0, 0, -7.0],
           rotation=[round(q, 7) for q in quaternion([0, 1, 0], -90)])
    trees = cypress(g, materials)
    for x, z, size in ((3.2, -14.2, 1.0), (5.0, -15.4, 1.12), (-9.5, -15.0, 0.95), (-15.0, -7.5, 1.05)):
        g.node(name="cypress", mesh=trees, translation=[x, -0.2, z], scale=[size] * 3,
               rotation=[round(q, 7) for q in quaternion([0, 1, 0], 70 * x)])
