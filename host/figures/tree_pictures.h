// Pictures of trees for reports: made on the CPU from counts and nodes.
#pragma once

#include <span>

#include "run/renderer.h"
#include "shared/step_count.h"
#include "tree/kd_tree.h"

namespace cleave {

// Nodes and leaves that each ray of scene/ray_sets.h, primaryRays, visited, on the scale of shared/shade.h,
// scaleColour, from 0 to `high`; with its legend. `size` is a multiple of 8.
Picture stepsPicture(std::span<const StepCount> steps, uint32_t size, float high);
// Triangles in the leaf of the hit, the same; misses are nearly white.
Picture leavesPicture(std::span<const StepCount> steps, std::span<const Hit> hits, uint32_t size, float high);

// Axes: across the plane, to the right and up in the picture.
struct Cut {
    int across = 2, right = 0, up = 1;
};
// A plane across the box's shortest axis shows most of it.
Cut cutOf(const KdTree& tree);

// The cells that the plane through the middle of the box cuts: coloured by the triangles of their
// leaf, nearly white without any; edges are drawn where cells are large enough. The longer side has `size` pixels.
Picture cutPicture(const KdTree& tree, const Cut& cut, uint32_t size, float high);

}  // namespace cleave
