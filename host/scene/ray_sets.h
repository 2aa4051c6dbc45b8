// Makes the ray sets that benchmarks shoot. They are fixed, so that figures compare across programs: computed in
// double, rounded to float once. A set has size * size rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/box.h"
#include "shared/ray.h"
#include "shared/triangle.h"

namespace cleave {

struct Camera;

constexpr uint32_t kRaySetSize = 1024;

// Hashes by a permuted congruential generator (Jarzynski and Olano 2020): one step of pcg's LCG, one output function.
uint32_t pcg(uint32_t x);
// Returns number k of ray j, uniform in [0, 1), with 24 bits.
double rnd(uint32_t seed, uint32_t j, uint32_t k);

// Stands inside of a room and looks at its far wall.
Camera interiorCamera(const Box& bounds);

// Returns the default camera's rays, in tiles of 8 x 8 pixels, t in [0, 1e30]; `bounds` of the finite triangles, in the
// world. `interior`: interiorCamera's.
std::vector<Ray> primaryRays(const Box& bounds, bool interior = false, uint32_t size = kRaySetSize);

// A start of secondary rays: a primary hit, whose point is moved off the surface, to the ray's side.
struct SurfacePoint {
    dvec3 position;
    dvec3 normal;  // unit length, towards the origin of the ray
};
// Returns the points of all hits, in order, on `world` triangles; hits[i] answers rays[i].
std::vector<SurfacePoint> surfacePoints(std::span<const Triangle> world, const Box& bounds, std::span<const Ray> rays,
                                        std::span<const Hit> hits);

// Returns rays for closest hits, cosine-weighted about the normal. Ray j starts at point j mod n; no points, no rays.
std::vector<Ray> diffuseRays(std::span<const SurfacePoint> points, uint32_t size = kRaySetSize);
// Returns rays for any hit, towards a large light outside of the scene, whose distance is tMax.
std::vector<Ray> shadowRays(std::span<const SurfacePoint> points, const Box& bounds, uint32_t size = kRaySetSize);

// Returns rays along lines that are uniformly distributed among those that meet the box, as the surface area heuristic
// has them: isotropic, from before the box, without an end. No box, no rays.
std::vector<Ray> uniformLines(const Box& bounds, uint32_t count, uint32_t seed);

// Returns n small triangles, evenly spread in the unit cube.
std::vector<Triangle> soup(uint32_t n);

}  // namespace cleave
