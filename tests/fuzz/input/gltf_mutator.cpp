// Mutations of a glTF's JSON that leave it JSON, and of a .glb's parts that leave it a .glb: random bytes alone rarely
// get past the parser. Half of all mutations stay random bytes, for the parsers' own sake.
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t maxSize);
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t maxSize, unsigned int seed);

namespace {

using Json = nlohmann::json;
using Random = std::minstd_rand;

constexpr int kDeepest = 150;  // writing JSON is recursive

size_t below(Random& random, size_t n) { return n == 0 ? 0 : random() % n; }

struct Parts {
    std::string json;
    std::string data;
    bool isGlb = false;
};

uint32_t wordAt(const std::string& bytes, size_t at) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

Parts partsOf(const std::string& bytes) {
    if (bytes.size() < 20 || !bytes.starts_with("glTF")) return {bytes, "", false};
    Parts parts{"", "", true};
    parts.json = bytes.substr(20, wordAt(bytes, 12));
    const size_t rest = 20 + parts.json.size() + 8;
    if (rest < bytes.size()) parts.data = bytes.substr(rest);
    return parts;
}

std::string bytesOf(Parts parts) {
    if (!parts.isGlb) return parts.json;
    parts.json.resize((parts.json.size() + 3) / 4 * 4, ' ');
    parts.data.resize((parts.data.size() + 3) / 4 * 4, '\0');
    const auto word = [](size_t value) {
        const auto w = static_cast<uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&w), sizeof w);
    };
    return "glTF" + word(2) + word(28 + parts.json.size() + parts.data.size()) + word(parts.json.size()) + "JSON" +
           parts.json + word(parts.data.size()) + std::string("BIN\0", 4) + parts.data;
}

bool isShallow(const std::string& text) {
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (depth > kDeepest) return false;
    }
    return true;
}

// All values of the document, the root first.
std::vector<Json*> valuesOf(Json& root) {
    std::vector<Json*> values{&root};
    for (size_t i = 0; i < values.size(); ++i) {
        if (!values[i]->is_structured()) continue;
        for (Json& child : *values[i]) values.push_back(&child);
    }
    return values;
}

Json anyValue(Random& random) {
    static const std::array<Json, 39> kValues = {0,
                                                 1,
                                                 2,
                                                 3,
                                                 4,
                                                 6,
                                                 7,
                                                 12,
                                                 16,
                                                 255,
                                                 -1,
                                                 5120,
                                                 5121,
                                                 5123,
                                                 5125,
                                                 5126,
                                                 65536,
                                                 2147483647,
                                                 4294967295u,
                                                 281474976710656u,
                                                 18446744073709551615u,
                                                 0.5,
                                                 -0.0,
                                                 1e-320,
                                                 1e39,
                                                 1e308,
                                                 true,
                                                 nullptr,
                                                 "",
                                                 "SCALAR",
                                                 "VEC3",
                                                 "ATTRIBUTES",
                                                 "TRIANGLES",
                                                 "INDICES",
                                                 "QUATERNION",
                                                 "EXPONENTIAL",
                                                 "data:application/octet-stream;base64,AAAAAAAAgD8AAAAA",
                                                 Json::array(),
                                                 Json::object()};
    return kValues[below(random, kValues.size())];
}

const char* anyKey(Random& random) {
    static constexpr std::array kKeys = {"bufferView",
                                         "byteOffset",
                                         "byteLength",
                                         "byteStride",
                                         "buffer",
                                         "componentType",
                                         "count",
                                         "type",
                                         "max",
                                         "normalized",
                                         "sparse",
                                         "indices",
                                         "values",
                                         "mesh",
                                         "camera",
                                         "skin",
                                         "children",
                                         "matrix",
                                         "translation",
                                         "rotation",
                                         "scale",
                                         "nodes",
                                         "primitives",
                                         "attributes",
                                         "POSITION",
                                         "material",
                                         "mode",
                                         "targets",
                                         "uri",
                                         "extensions",
                                         "extras",
                                         "scene",
                                         "yfov",
                                         "perspective",
                                         "orthographic",
                                         "ymag",
                                         "baseColorFactor",
                                         "pbrMetallicRoughness",
                                         "KHR_draco_mesh_compression",
                                         "EXT_meshopt_compression",
                                         "EXT_mesh_gpu_instancing",
                                         "TRANSLATION",
                                         "ROTATION",
                                         "SCALE",
                                         "filter",
                                         "fallback",
                                         "weights",
                                         "name",
                                         "images",
                                         "textures",
                                         "minVersion",
                                         "skins",
                                         "joints",
                                         "inverseBindMatrices",
                                         "skeleton",
                                         "JOINTS_0",
                                         "WEIGHTS_0",
                                         "animations",
                                         "channels",
                                         "samplers",
                                         "sampler",
                                         "target",
                                         "node",
                                         "path",
                                         "input",
                                         "output",
                                         "interpolation",
                                         "index",
                                         "texCoord",
                                         "source",
                                         "light",
                                         "lights"};
    return kKeys[below(random, kKeys.size())];
}

// One change somewhere: a value replaced by a telling one, or by another of the document; a member or an entry added,
// doubled or taken away.
void change(Json& root, Random& random) {
    const std::vector<Json*> values = valuesOf(root);
    Json& value = *values[below(random, values.size())];
    const Json other = below(random, 2) == 0 ? anyValue(random) : Json(*values[below(random, values.size())]);
    const size_t kind = below(random, 6);
    if (value.is_object() && kind < 3) {
        value[anyKey(random)] = other;
    } else if (value.is_object() && kind < 5 && !value.empty()) {
        value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(below(random, value.size()))));
    } else if (value.is_array() && kind < 2) {
        value.push_back(other);
    } else if (value.is_array() && kind < 4 && !value.empty()) {
        const Json copy = value[below(random, value.size())];
        for (size_t i = size_t(1) << below(random, 5); i > 0; --i) value.push_back(copy);
    } else if (value.is_array() && kind == 4 && !value.empty()) {
        value.erase(below(random, value.size()));
    } else if (value.is_number_unsigned() && kind < 3) {
        value = value.get<uint64_t>() + below(random, 3) - 1;
    } else if (&value != &root) {
        value = other;
    }
}

bool changeJson(std::string& text, Random& random) {
    if (!isShallow(text)) return false;
    Json root = Json::parse(text, nullptr, false);
    if (!root.is_object() || root.empty()) return false;
    for (size_t i = 1 + below(random, 3); i > 0; --i) change(root, random);
    text = root.dump(-1, ' ', false, Json::error_handler_t::ignore);
    return true;
}

}  // namespace

size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t maxSize, unsigned int seed) {
    Random random(seed + 1);
    if (below(random, 2) == 0) return LLVMFuzzerMutate(data, size, maxSize);
    Parts parts = partsOf({reinterpret_cast<const char*>(data), size});
    if (parts.isGlb && !parts.data.empty() && below(random, 4) == 0) {
        const size_t room = parts.data.size();
        parts.data.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(parts.data.data()), room, room));
    } else if (!changeJson(parts.json, random)) {
        return LLVMFuzzerMutate(data, size, maxSize);
    }
    const std::string bytes = bytesOf(std::move(parts));
    if (bytes.empty() || bytes.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}
