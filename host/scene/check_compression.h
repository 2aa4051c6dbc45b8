// Checks what a glTF says of its compressed data. The data itself is checked where it is decompressed.
#pragma once

#include <optional>
#include <string>

#include "scene/check_values.h"
#include "scene/gltf.h"

namespace cleave {

// Returns the name of the extension that is about meshopt in a bufferView or a buffer: EXT_meshopt_compression or
// KHR_meshopt_compression, which have the same members; null if it has neither.
const char* meshoptNameOf(const Json& object);

// Return nothing for a name that is not known.
std::optional<gltf::MeshoptMode> meshoptModeOf(const std::string& name);
std::optional<gltf::MeshoptFilter> meshoptFilterOf(const std::string& name);

// Each of these throws Error unless what its name says is as its extension demands, or not there.
void checkFallback(const Json& buffer, const std::string& where);
void checkMeshopt(const Json& document, const Json& view, const std::string& where);
void checkDraco(const Json& document, const Json& primitive, const std::string& where);

}  // namespace cleave
