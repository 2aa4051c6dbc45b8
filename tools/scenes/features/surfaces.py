"""Scenes that each show one feature of surfaces, or of what lights them."""
import math

from scenes.features.stage import ball, panel, stage, turn
from scenes.gltf import looking
from scenes.patterns import normal_map
from scenes.png import png
from scenes.shapes import Shape, box, sphere, turned
from scenes.vectors import product, quaternion

NEAREST, LINEAR, MIPMAPS = 9728, 9729, 9987
REPEAT, MIRRORED, CLAMPED = 10497, 33648, 33071


def letter():
    """An F, light on blue, with a red edge at its top and a yellow one at its left: it shows which way is up."""
    rows = []
    for y in range(16):
        rows.append([])
        for x in range(16):
            stroke = 4 <= x < 7 and 3 <= y < 14 or 3 <= y < 6 and 4 <= x < 12 or 8 <= y < 10 and 4 <= x < 10
            rows[-1].append((220, 60, 50) if y == 0 else (240, 200, 60) if x == 0 else (240, 240, 235) if stroke
                            else (40, 80, 150))
    return rows


def textures():
    """Above: filters and wrapping, texture coordinates from -0.5 to 1.5; below: KHR_texture_transform."""
    g = stage()
    image = g.texture(png(letter()), magFilter=NEAREST, minFilter=NEAREST, wrapS=REPEAT, wrapT=REPEAT)
    source = g.textures[image]["source"]
    wide = g.geometry(panel(1.3, 1.3, (-0.5, -0.5), (1.5, 1.5)))
    samplers = (("nearest, repeat", NEAREST, NEAREST, REPEAT), ("linear, repeat", LINEAR, MIPMAPS, REPEAT),
                ("nearest, mirrored", NEAREST, NEAREST, MIRRORED), ("linear, clamped", LINEAR, MIPMAPS, CLAMPED))
    for i, (name, larger, smaller, wrap) in enumerate(samplers):
        texture = g.texture(source, magFilter=larger, minFilter=smaller, wrapS=wrap, wrapT=wrap)
        mesh = g.mesh((wide, g.material(name, 1, 1, 1, texture=texture)))
        g.node(name=name, mesh=mesh, translation=[1.5 * i - 2.25, 1.6, 0])
    once = g.geometry(panel(1.3, 1.3))
    for i, (name, change) in enumerate((("as it is", {}), ("offset", {"offset": [0.25, 0.125]}),
                                        ("rotation", {"rotation": 0.523599}), ("scale", {"scale": [2, 3]}))):
        use = {"index": image, **(g.extension("KHR_texture_transform", **change) if change else {})}
        mesh = g.mesh((once, g.material(name, 1, 1, 1, texture=use)))
        g.node(name=name, mesh=mesh, translation=[1.5 * i - 2.25, 0.1, 0])
    g.camera("main", [0, 1.6, 6.2], [0, 1.5, 0], 36)
    return g.glb()


def cobbles():
    """Heights of rounded stones in rows."""
    def height(x, y):
        row = y // 16
        dx, dy = (x + 8 * (row % 2)) % 16 - 7.5, y % 16 - 7.5
        return max(0, int(255 - 3 * (dx * dx + dy * dy)))
    return [[height(x, y) for x in range(64)] for y in range(64)]


def normal_maps():
    """Three flat panels, with normals of cobbles at full scale, at a third of it, and without."""
    g = stage()
    texture = g.texture(png(normal_map(cobbles(), 220)), wrapS=REPEAT, wrapT=REPEAT)
    flat = panel(1.6, 2.2, (0, 0), (1.6, 2.2))
    shape = g.geometry(flat._replace(normals=[[0, 0, 1]] * 4))
    for i, scale in enumerate((1.0, 0.33, None)):
        fields = {} if scale is None else {"normalTexture": {"index": texture, "scale": scale}}
        material = g.material("flat" if scale is None else f"scale {scale}", 0.72, 0.45, 0.30, 0, 0.45, **fields)
        g.node(mesh=g.mesh((shape, material)), translation=[1.9 * (i - 1), 0.05, 0], rotation=turn([1, 0, 0], -12))
    g.camera("main", [0, 1.7, 5.6], [0, 1.1, 0], 36)
    return g.glb()


