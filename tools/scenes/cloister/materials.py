"""What the cloister is made of."""
from scenes.patterns import mixed, noise, normal_map, spread, tinted
from scenes.png import png
from scenes.shapes import box_mapped

COLOURS = {  # linear red, green, blue; metallic; roughness
    "limestone leaf": (0.74, 0.67, 0.55, 0, 0.75),
    "limestone": (0.86, 0.78, 0.64, 0, 0.75),
    "rose stone": (0.62, 0.38, 0.27, 0, 0.75),
    "plaster": (0.92, 0.79, 0.61, 0, 0.95),
    "vault": (0.88, 0.83, 0.74, 0, 0.95),
    "dado": (0.52, 0.25, 0.17, 0, 0.55),
    "paving light": (0.7, 0.62, 0.51, 0, 0.7),
    "paving warm": (0.63, 0.52, 0.4, 0, 0.7),
    "paving grey": (0.54, 0.51, 0.47, 0, 0.65),
    "paving dark": (0.45, 0.39, 0.33, 0, 0.65),
    "meadow": (0.26, 0.25, 0.1, 0, 1.0),
    "mortar": (0.3, 0.26, 0.21, 0, 1.0),
    "cream marble": (0.8, 0.74, 0.63, 0, 0.24),
    "red marble": (0.27, 0.1, 0.065, 0, 0.24),
    "tile": (0.55, 0.23, 0.115, 0, 0.8),
    "tile pale": (0.64, 0.34, 0.19, 0, 0.8),
    "tile dark": (0.42, 0.165, 0.09, 0, 0.8),
    "pot": (0.6, 0.26, 0.14, 0, 0.7),
    "soil": (0.06, 0.04, 0.03, 0, 1.0),
    "bronze": (0.86, 0.54, 0.22, 1, 0.2),
    "dark bronze": (0.3, 0.2, 0.11, 1, 0.35),
    "water": (0.015, 0.075, 0.085, 0, 0.02),
    "falling water": (0.62, 0.72, 0.76, 0, 0.05),
    "glaze blue": (0.03, 0.12, 0.4, 0, 0.08),
    "glaze white": (0.8, 0.78, 0.72, 0, 0.12),
    "wood": (0.2, 0.095, 0.04, 0, 0.6),
    "iron": (0.08, 0.08, 0.085, 1, 0.5),
    "bark": (0.16, 0.115, 0.08, 0, 1.0),
    "leaf": (0.07, 0.17, 0.03, 0, 0.45),
    "leaf young": (0.15, 0.28, 0.05, 0, 0.45),
    "lemon": (0.86, 0.62, 0.03, 0, 0.4),
    "bract": (0.62, 0.045, 0.26, 0, 0.7),
    "cypress": (0.035, 0.085, 0.025, 0, 0.9),
    "agave": (0.16, 0.3, 0.2, 0, 0.5),
}
# Seen from both sides.
THIN = ("tile", "tile pale", "tile dark", "leaf", "leaf young", "bract", "cypress", "limestone leaf")
STONE = ("limestone", "rose stone", "plaster", "dado", "paving light", "paving warm", "paving grey", "paving dark",
         "pot")
POLISHED = ("cream marble", "red marble")
GRAIN = 1.6  # metres that a texture covers


class Materials:
    """The materials in a document, by name, and their textures."""

    def __init__(self, g):
        self.g = g
        grain = spread(mixed((6, noise(256, 4, 1)), (6, noise(256, 16, 2)), (4, noise(256, 128, 3))))
        relief = mixed((6, noise(256, 16, 5)), (6, noise(256, 64, 6)), (4, noise(256, 128, 7)))
        wear = spread(mixed((8, noise(256, 8, 8)), (6, noise(256, 32, 9)), (2, noise(256, 128, 10))))
        self.grain = g.texture(png(tinted(grain, (222, 219, 214), (255, 255, 255))))
        self.relief = g.texture(png(normal_map(relief, 150)))
        self.wear = g.texture(png(tinted(wear, (0, 110, 0), (0, 255, 0))))
        self.numbers = {name: self.add(name, *values) for name, values in COLOURS.items()}

    def add(self, name, r, g, b, metallic, roughness):
        fields = {"doubleSided": True} if name in THIN else {}
        if name in STONE:
            fields.update(texture=self.grain, normalTexture={"index": self.relief, "scale": 0.4})
        if name in POLISHED:
            fields["surface"] = {"metallicRoughnessTexture": {"index": self.wear}}
        return self.g.material(name, r, g, b, metallic, roughness, **fields)

    def part(self, shape, name):
        """A part of a mesh."""
        if name in STONE or name in POLISHED:
            shape = box_mapped(shape, GRAIN)
        return self.g.geometry(shape), self.numbers[name]
