// Reads the bytes of the buffers that a scene may need.
#pragma once

#include "scene/gltf_file.h"
#include "scene/refuse.h"
#include "scene/shown_parts.h"

namespace cleave {

// Fills scene.buffers with byteLength bytes each. Throws Error where geometry or a skin needs a buffer that is missing
// or short; a buffer that only images and animations need is left empty, with a warning. So are, without one, buffers
// that nothing names, and those that have no URI (and are not the BIN chunk of a .glb). No URI may leave the folder.
void readBuffers(GltfFile& file, Scene& scene, const ShownParts& read, Warnings& warnings);

// Images are not read, but their URIs may not leave the folder either, and a missing file gives a warning.
void checkImageFiles(const Scene& scene, Warnings& warnings);

}  // namespace cleave