def smooth_normals():
    """The same few triangles without normals and with them."""
    g = stage()
    material = g.material("glaze", 0.10, 0.32, 0.36, 0, 0.3)
    for name, shape, x in (("flat", sphere(8, 12), -1.2), ("smooth", ball(8, 12), 1.2)):
        g.node(name=name, mesh=g.mesh((g.geometry(shape), material)), translation=[x, 0, 0])
    g.camera("main", [0, 1.8, 5.6], [0, 0.9, 0], 36)
    return g.glb()


def vertex_colours():
    """A cube of colours, and a disc with all hues about white; their material is white."""
    g = stage()
    white = g.material("white", 1, 1, 1, 0, 0.7)
    cube = box([-0.7, 0, -0.7], [0.7, 1.4, 0.7])
    corners = [[float(p[0] > 0), float(p[1] > 0), float(p[2] > 0), 1] for p in cube.points]
    g.node(name="cube", mesh=g.mesh((g.geometry(cube._replace(colours=corners)), white)), translation=[-1.2, 0, 0],
           rotation=turn([0, 1, 0], 30))
    rim = [[math.cos(math.pi * i / 12), math.sin(math.pi * i / 12), 0] for i in range(24)]
    hues = [[max(0.0, min(1.0, abs((i / 4 + k) % 6 - 3) - 1)) for k in (0, 4, 2)] + [1] for i in range(24)]
    fan = [(0, i + 1, (i + 1) % 24 + 1) for i in range(24)]
    disc = g.mesh((g.geometry(Shape([[0, 0, 0], *rim], fan, colours=[[1, 1, 1, 1], *hues])), white))
    g.node(name="disc", mesh=disc, translation=[1.2, 1.05, 0], rotation=turn([1, 0, 0], -15))
    g.camera("main", [0, 2.0, 5.6], [0, 0.85, 0], 36)
    return g.glb()


