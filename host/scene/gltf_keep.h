// Keeps a checked document as plain data.
#pragma once

#include "scene/check_values.h"
#include "scene/refuse.h"
#include "scene/scene.h"

namespace cleave {

// Returns the scene, all but its name, its folder, the bytes of its buffers and its warnings, which are added to
// `warnings`.
Scene keepGltf(const Json& document, Warnings& warnings);

// The parts of keepGltf.
void keepData(const Json& document, Scene& scene);
void keepMeshes(const Json& document, Scene& scene);
void keepNodes(const Json& document, Scene& scene);
void keepMaterials(const Json& document, Scene& scene, Warnings& warnings);
void keepAnimations(const Json& document, Scene& scene, Warnings& warnings);

}  // namespace cleave
