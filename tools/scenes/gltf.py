"""Writes glTF 2.0: a document that grows, with one buffer, as .glb or .gltf."""
import base64
import json
import math
import struct

from scenes.vectors import cross, unit

FLOAT, U8, U16, U32 = 5126, 5121, 5123, 5125
CODES = {FLOAT: "f", U8: "B", U16: "H", U32: "I"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def single(x):
    """The float nearest to x, as JSON and buffers are to agree."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def looking(eye, target):
    """The matrix of a node at `eye` whose -z is where `target` is."""
    forward = unit([t - e for e, t in zip(eye, target)])
    right = unit(cross(forward, [0, 1, 0]))
    up = cross(right, forward)
    return [round(c, 7) for c in (*right, 0, *up, 0, *[-f for f in forward], 0, *eye, 1)]


class Gltf:
    """A document under construction. Sines differ in their last digit between machines, so coordinates are rounded to
    so many decimals."""

    def __init__(self, decimals=7):
        self.decimals = decimals
        self.data = bytearray()
        self.views, self.accessors, self.materials, self.meshes, self.nodes, self.cameras = [], [], [], [], [], []
        self.textures, self.images, self.samplers, self.animations, self.skins, self.lights = [], [], [], [], [], []
        self.extensions = set()

    def view(self, packed):
        self.data += bytes(-len(self.data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(packed)})
        self.data += packed
        return len(self.views) - 1

    def accessor(self, kind, component, values, extra=None):
        view = self.view(struct.pack(f"<{len(values)}{CODES[component]}", *values))
        self.accessors.append({"bufferView": view, "componentType": component, "count": len(values) // WIDTHS[kind],
                               "type": kind, **(extra or {})})
        return len(self.accessors) - 1

    def vectors(self, kind, rows, bounds=False):
        """An accessor of floats, one row for each element."""
        rows = [[single(round(x, self.decimals)) for x in row] for row in rows]
        extra = {}
        if bounds:
            extra = {"min": [min(column) for column in zip(*rows)], "max": [max(column) for column in zip(*rows)]}
        return self.accessor(kind, FLOAT, [x for row in rows for x in row], extra)

    def geometry(self, shape):
        """What a primitive of the shape is made of."""
        attributes = {"POSITION": self.vectors("VEC3", shape.points, bounds=True)}
        component = U8 if len(shape.points) < 256 else U16 if len(shape.points) < 65536 else U32
        indices = self.accessor("SCALAR", component, [i for t in shape.triangles for i in t])
        if shape.normals:
            attributes["NORMAL"] = self.vectors("VEC3", shape.normals)
        if shape.texcoords:
            attributes["TEXCOORD_0"] = self.vectors("VEC2", shape.texcoords)
        if shape.colours:
            attributes["COLOR_0"] = self.vectors("VEC4", shape.colours)
        return {"attributes": attributes, "indices": indices}

    def material(self, name, r, g, b, metallic=0, roughness=1, texture=None, **fields):
        surface = {"baseColorFactor": [r, g, b, 1], "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture} if isinstance(texture, int) else texture
        surface.update(fields.pop("surface", {}))
        self.materials.append({"name": name, "pbrMetallicRoughness": surface, **fields})
        return len(self.materials) - 1

    def extension(self, name, **fields):
        """The `extensions` of an object, to be spread into it."""
        self.extensions.add(name)
        return {"extensions": {name: fields}}

    def texture(self, png, **sampler):
        """A texture of an image of its own, or of the image with that number."""
        if not isinstance(png, int):
            self.images.append({"bufferView": self.view(png), "mimeType": "image/png"})
            png = len(self.images) - 1
        texture = {"source": png}
        if sampler:
            if sampler not in self.samplers:
                self.samplers.append(sampler)
            texture["sampler"] = self.samplers.index(sampler)
        self.textures.append(texture)
        return len(self.textures) - 1

    def mesh(self, *parts, **fields):
        """parts: pairs of a geometry and a material."""
        self.meshes.append({"primitives": [{**geometry, "material": material} for geometry, material in parts],
                            **fields})
        return len(self.meshes) - 1

    def node(self, **fields):
        self.nodes.append(fields)
        return len(self.nodes) - 1

    def camera(self, name, eye, target, degrees):
        self.cameras.append({"name": name, "type": "perspective",
                             "perspective": {"yfov": round(math.radians(degrees), 6), "znear": 0.1}})
        self.node(name=name, camera=len(self.cameras) - 1, matrix=looking(eye, target))

    def light(self, **fields):
        """Returns what the light's node has."""
        self.lights.append(fields)
        return self.extension("KHR_lights_punctual", light=len(self.lights) - 1)

    def document(self, uri=None):
        buffer = {"byteLength": len(self.data), **({"uri": uri} if uri else {})}
        below = {child for node in self.nodes for child in node.get("children", [])}
        roots = [i for i in range(len(self.nodes)) if i not in below]
        fields = {"asset": {"version": "2.0", "generator": "cleave tools/make_scenes"}, "scene": 0,
                  "scenes": [{"nodes": roots}], "nodes": self.nodes, "meshes": self.meshes,
                  "cameras": self.cameras, "materials": self.materials, "accessors": self.accessors,
                  "bufferViews": self.views, "buffers": [buffer] if self.data else [], "textures": self.textures,
                  "images": self.images, "samplers": self.samplers, "animations": self.animations,
                  "skins": self.skins, "extensionsUsed": sorted(self.extensions)}
        if self.lights:
            fields["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        return {key: value for key, value in fields.items() if value != []}

    def glb(self):
        self.data += bytes(-len(self.data) % 4)
        text = json.dumps(self.document(), separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(self.data), 0x004E4942)
        return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks) + len(self.data)) + chunks + self.data

    def gltf(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        return (json.dumps(self.document(uri), indent=2) + "\n").encode()
