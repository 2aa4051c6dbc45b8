// Counts the triangles of primitives, without reading an index.
#pragma once

#include <array>

#include "scene/scene.h"

namespace cleave {

// Returns how many indices a primitive with POSITION has: those of its accessor, or one for each vertex.
size_t indexCountOf(const Scene& scene, const gltf::Primitive& primitive);

// Returns how many triangles so many indices make; none if they are points or lines.
size_t triangleCount(gltf::Mode mode, size_t indexCount);
// Returns how many indices at the end make no triangle.
size_t surplusIndices(gltf::Mode mode, size_t indexCount);
// Returns the three indices that make triangle i.
std::array<size_t, 3> cornersOf(gltf::Mode mode, size_t i);

// Returns whether the plain bytes of a bufferView are there.
bool hasBytesOfView(const Scene& scene, uint32_t view);
// Returns whether the bytes of an accessor (and of its sparse part) are there.
bool hasBytes(const Scene& scene, uint32_t accessor);
// Returns whether the primitive has positions, and these and its indices are there.
bool isReadable(const Scene& scene, const gltf::Primitive& primitive);

// Counts the triangles that the scene shows. Throws Error if there are more than `most`.
size_t countTriangles(const Scene& scene, size_t most);

}  // namespace cleave
