// Checks a glTF document before anyone follows its indices.
#pragma once

#include <string>

#include "scene/check_values.h"

namespace cleave {

// Throws Error unless: the version is 2; every required extension is known; every index is a whole number within its
// array; counts and offsets are whole and fit the data that they speak of; formats are those that glTF allows; and
// nodes form a forest (no cycle, one parent, scenes list roots, each once). It does not matter what the scene shows.
void checkGltf(const Json& document);

// The parts of checkGltf. Each may rely on those before it.
void checkBuffers(const Json& document);
void checkAccessors(const Json& document);
void checkMeshes(const Json& document);
void checkNodes(const Json& document);
void checkScenes(const Json& document);
void checkSkins(const Json& document);
void checkCameras(const Json& document);
void checkLights(const Json& document);
void checkImages(const Json& document);
void checkTextures(const Json& document);
void checkMaterials(const Json& document);
void checkAnimations(const Json& document);

// Returns the number of morph targets of a checked mesh.
size_t morphTargetsOf(const Json& document, size_t mesh);
// Throws Error unless `weights` of a mesh, or of a node that shows it, holds one for each morph target, if it is there.
void checkMorphWeights(const Json& document, const Json& object, size_t mesh, const std::string& where);

}  // namespace cleave
