// The ray sets that benchmarks shoot: fixed, so that figures compare across programs. All arithmetic is in double,
// rounded to float once. A set has size * size rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/box.h"
#include "shared/ray.h"
#include "shared/triangle.h"

namespace cleave {

constexpr uint32_t kRaySetSize = 1024;

// A permuted congruential generator as a hash (Jarzynski and Olano 2020): one step of pcg's LCG, one output function.
uint32_t pcg(uint32_t x);
// Uniform in [0, 1), with 24 bits: number k of ray j.
double rnd(uint32_t seed, uint32_t j, uint32_t k);

// The default camera's rays, in tiles of 8 x 8 pixels, t in [0, 1e30]; `bounds` of the finite triangles, in the world.
// `interior` stands inside of a room and looks at its far wall.
std::vector<Ray> primaryRays(const Box& bounds, bool interior = false, uint32_t size = kRaySetSize);

// Where secondary rays start: primary hits, in order. Each has its point moved off the surface, to the ray's side.
struct SurfacePoint {
    dvec3 position;
    dvec3 normal;  // unit length, towards the origin of the ray
};
// `world` triangles; hits[i] answers rays[i].
std::vector<SurfacePoint> surfacePoints(std::span<const Triangle> world, const Box& bounds, std::span<const Ray> rays,
                                        std::span<const Hit> hits);

// Ray j starts at point j mod n; no points, no rays. Diffuse: cosine-weighted about the normal, for closest hits.
std::vector<Ray> diffuseRays(std::span<const SurfacePoint> points, uint32_t size = kRaySetSize);
// Towards a large light outside of the scene, tMax its distance; for any hit.
std::vector<Ray> shadowRays(std::span<const SurfacePoint> points, const Box& bounds, uint32_t size = kRaySetSize);

// n small triangles, evenly spread in the unit cube.
std::vector<Triangle> soup(uint32_t n);

}  // namespace cleave