def leaf_picture():
    """A leaf on nothing."""
    rows = []
    for y in range(32):
        rows.append([])
        for x in range(32):
            across, along = abs(2 * x - 31), y
            half = along * (31 - along) * 31 // 260 if along < 30 else 0
            inside = across <= half or across <= 1 and along >= 22
            vein = across <= 1 or (across // 2 + along) % 8 == 0
            green = (110, 150, 50) if inside and vein else (60, 110, 30)
            rows[-1].append((*green, 255 if inside else 0))
    return rows


def alpha():
    """Leaves cut out by a mask, and panes that let some light through."""
    g = stage()
    texture = g.texture(png(leaf_picture()), magFilter=LINEAR, minFilter=MIPMAPS, wrapS=CLAMPED, wrapT=CLAMPED)
    leaf = g.mesh((g.geometry(panel(0.9, 1.1)), g.material("leaf", 1, 1, 1, 0, 0.7, texture=texture, alphaMode="MASK",
                                                          alphaCutoff=0.5, doubleSided=True)))
    for i in range(7):
        q = product(quaternion([0, 1, 0], 360 * i / 7 + 10), quaternion([1, 0, 0], 28 + 8 * (i % 3)))
        g.node(name="leaf", mesh=leaf, translation=[-1.25, 0.02, 0], rotation=[round(x, 7) for x in q])
    panes = (("red", (0.8, 0.08, 0.06)), ("green", (0.1, 0.6, 0.15)), ("blue", (0.06, 0.15, 0.8)))
    for i, (name, colour) in enumerate(panes):
        material = g.material(name, *colour, 0, 0.1, surface={"baseColorFactor": [*colour, 0.35 + 0.15 * i]},
                              alphaMode="BLEND", doubleSided=True)
        g.node(name=name, mesh=g.mesh((g.geometry(panel(1.0, 1.2)), material)),
               translation=[0.7 + 0.45 * i, 0.05 + 0.25 * i, 0.5 - 0.5 * i])
    g.node(name="behind", mesh=g.mesh((g.geometry(ball()), g.material("white", 0.8, 0.8, 0.8, 0, 0.5))),
           translation=[1.2, 0, -1.2], scale=[0.5, 0.5, 0.5])
    g.camera("main", [0, 1.6, 5.6], [0, 0.95, 0], 36)
    return g.glb()


def metallic_roughness():
    """Rough from left to right; gold, a metal by half, and a red that is no metal."""
    g = stage()
    shape = g.geometry(ball(16, 28))
    rows = ((0, (0.65, 0.05, 0.04)), (0.5, (0.80, 0.45, 0.25)), (1, (1.0, 0.72, 0.30)))
    for row, (metallic, colour) in enumerate(rows):
        for i in range(5):
            mesh = g.mesh((shape, g.material(f"metallic {metallic}, roughness {i / 4}", *colour, metallic, i / 4)))
            g.node(mesh=mesh, translation=[0.95 * (i - 2), 0.95 * row, -0.4 * row], scale=[0.42] * 3)
    g.camera("main", [0, 2.4, 6.6], [0, 1.25, 0], 32)
    return g.glb()


def emissive():
    """Bars that shine, each four times as strongly as the one before, are all that lights this scene."""
    g = stage()
    bar = g.geometry(box([-0.06, 0, -0.06], [0.06, 1.6, 0.06]))
    for i, (strength, colour) in enumerate(((1, [1, 0.75, 0.45]), (4, [1, 0.45, 0.25]), (16, [0.35, 0.55, 1]))):
        more = g.extension("KHR_materials_emissive_strength", emissiveStrength=strength) if strength > 1 else {}
        material = g.material(f"strength {strength}", 0, 0, 0, emissiveFactor=colour, **more)
        g.node(mesh=g.mesh((bar, material)), translation=[1.3 * (i - 1), 0, 0.3 * (i - 1)])
    white = g.material("white", 0.8, 0.8, 0.8, 0, 0.6)
    shape = g.mesh((g.geometry(ball()), white))
    for x in (-1.9, -0.65, 0.65):
        g.node(mesh=shape, translation=[x, 0, 0.7], scale=[0.28, 0.28, 0.28])
    g.camera("main", [0, 2.0, 5.6], [0, 0.7, 0], 36)
    return g.glb()


def lights():
    """A spot from the left, a point above the middle, and a weak directional light from the right."""
    g = stage()
    profile = [(0.3, 0), (0.3, 0.1), (0.22, 0.14), (0.19, 1.0), (0.28, 1.06), (0.28, 1.15)]
    column = g.mesh((g.geometry(turned(profile, 24)), g.material("stone", 0.75, 0.72, 0.66)))
    for x in (-1.6, 0, 1.6):
        g.node(mesh=column, translation=[x, 0, 0])
    cone = {"innerConeAngle": 0.2, "outerConeAngle": 0.35}
    spot = g.light(type="spot", color=[1, 0.8, 0.5], intensity=60, spot=cone)
    g.node(name="spot", matrix=looking([-3.2, 3, 2], [-1.6, 0.5, 0]), **spot)
    point = g.light(type="point", color=[1, 0.45, 0.35], intensity=6, range=6)
    g.node(name="point", translation=[0, 1.9, 0.6], **point)
    sun = g.light(type="directional", color=[0.5, 0.65, 1], intensity=0.6)
    g.node(name="directional", matrix=looking([4, 4, 4], [0, 0, 0]), **sun)
    g.camera("main", [0, 2.2, 6.0], [0, 0.7, 0], 36)
    return g.glb()


def unlit():
    """Two spheres of one colour; the one on the right shows it as it is."""
    g = stage()
    shape = g.geometry(ball())
    for name, x, fields in (("lit", -1.2, {}), ("unlit", 1.2, g.extension("KHR_materials_unlit"))):
        material = g.material(name, 0.85, 0.42, 0.10, 0, 0.6, **fields)
        g.node(name=name, mesh=g.mesh((shape, material)), translation=[x, 0, 0])
    g.camera("main", [0, 1.8, 5.6], [0, 0.9, 0], 36)
    return g.glb()


SCENES = {"textures": textures, "normal_map": normal_maps, "smooth_normals": smooth_normals,
          "vertex_colours": vertex_colours, "alpha": alpha, "metallic_roughness": metallic_roughness,
          "emissive": emissive, "lights": lights, "unlit": unlit}
