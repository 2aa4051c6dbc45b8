// How much memory a breadth-first build has. The GPU builder and its twin ask here, since the room shapes the tree.
#pragma once

#include <cstdint>

#include "shared/build.h"
#include "tree/triangle_set.h"

namespace cleave {

// In entries; see BuildArgs.
struct BuildCapacity {
    uint32_t refs = 0;        // references of one level
    uint32_t levelNodes = 0;  // nodes of one level
    uint32_t nodes = 0;       // of the tree
    uint32_t leafRefs = 0;    // of all leaves
};

// The room that a build over `included` triangles starts with.
BuildCapacity firstCapacity(uint64_t included);
// Whether the build wanted more room than it had.
bool overflowed(const BuildState& state);
// More room, where a build with `capacity` needed it (state.needed...); no field shrinks.
BuildCapacity grownCapacity(const BuildCapacity& capacity, const BuildState& state);
// `capacity`, cut down so that its buffers take at most `bytes` (0: no limit); at least one reference per included
// triangle, so that the root can be a leaf. Throws Error if not even that fits.
BuildCapacity limitedCapacity(BuildCapacity capacity, uint64_t bytes, uint64_t included, uint32_t exactBelow);
// Bytes of all buffers of a build, without the triangles.
uint64_t bufferBytes(const BuildCapacity& capacity, uint32_t exactBelow);

// The root cell of a set: its bounds, or a point at the origin if it is empty.
Box rootCell(const TriangleSet& set);
float inverseBinCount(uint32_t bins);

}  // namespace cleave
