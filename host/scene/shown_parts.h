// Which parts of a file its default scene may show.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace cleave {

// Of each mesh and bufferView.
struct ShownParts {
    std::vector<bool> meshes;
    std::vector<bool> views;
};

// Meshes of the nodes that are shown, and the views that these need. All images, animations, skins and instances
// count as shown: which of them are, shows later.
ShownParts shownParts(const Scene& scene);
// As if all of it were.
ShownParts allParts(const Scene& scene);

size_t unusedMeshes(const ShownParts& shown);
// Buffers without a view that is shown.
size_t unusedBuffers(const Scene& scene, const ShownParts& shown);

// Where the bytes of a view come from. A compressed view's own buffer, where there is one, is for those who cannot
// decompress it.
inline uint32_t payloadBuffer(const gltf::BufferView& view) {
    return view.meshopt ? view.meshopt->buffer : view.buffer;
}

}  // namespace cleave
