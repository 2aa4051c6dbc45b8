#include "scene/ray_sets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/camera.h"

namespace cleave {
namespace {

constexpr uint32_t kTile = 8;
constexpr float kFar = 1e30f;
constexpr uint32_t kDiffuseSeed = 0x01234567u;
constexpr uint32_t kShadowSeed = 0x089ABCDEu;

dvec3 extentOf(const Box& bounds) { return isEmpty(bounds) ? dvec3(0.0) : dvec3(bounds.hi) - dvec3(bounds.lo); }
dvec3 centreOf(const Box& bounds) { return isEmpty(bounds) ? dvec3(0.0) : 0.5 * (dvec3(bounds.lo) + dvec3(bounds.hi)); }

// 24 bits of a hash, in [0, 1).
double unitInterval(uint32_t hash) { return (hash >> 8) / 16777216.0; }

// Two vectors that make a right-handed frame with a unit normal (Duff et al. 2017, "Building an orthonormal basis,
// revisited").
void orthonormalBasis(const dvec3& n, dvec3& b1, dvec3& b2) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    b1 = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    b2 = {b, sign + n.y * n.y * a, -n.y};
}

// Cosine-weighted about the normal: Malley's method, a uniform point of the disc, lifted to the hemisphere.
dvec3 cosineDirection(const dvec3& normal, double u1, double u2) {
    dvec3 b1;
    dvec3 b2;
    orthonormalBasis(normal, b1, b2);
    const double radius = std::sqrt(u1);
    const double angle = 2.0 * std::numbers::pi * u2;
    return radius * std::cos(angle) * b1 + radius * std::sin(angle) * b2 + std::sqrt(1.0 - u1) * normal;
}

// The side of a box, 0 to 5 (twice the axis that it is across, one more for the upper), that a number in [0, 1) picks
// in proportion to its area.
int sideByArea(const dvec3& extent, double u) {
    const dvec3 areas(extent.y * extent.z, extent.z * extent.x, extent.x * extent.y);
    double left = u * 2.0 * (areas.x + areas.y + areas.z);
    int last = 0;
    for (int side = 0; side < 6; ++side) {
        if (areas[side / 2] == 0.0) continue;
        last = side;
        if (left < areas[side / 2]) break;
        left -= areas[side / 2];
    }
    return last;
}

// For each j below size * size: ray(point j mod n, j).
template <typename MakeRay>
std::vector<Ray> fromPoints(std::span<const SurfacePoint> points, uint32_t size, const MakeRay& ray) {
    std::vector<Ray> rays;
    if (points.empty()) return rays;
    const uint32_t count = size * size;
    rays.reserve(count);
    for (uint32_t j = 0; j < count; ++j) rays.push_back(ray(points[j % points.size()], j));
    return rays;
}

}  // namespace

uint32_t pcg(uint32_t x) {
    const uint32_t state = 747796405u * x + 2891336453u;
    const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

double rnd(uint32_t seed, uint32_t j, uint32_t k) { return unitInterval(pcg(pcg(4u * j + k) ^ seed)); }

Camera interiorCamera(const Box& bounds) {
    const dvec3 c = centreOf(bounds);
    const dvec3 e = extentOf(bounds);
    const dvec3 lo = c - 0.5 * e;
    return lookAt({c.x + 0.25 * e.x, lo.y + 0.30 * e.y, c.z + 0.02 * e.z}, {lo.x, lo.y + 0.35 * e.y, c.z},
                  75.0 * std::numbers::pi / 180.0);
}

std::vector<Ray> primaryRays(const Box& bounds, bool interior, uint32_t size) {
    const ImageCamera image = imageCamera(interior ? interiorCamera(bounds) : defaultCamera(bounds), size, size, kFar);
    std::vector<Ray> rays;
    rays.reserve(size_t(size) * size);
    for (uint32_t tileY = 0; tileY < size; tileY += kTile)
        for (uint32_t tileX = 0; tileX < size; tileX += kTile)
            for (uint32_t y = tileY; y < std::min(tileY + kTile, size); ++y)
                for (uint32_t x = tileX; x < std::min(tileX + kTile, size); ++x)
                    rays.push_back(imageRay(image, x + 0.5, y + 0.5));
    return rays;
}

std::vector<SurfacePoint> surfacePoints(std::span<const Triangle> world, const Box& bounds, std::span<const Ray> rays,
                                        std::span<const Hit> hits) {
    const double step = 1e-4 * glm::length(extentOf(bounds));
    std::vector<SurfacePoint> points;
    for (size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].prim == kNone) continue;
        const Triangle& triangle = world[hits[i].prim];
        const dvec3 origin(rays[i].origin);
        const dvec3 direction(rays[i].direction);
        const dvec3 a(triangle.a);
        dvec3 normal = glm::normalize(glm::cross(dvec3(triangle.b) - a, dvec3(triangle.c) - a));
        if (glm::dot(normal, direction) > 0.0) normal = -normal;
        const double t = glm::dot(normal, a - origin) / glm::dot(normal, direction);
        points.push_back({origin + t * direction + step * normal, normal});
    }
    return points;
}

