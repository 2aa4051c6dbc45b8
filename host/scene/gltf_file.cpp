#include "scene/gltf_file.h"

#include <bit>
#include <cstring>
#include <fstream>

#include "scene/refuse.h"

namespace cleave {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores little-endian numbers, and they are copied");

using Bytes = std::span<const unsigned char>;

constexpr uint32_t kMagic = 0x46546C67u;      // "glTF"
constexpr uint32_t kJsonChunk = 0x4E4F534Au;  // "JSON"
constexpr uint32_t kDataChunk = 0x004E4942u;  // "BIN"
constexpr int kMaxJsonDepth = 100;            // the parser is recursive, and so are some checks
constexpr size_t kMaxJsonBytes = size_t(1) << 30;

uint32_t word(Bytes bytes, size_t at) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

// Counted before parsing: nlohmann's parser can be asked to, but then takes quadratic time for long arrays.
void checkDepth(Bytes text) {
    int depth = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const unsigned char c = text[i];
        if (inString && c == '\\') ++i;  // whatever is escaped does not end the string
        if (c == '"') inString = !inString;
        if (inString) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > kMaxJsonDepth) refuseGltf("its JSON text is nested deeper than " + std::to_string(kMaxJsonDepth));
    }
}

nlohmann::json parseJson(Bytes text) {
    if (text.size() > kMaxJsonBytes) refuseGltf("its JSON text is larger than 1 GiB");
    checkDepth(text);
    try {
        nlohmann::json document = nlohmann::json::parse(text.begin(), text.end());
        if (!document.is_object()) refuseGltf("its JSON text is not an object");
        return document;
    } catch (const nlohmann::json::exception& e) {
        refuseGltf(std::string("it is no valid JSON: ") + e.what());
    }
}

// Returns the chunk at `at`, and moves `at` past it (chunks are padded to four bytes).
Bytes takeChunk(Bytes bytes, size_t& at, uint32_t& type) {
    if (bytes.size() - at < 8) refuseGltf("a chunk's header is cut off at byte " + std::to_string(at));
    const uint32_t length = word(bytes, at);
    type = word(bytes, at + 4);
    at += 8;
    if (length > bytes.size() - at)
        refuseGltf("a chunk of " + std::to_string(length) + " bytes has only " + std::to_string(bytes.size() - at));
    const Bytes chunk = bytes.subspan(at, length);
    at += length;
    return chunk;
}

// glTF 2.0, section 4.4: a header of 12 bytes, a JSON chunk, perhaps a BIN chunk; other chunks are to be ignored.
void readGlb(Bytes bytes, GltfFile& file) {
    if (bytes.size() < 12) refuseGltf("the .glb header is cut off");
    if (word(bytes, 4) != 2) refuseGltf("it is .glb version " + std::to_string(word(bytes, 4)) + ", and must be 2");
    const uint32_t length = word(bytes, 8);
    if (length < 12 || length > bytes.size())
        refuseGltf("the .glb header announces " + std::to_string(length) + " bytes, and the file has " +
                   std::to_string(bytes.size()));
    bytes = bytes.first(length);
    size_t at = 12;
    uint32_t type = 0;
    const Bytes json = takeChunk(bytes, at, type);
    if (type != kJsonChunk) refuseGltf("its first chunk is not JSON");
    file.document = parseJson(json);
    if (at == bytes.size()) return;
    const Bytes data = takeChunk(bytes, at, type);
    if (type != kDataChunk) return;
    file.data.assign(data.begin(), data.end());
    file.hasData = true;
}

}  // namespace

std::vector<unsigned char> readBytes(const std::filesystem::path& path) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed)) refuseGltf("there is no file '" + path.string() + "'", "give its path");
    if (!std::filesystem::is_regular_file(path, failed))
        refuseGltf("'" + path.string() + "' is not a regular file", "give the path of a file");
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = stream ? std::streamoff(stream.tellg()) : -1;
    if (size < 0) refuseGltf("'" + path.string() + "' cannot be opened", "check its permissions");
    std::vector<unsigned char> bytes(size_t(size), 0);
    stream.seekg(0);
    if (size > 0 && !stream.read(reinterpret_cast<char*>(bytes.data()), size))
        refuseGltf("'" + path.string() + "' cannot be read to its end", "check the disk");
    return bytes;
}

GltfFile parseGltfFile(const std::filesystem::path& path, Bytes bytes) {
    GltfFile file;
    file.path = path;
    if (bytes.empty()) refuseGltf("the file is empty");
    if (bytes.size() >= 4 && word(bytes, 0) == kMagic)
        readGlb(bytes, file);
    else if (path.extension() == ".glb")
        refuseGltf("it does not begin with 'glTF', as a .glb does");
    else
        file.document = parseJson(bytes);
    return file;
}

}  // namespace cleave
