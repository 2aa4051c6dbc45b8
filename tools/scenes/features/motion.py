"""Scenes that each show one way to place or to move things."""
import math

from scenes.features.stage import ball, stage, turn
from scenes.gltf import FLOAT, U8
from scenes.shapes import box, sheet, smoothed, turned
from scenes.vectors import quaternion, taken


def instancing():
    """One node, 120 cubes up a spiral: EXT_mesh_gpu_instancing."""
    g = stage()
    places, turns, sizes = [], [], []
    for i in range(120):
        angle, out = 0.32 * i, 0.5 + 0.010 * i
        places.append([out * math.sin(angle), 0.15 + 0.017 * i, out * math.cos(angle)])
        turns.append(quaternion([0, 1, 0], math.degrees(angle)))
        sizes.append([0.10 + 0.0006 * i] * 3)
    attributes = {"TRANSLATION": g.vectors("VEC3", places), "ROTATION": g.vectors("VEC4", turns),
                  "SCALE": g.vectors("VEC3", sizes)}
    mesh = g.mesh((g.geometry(box([-1, -1, -1], [1, 1, 1])), g.material("ochre", 0.72, 0.46, 0.16, 0, 0.5)))
    g.node(name="spiral", mesh=mesh, **g.extension("EXT_mesh_gpu_instancing", attributes=attributes))
    g.camera("main", [0, 2.6, 5.4], [0, 1.1, 0], 36)
    return g.glb()


def animate(g, name, *channels):
    """channels: a node, a path, times, values (rows) and how to get from one to the next."""
    animation = {"name": name, "channels": [], "samplers": []}
    for node, path, times, values, way in channels:
        key_times = g.accessor("SCALAR", FLOAT, times, {"min": [min(times)], "max": [max(times)]})
        key_values = g.vectors({1: "SCALAR", 3: "VEC3", 4: "VEC4"}[len(values[0])], values)
        animation["channels"].append({"sampler": len(animation["samplers"]), "target": {"node": node, "path": path}})
        animation["samplers"].append({"input": key_times, "output": key_values, "interpolation": way})
    g.animations.append(animation)


def animation():
    """For two seconds a cube turns (linear), a ball jumps (cubic spline), a cone grows in steps."""
    g = stage()
    blue, red, green = (g.material("blue", 0.10, 0.25, 0.60, 0, 0.5), g.material("red", 0.70, 0.12, 0.08, 0, 0.4),
                        g.material("green", 0.20, 0.45, 0.12, 0, 0.6))
    meshes = [g.mesh((g.geometry(shape), material)) for shape, material in (
        (box([-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]), blue), (ball(), red), (turned([(0.5, 0), (0.02, 1)], 24), green))]
    cube = g.node(name="cube", mesh=meshes[0], translation=[-1.6, 0.5, 0])
    jumper = g.node(name="ball", mesh=meshes[1], scale=[0.5, 0.5, 0.5])
    cone = g.node(name="cone", mesh=meshes[2], translation=[1.6, 0, 0])
    quarter = [0, 0.7071068, 0, 0.7071068]
    up, rest = [0, 6, 0], [0, 0, 0]
    jump = [rest, [0, 0, 0], up, rest, [0, 1.5, 0], rest, [0, -6, 0], [0, 0, 0], rest]
    animate(g, "all", (cube, "rotation", [0, 1, 2], [[0, 0, 0, 1], quarter, [0, 1, 0, 0]], "LINEAR"),
            (jumper, "translation", [0, 1, 2], jump, "CUBICSPLINE"),
            (cone, "scale", [0, 0.5, 1, 1.5], [[1, 1, 1], [1, 1.3, 1], [1, 1.6, 1], [1, 1.9, 1]], "STEP"))
    g.camera("main", [0, 1.9, 5.2], [0, 0.8, 0], 36)
    return g.glb()


def morph_target():
    """A ball that its targets make a cushion of, and a pear; half of each at rest, in turn when it moves."""
    g = stage()
    shape = ball(16, 24)

    def target(change):
        changed = smoothed(shape._replace(points=[change(p) for p in shape.points]))
        pairs = {"POSITION": (shape.points, changed.points), "NORMAL": (shape.normals, changed.normals)}
        return {name: g.vectors("VEC3", [taken(b, a) for a, b in zip(*pair)], bounds=True)
                for name, pair in pairs.items()}
    targets = [target(lambda p: [1.3 * p[0], 0.35 * p[1], 1.3 * p[2]]),
               target(lambda p: [p[0] * (1.1 - 0.35 * p[1]), 1.25 * p[1], p[2] * (1.1 - 0.35 * p[1])])]
    plum = g.material("plum", 0.42, 0.10, 0.30, 0, 0.4)
    mesh = g.mesh(({**g.geometry(shape), "targets": targets}, plum), weights=[0.5, 0.5])
    node = g.node(name="fruit", mesh=mesh)
    weights = [[w] for pair in ((0.5, 0.5), (1, 0), (0, 1), (0.5, 0.5)) for w in pair]
    animate(g, "ripen", (node, "weights", [0, 1, 2, 3], weights, "LINEAR"))
    g.camera("main", [0, 1.8, 4.6], [0, 0.75, 0], 36)
    return g.glb()


def skin():
    """A tube that three joints bend."""
    g = stage()
    rows, columns = 24, 16

    def point(u, v):
        return [0.22 * math.sin(2 * math.pi * v), 2.4 * u, 0.22 * math.cos(2 * math.pi * v)]
    tube = smoothed(sheet(rows, columns, point, (False, True)))
    joints, weights = [], []
    for _, y, _ in tube.points:
        first = min(1, int(y / 0.8))
        share = max(0.0, min(1.0, (y - 0.8 * first - 0.4) / 0.8))
        joints += [first, first + 1, 0, 0]
        weights.append([1 - share, share, 0, 0])
    geometry = g.geometry(tube)
    geometry["attributes"].update(JOINTS_0=g.accessor("VEC4", U8, joints), WEIGHTS_0=g.vectors("VEC4", weights))
    count = len(g.nodes)
    bent = turn([0, 0, 1], -35)
    g.node(name="foot", children=[count + 1])
    g.node(name="knee", translation=[0, 0.8, 0], rotation=bent, children=[count + 2])
    g.node(name="tip", translation=[0, 0.8, 0], rotation=bent)
    inverse = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.8 * i, 0, 1] for i in range(3)]
    g.skins.append({"joints": [count, count + 1, count + 2], "inverseBindMatrices": g.vectors("MAT4", inverse)})
    rubber = g.material("rubber", 0.12, 0.42, 0.36, 0, 0.5, doubleSided=True)
    g.node(name="tube", skin=0, mesh=g.mesh((geometry, rubber)))
    waves = [bent, turn([0, 0, 1], 35), bent]
    animate(g, "wave", *((count + k, "rotation", [0, 1, 2], waves, "LINEAR") for k in (1, 2)))
    g.camera("main", [0.5, 1.6, 4.4], [0.5, 0.95, 0], 36)
    return g.glb()


SCENES = {"instancing": instancing, "animation": animation, "morph_target": morph_target, "skin": skin}
