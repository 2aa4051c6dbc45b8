// Cells of a tree in the world, to be drawn over a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "shared/ray.h"
#include "tree/kd_tree.h"

namespace cleave {

struct WorldBox {
    glm::dvec3 lo{0.0};
    glm::dvec3 hi{0.0};
};

// The part of a split plane that lies in its node's cell.
struct CutPlane {
    WorldBox box;  // flat along the plane's axis
    uint32_t axis = 0;
    uint32_t depth = 0;  // of the node that is cut
};

// The root's cell.
WorldBox rootCell(const KdTree& tree);

// The planes of all nodes above `level`, whose edges, with the root's, are those of all cells down to that level.
// At most `most` of them, upper levels first.
std::vector<CutPlane> cutPlanes(const KdTree& tree, uint32_t level, size_t most);

// A leaf that a ray passes.
struct PassedLeaf {
    WorldBox box;
    uint32_t depth = 0;
    uint32_t triangles = 0;
    double entry = 0.0;  // t of the ray, which is in the cell from here
    double exit = 0.0;   // to here
};

// The leaves that a ray passes, near ones first, within its interval. Rays with direction 0 pass none. In double, so
// that what touches a cell's edge alone may be told or not.
std::vector<PassedLeaf> leavesAlong(const KdTree& tree, const Ray& ray);

}  // namespace cleave