std::vector<Ray> diffuseRays(std::span<const SurfacePoint> points, uint32_t size) {
    return fromPoints(points, size, [](const SurfacePoint& point, uint32_t j) {
        const dvec3 direction = cosineDirection(point.normal, rnd(kDiffuseSeed, j, 0), rnd(kDiffuseSeed, j, 1));
        return Ray{vec3(point.position), 0.0f, vec3(direction), kFar};
    });
}

std::vector<Ray> shadowRays(std::span<const SurfacePoint> points, const Box& bounds, uint32_t size) {
    const double diagonal = glm::length(extentOf(bounds));
    const dvec3 light = centreOf(bounds) + diagonal * glm::normalize(dvec3(-0.4, 0.8, 0.5));
    return fromPoints(points, size, [&](const SurfacePoint& point, uint32_t j) {
        const dvec3 random(rnd(kShadowSeed, j, 0), rnd(kShadowSeed, j, 1), rnd(kShadowSeed, j, 2));
        const dvec3 way = light + 0.1 * diagonal * (random - 0.5) - point.position;
        const double distance = glm::length(way);
        return Ray{vec3(point.position), 0.0f, vec3(way / distance), float(distance)};
    });
}

// A line that meets a convex body enters it at a point that is uniform on the surface, at an angle from the inward
// normal that is cosine-weighted (Santalo 1976, "Integral geometry and geometric probability").
std::vector<Ray> uniformLines(const Box& bounds, uint32_t count, uint32_t seed) {
    const dvec3 extent = extentOf(bounds);
    std::vector<Ray> lines;
    if (extent.x * extent.y + extent.y * extent.z + extent.z * extent.x == 0.0) return lines;
    lines.reserve(count);
    for (uint32_t j = 0; j < count; ++j) {
        const int side = sideByArea(extent, rnd(~seed, j, 0)), axis = side / 2;
        const bool upper = side % 2 == 1;
        dvec3 place(rnd(seed, j, 0), rnd(seed, j, 0), rnd(seed, j, 0));
        place[(axis + 1) % 3] = rnd(seed, j, 1);
        place[axis] = upper ? 1.0 : 0.0;
        dvec3 inward(0.0);
        inward[axis] = upper ? -1.0 : 1.0;
        const dvec3 direction = cosineDirection(inward, rnd(seed, j, 2), rnd(seed, j, 3));
        const dvec3 start = dvec3(bounds.lo) + place * extent - 0.1 * glm::length(extent) * direction;
        lines.push_back({vec3(start), 0.0f, vec3(direction), kFar});
    }
    return lines;
}

std::vector<Triangle> soup(uint32_t n) {
    auto u = [](uint32_t k) { return unitInterval(pcg(k)); };
    std::vector<Triangle> triangles(n);
    for (uint32_t t = 0; t < n; ++t) {
        vec3* const vertices[3] = {&triangles[t].a, &triangles[t].b, &triangles[t].c};
        for (uint32_t c = 0; c < 3; ++c)
            for (uint32_t axis = 0; axis < 3; ++axis)
                (*vertices[c])[int(axis)] = float(u(12 * t + axis) + 0.01 * (u(12 * t + 3 + 3 * c + axis) - 0.5));
    }
    return triangles;
}

}  // namespace cleave
