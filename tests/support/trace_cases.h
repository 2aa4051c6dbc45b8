// Rays of every kind, and what is expected of a trace kernel's answers to them.
#pragma once

#include <vector>

#include "run/tracer.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave::test {

// Random ones, axis-parallel ones through grid points, zero and -0 components, in planes of the grid, from vertices,
// with short intervals, of any length of direction; and some that are none.
std::vector<Ray> mixedRays(uint32_t n, uint32_t seed);

// Expects the same hits, bit by bit, but for which triangle an any-hit query finds.
void expectSameHits(const std::vector<Hit>& got, const std::vector<Hit>& want, Query query);

// Closest hits equal those of brute force and of the plainest walk with ==, whether steps are counted or not; any-hit
// queries agree on whether there is one; no ray is given up.
void expectAnswers(const TriangleSet& set, const KdTree& tree, const std::vector<Ray>& rays, Traversal traversal);

// The same over sets of no triangle to 500, with trees by exact and by spatial-median.
void expectAnswersOverTrees(Traversal traversal);

// Rays that start exactly in a triangle, at points with whole coordinates of slanted planes, where double arithmetic
// has them before or behind it: each hits its triangle, or one of a lower number that crosses it there, at t = 0.
void expectHitsAtZero(Traversal traversal);

// A chain of planes down to the deepest leaf that a tree may have. Each cell on the way holds a triangle, so that a
// cell that is passed over shows; a ray along the chain leaves a child behind at every plane.
struct DeepChain {
    TriangleSet set;
    KdTree tree;
    std::vector<Ray> rays;
};
DeepChain deepChain();

}  // namespace cleave::test
