#include "scene/uri_bytes.h"

#include <tiny_gltf.h>

#include "scene/gltf_file.h"
#include "scene/gltf_uri.h"
#include "scene/refuse.h"

namespace cleave {

std::vector<unsigned char> bytesOfUri(const std::filesystem::path& folder, const std::string& uri) {
    if (!isDataUri(uri)) return readBytes(pathOfUri(folder, uri));
    std::vector<unsigned char> bytes;
    std::string mimeType;
    if (!tinygltf::IsDataURI(uri) || !tinygltf::DecodeDataURI(&bytes, mimeType, uri, 0, false))
        refuseGltf("the data URI '" + uri.substr(0, 40) + "...' cannot be decoded");
    return bytes;
}

}  // namespace cleave
