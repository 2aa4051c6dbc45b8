// Building blocks of the cases. Vertices are shared by index, so that faces meet in the very same floats.
#pragma once

#include <functional>
#include <vector>

#include "shared/triangle.h"
#include "stability/random.h"

namespace cleave {

struct Mesh {
    std::vector<dvec3> vertices;
    std::vector<glm::uvec3> faces;
};

// Each vertex is rounded to float once.
std::vector<Triangle> trianglesOf(const Mesh& mesh);
// The same with each vertex moved by `place` before that.
Mesh moved(Mesh mesh, const std::function<dvec3(const dvec3&)>& place);
inline Mesh moved(Mesh mesh, const dvec3& factor, const dvec3& offset) {
    return moved(std::move(mesh), [&](const dvec3& v) { return v * factor + offset; });
}
void append(std::vector<Triangle>& to, const std::vector<Triangle>& more);

// Closed; 20 * 4^level faces on the unit sphere about the origin.
Mesh icosphere(uint32_t level);
// Closed; the surface of the cube from -1 to 1, n x n squares a side, two faces each.
Mesh cube(uint32_t n);
// Closed; the cube's sides as fans of 4 n faces around a vertex inside of each; n is a power of two.
Mesh fanCube(uint32_t n);
// Closed; a tube of radius 0.25 around the (2, 3) torus knot, about 3 across; ringCentre lies on its middle line.
Mesh torusKnot(uint32_t rings, uint32_t sides);
dvec3 knotCentre(uint32_t ring, uint32_t rings);
// Open; the square from -1 to 1 in the plane y = 0, n x n squares.
Mesh sheet(uint32_t n);
// `count` triangles of about `size` in the unit cube.
std::vector<Triangle> looseTriangles(Random& random, uint32_t count, double size);

}  // namespace cleave
