// Trees in files: info --save-tree, and --tree of the commands that walk one.
#pragma once

#include <filesystem>
#include <span>

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

void saveTree(const std::filesystem::path& file, const KdTree& tree, std::span<const Triangle> world);
// Throws Error, naming the file, unless it is whole and holds a tree of these triangles. `world` is what `set` was made
// of.
KdTree readTree(const std::filesystem::path& file, std::span<const Triangle> world, const TriangleSet& set);

}  // namespace cleave
