"""The bell tower behind the cloister."""
import math

from scenes.cloister.arcade import bulge
from scenes.masonry import arched_wall, block, ring_of_stones
from scenes.shapes import joined, lathed, turned
from scenes.vectors import quaternion

HALF = 1.7
BELFRY = 10.4
SPRINGING = 12.2


def add_tower(g, materials):
    shaft = [block(HALF, -0.2, BELFRY - 0.3, 0.03), block(HALF + 0.14, BELFRY - 0.32, BELFRY, 0.05)]
    front = arched_wall(2 * HALF, BELFRY - 0.02, SPRINGING, 0.75, 13.7, 0.5, 20)
    flank = arched_wall(2 * HALF - 1, BELFRY - 0.02, SPRINGING, 0.75, 13.7, 0.5, 20)
    quarter = quaternion([0, 1, 0], 90)
    walls = [front.moved(0, 0, HALF - 0.25), front.moved(0, 0, 0.25 - HALF),
             flank.moved(0, 0, HALF - 0.25).turned(quarter), flank.moved(0, 0, 0.25 - HALF).turned(quarter)]
    lid = [block(HALF + 0.12, 13.68, 13.86, 0.03), block(HALF + 0.28, 13.86, 14.05, 0.04)]
    courses = 14
    eaves = (HALF + 0.5) * math.sqrt(2)
    profile = [(eaves * (1 - (i + shift) / (courses + 1)), 14.04 + 0.16 * i + high)
               for i in range(courses) for shift, high in ((0, 0), (0, 0.06), (0.15, 0.07))]
    roof = turned(profile, 4).turned(quaternion([0, 1, 0], 45))
    pale, rose = ring_of_stones(0.73, 1.0, 13, HALF - 0.02, HALF + 0.03)
    voussoirs = [s.moved(0, SPRINGING, 0).turned(quaternion([0, 1, 0], 90 * k)) for k in range(4) for s in (pale, rose)]
    knob = lathed([[(0.05, 16.2), (0.05, 16.5)], bulge(0.001, 16.45, 16.85, 12)], 20)
    bell = lathed([[(0.42, 11.6), (0.36, 11.75), (0.27, 12.0), (0.23, 12.25), (0.17, 12.36), (0, 12.4)],
                   [(0, 11.75), (0.30, 11.72), (0.38, 11.6)], [(0.38, 11.6), (0.42, 11.6)]], 32)
    beam = block(0.06, 0, 2.5, 0).turned(quaternion([0, 0, 1], 90)).moved(1.25, 12.45, 0)
    g.node(name="tower", translation=[-5.6, 0, -19.0], rotation=[0, 0.1305262, 0, 0.9914449],
           mesh=g.mesh(materials.part(joined(*shaft[:1]), "plaster"),
                       materials.part(joined(*shaft[1:], *walls, *lid, *voussoirs[0::2]), "limestone"),
                       materials.part(joined(*voussoirs[1::2]), "rose stone"), materials.part(roof, "tile"),
                       materials.part(joined(knob, bell), "dark bronze"), materials.part(beam, "wood")))
