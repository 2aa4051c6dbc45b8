// Closed surfaces, and points strictly inside them: a ray from there must hit in every direction.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shared/triangle.h"
#include "stability/random.h"

namespace cleave {

struct ClosedMesh {
    std::string_view name;
    std::vector<Triangle> triangles;
    std::vector<vec3> inside;  // far from the surface, measured by the rounding of its vertices
};

// Each edge of each mesh belongs to two of its faces, to the bit.
std::vector<ClosedMesh> closedMeshes(uint64_t seed);

// Rays from inside: half of them at vertices, a quarter at points of edges, the others at points of faces, all rounded
// as a user's aiming rounds.
std::vector<Ray> leakRays(const ClosedMesh& mesh, uint64_t count, uint64_t seed);

// Meshes with triangles of no area: vertices on a coarse lattice, where many coincide or lie in line. They have no
// points inside.
std::vector<ClosedMesh> closedSlivers(uint64_t seed);

// Lines from outside of the mesh that go through all of it: half of them at vertices, a quarter at points of edges, the
// others at points of faces; of each a quarter along an axis, a quarter through a second vertex.
std::vector<Ray> linesThrough(const ClosedMesh& mesh, uint64_t count, uint64_t seed);

struct Parity {
    uint64_t lines = 0;
    uint64_t odd = 0;     // cross the surface an odd number of times
    uint64_t uneven = 0;  // leave it more or less often than they enter it
    Ray first{};          // the first of these
};
// Adds the signed counts of some of the lines.
void addParity(Parity& parity, std::span<const Ray> lines, std::span<const int32_t> counts);

struct Leaks {
    uint64_t rays = 0;
    uint64_t leaks = 0;  // misses
    Ray first{};         // the first ray that leaked
};
// Adds the answers to some of the rays.
void countLeaks(Leaks& leaks, std::span<const Ray> rays, std::span<const Hit> hits);

}  // namespace cleave
