// A checked document becomes a tinygltf model, with the bytes of the buffers that it uses.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "scene/gltf_file.h"

namespace cleave {

// Checks the document, then loads it. Images are never read: their URIs are checked, and a missing file is a warning.
// A buffer that has no URI (and is not the BIN chunk of a .glb) stays empty.
tinygltf::Model loadModel(GltfFile file, std::vector<std::string>& warnings);

}  // namespace cleave
