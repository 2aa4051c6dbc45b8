// The objects of a glTF document as plain data. Every index lies within its array; payloads are not decoded.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cleave::gltf {

using Index = std::optional<uint32_t>;

struct Buffer {
    std::vector<unsigned char> bytes;  // byteLength of them, or none: not used, not there, or cut short
    uint64_t byteLength = 0;
};

enum class MeshoptMode { attributes, triangles, indices };
enum class MeshoptFilter { none, octahedral, quaternion, exponential };

// EXT_meshopt_compression: where the compressed bytes of a bufferView are, and how they become `count` elements.
struct Meshopt {
    uint32_t buffer = 0;
    uint64_t byteOffset = 0;
    uint64_t byteLength = 0;
    uint64_t byteStride = 0;
    uint64_t count = 0;
    MeshoptMode mode = MeshoptMode::attributes;
    MeshoptFilter filter = MeshoptFilter::none;
};

struct BufferView {
    uint32_t buffer = 0;
    uint64_t byteOffset = 0;
    uint64_t byteLength = 0;
    uint64_t byteStride = 0;         // 0: elements are packed
    std::optional<Meshopt> meshopt;  // until it is decompressed: it then is in a buffer of its own
};

enum class ComponentType { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };
enum class ElementType { scalar, vec2, vec3, vec4, mat2, mat3, mat4, unknown };

struct Sparse {
    uint64_t count = 0;
    uint32_t indicesView = 0;
    uint64_t indicesOffset = 0;
    ComponentType indicesType = ComponentType::uint32;
    uint32_t valuesView = 0;
    uint64_t valuesOffset = 0;
};

struct Accessor {
    Index view;  // none: zeros
    uint64_t byteOffset = 0;
    ComponentType componentType = ComponentType::float32;
    ElementType elementType = ElementType::unknown;
    bool normalized = false;
    uint64_t count = 0;
    std::optional<Sparse> sparse;
};

enum class Mode { points, lines, lineLoop, lineStrip, triangles, triangleStrip, triangleFan };

using Attributes = std::map<std::string, uint32_t>;  // semantic -> accessor

// KHR_draco_mesh_compression: the bufferView that holds indices and attributes of a primitive.
struct Draco {
    uint32_t view = 0;
    std::map<std::string, uint32_t> ids;  // semantic -> what Draco calls the attribute
};

struct Primitive {
    Attributes attributes;
    Index indices;
    Index material;
    Mode mode = Mode::triangles;
    std::vector<Attributes> targets;
    std::optional<Draco> draco;  // until it is decompressed: its accessors then are its own
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<double> weights;  // one for each morph target, or none: all 0
};

// translation * rotation * scale, or a matrix in their place.
struct Transform {
    glm::dvec3 translation{0.0};
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0};  // quaternion x, y, z, w
    glm::dvec3 scale{1.0};
    std::optional<glm::dmat4> matrix;
};

// EXT_mesh_gpu_instancing: a mesh is shown `count` times. Accessors of that count; none: identity.
struct Instancing {
    uint64_t count = 0;
    Index translations;
    Index rotations;
    Index scales;
};

struct Node {
    std::string name;
    std::vector<uint32_t> children;
    Transform transform;
    Index mesh;
    Index skin;
    Index camera;
    Index light;
    std::vector<double> weights;  // take the place of the mesh's
    std::optional<Instancing> instancing;
};

struct SceneRoots {
    std::string name;
    std::vector<uint32_t> nodes;
};

struct Skin {
    std::string name;
    std::vector<uint32_t> joints;
    Index inverseBindMatrices;  // none: identities
    Index skeleton;
};

enum class AlphaMode { opaque, mask, blend };

struct TextureUse {
    uint32_t texture = 0;
    uint32_t texCoord = 0;
    // KHR_texture_transform
    glm::dvec2 offset{0.0};
    double rotation = 0.0;
    glm::dvec2 scale{1.0};
};

struct Material {
    std::string name;
    glm::vec4 baseColour{1.0f};  // linear RGBA in [0, 1], the base colour factor
    float metallic = 1.0f;       // in [0, 1], as roughness, emissive and occlusionStrength
    float roughness = 1.0f;
    glm::vec3 emissive{0.0f};       // linear RGB
    float emissiveStrength = 1.0f;  // 0 or more, finite
    float normalScale = 1.0f;       // finite
    float occlusionStrength = 1.0f;
    std::optional<TextureUse> baseColourTexture;
    std::optional<TextureUse> metallicRoughnessTexture;
    std::optional<TextureUse> normalTexture;
    std::optional<TextureUse> occlusionTexture;
    std::optional<TextureUse> emissiveTexture;
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;
};

struct Texture {
    std::string name;
    Index image;
    Index sampler;
};

// A file, a data URI, or a bufferView with a type.
struct Image {
    std::string name;
    std::string uri;
    std::string mimeType;
    Index view;
};

enum class Filter {
    unspecified = 0,
    nearest = 9728,
    linear = 9729,
    nearestMipmapNearest = 9984,
    linearMipmapNearest = 9985,
    nearestMipmapLinear = 9986,
    linearMipmapLinear = 9987
};
enum class Wrap { clampToEdge = 33071, mirroredRepeat = 33648, repeat = 10497 };

struct Sampler {
    Filter magFilter = Filter::unspecified;
    Filter minFilter = Filter::unspecified;
    Wrap wrapS = Wrap::repeat;
    Wrap wrapT = Wrap::repeat;
};

enum class LightType { directional, point, spot };

struct Light {
    std::string name;
    LightType type = LightType::point;
    glm::dvec3 colour{1.0};  // linear RGB, 0 or more
    double intensity = 1.0;  // 0 or more; lux of a directional light, candela of the others
    double range = std::numeric_limits<double>::infinity();  // more than 0
    double innerConeAngle = 0.0;                             // from 0 to outerConeAngle
    double outerConeAngle = 0.7853981633974483;              // pi / 4; at most pi / 2
};

struct Camera {
    std::string name;
    bool orthographic = false;
    double verticalFov = 0.0;  // radians; perspective only
    double aspectRatio = 0.0;  // 0: the picture's
    double xMagnification = 0.0;
    double yMagnification = 0.0;  // half the height seen; orthographic only
    double zNear = 0.0;
    double zFar = std::numeric_limits<double>::infinity();
};

enum class Interpolation { linear, step, cubicSpline };
enum class Path { translation, rotation, scale, weights };

struct AnimationSampler {
    uint32_t input = 0;   // accessor of the keys' times in seconds
    uint32_t output = 0;  // accessor of their values
    Interpolation interpolation = Interpolation::linear;
};

struct Channel {
    uint32_t sampler = 0;
    uint32_t node = 0;
    Path path = Path::translation;
};

struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<Channel> channels;
};

}  // namespace cleave::gltf
