#include "scene/ray_sets.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "scene/camera.h"

namespace cleave {
namespace {

constexpr Box kUnit{vec3(0), vec3(1)};

// FNV-1a over the bits of all rays.
uint64_t hashOf(const std::vector<Ray>& rays) {
    uint64_t hash = 14695981039346656037ull;
    auto add = [&](float x) {
        const uint32_t bits = floatBitsToUint(x);
        for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (bits >> shift & 0xFFu)) * 1099511628211ull;
    };
    for (const Ray& ray : rays)
        for (float x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.tMin, ray.direction.x, ray.direction.y,
                        ray.direction.z, ray.tMax})
            add(x);
    return hash;
}

// The floor of the unit cube, seen by `size` * `size` primary rays; hits are worked out here.
struct Floor {
    std::vector<Triangle> world = {{vec3(0), vec3(1, 0, 0), vec3(1, 0, 1)}, {vec3(0), vec3(1, 0, 1), vec3(0, 0, 1)}};
    std::vector<Ray> rays = primaryRays(kUnit, false, 64);
    std::vector<Hit> hits;
    std::vector<SurfacePoint> points;

    Floor() {
        for (const Ray& ray : rays) {
            Hit best = missedHit();
            for (uint32_t i = 0; i < 2; ++i) {
                Hit hit = intersectTriangle(ray.origin, ray.direction, world[i]);
                hit.prim = isFinite(hit.t) ? i : kNone;
                if (isCloser(hit, best)) best = hit;
            }
            hits.push_back(best);
        }
        points = surfacePoints(world, kUnit, rays, hits);
    }
};

// Worked out by an independent script.
TEST(RaySets, randomNumbersAreTheAgreedOnes) {
    EXPECT_EQ(pcg(0), 129708002u);
    EXPECT_EQ(pcg(1), 2831084092u);
    EXPECT_EQ(pcg(0xFFFFFFFFu), 3861530882u);
    EXPECT_EQ(rnd(0x01234567u, 0, 0), 0.9217170476913452);
    EXPECT_EQ(rnd(0x01234567u, 5, 1), 0.6582895517349243);
    EXPECT_EQ(rnd(0x089ABCDEu, 7, 2), 0.7471552491188049);
}

TEST(RaySets, soupIsTheAgreedOne) {
    const std::vector<Triangle> triangles = soup(4);
    ASSERT_EQ(triangles.size(), 4u);
    EXPECT_EQ(triangles[3].a, vec3(0.24600495398044586f, 0.08457393199205399f, 0.24137447774410248f));
    EXPECT_EQ(triangles[3].b, vec3(0.24489587545394897f, 0.08540072292089462f, 0.2413162887096405f));
    EXPECT_EQ(triangles[3].c, vec3(0.251568466424942f, 0.0855700671672821f, 0.23643916845321655f));
}

TEST(RaySets, primaryRaysGoTileByTile) {
    const std::vector<Ray> rays = primaryRays(kUnit, false, 20);  // 8 + 8 + 4 pixels: the last tiles are cut
    const Camera camera = defaultCamera(kUnit);
    ASSERT_EQ(rays.size(), 400u);
    auto at = [&](double x, double y) {
        return imageRay(imageCamera(camera, 20, 20, 1e30f), x + 0.5, y + 0.5).direction;
    };
    EXPECT_EQ(rays[0].direction, at(0, 0));
    EXPECT_EQ(rays[9].direction, at(1, 1));
    EXPECT_EQ(rays[64].direction, at(8, 0));
    EXPECT_EQ(rays[128].direction, at(16, 0));
    EXPECT_EQ(rays[160].direction, at(0, 8));
    EXPECT_EQ(rays[399].direction, at(19, 19));
    for (const Ray& ray : rays) {
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
        EXPECT_EQ(ray.tMax, 1e30f);
    }
}

TEST(RaySets, interiorRaysStandInTheRoom) {
    const Box room{vec3(-4, 0, -2), vec3(4, 10, 2)};
    const std::vector<Ray> rays = primaryRays(room, true, 2);
    EXPECT_NEAR(glm::distance(rays[0].origin, vec3(2.0f, 3.0f, 0.08f)), 0.0f, 1e-6f);
    vec3 middle(0);  // the four rays are symmetric about the view direction
    for (const Ray& ray : rays) middle += ray.direction;
    const vec3 forward = glm::normalize(vec3(-4.0f, 3.5f, 0.0f) - vec3(2.0f, 3.0f, 0.08f));
    EXPECT_NEAR(glm::distance(glm::normalize(middle), forward), 0.0f, 1e-6f);
    // Pixel centres lie halfway out: tan = tan(37.5 degrees) / 2 either way.
    const float slope = float(std::tan(37.5 * std::numbers::pi / 180.0) / 2.0);
    EXPECT_NEAR(glm::dot(rays[0].direction, forward), 1.0f / std::sqrt(1.0f + 2.0f * slope * slope), 1e-6f);
}

TEST(RaySets, pointsLieOffTheSurfaceOnTheRaysSide) {
    const Floor floor;
    const double step = 1e-4 * std::sqrt(3.0);
    ASSERT_GT(floor.points.size(), 100u);
    size_t next = 0;
    for (size_t i = 0; i < floor.hits.size(); ++i) {
        if (floor.hits[i].prim == kNone) continue;
        const SurfacePoint& point = floor.points[next++];
        EXPECT_EQ(point.normal, dvec3(0, 1, 0));  // though the triangles' own normals point down
        EXPECT_NEAR(point.position.y, step, 1e-15);
        const dvec3 hit = dvec3(floor.rays[i].origin) + double(floor.hits[i].t) * dvec3(floor.rays[i].direction);
        EXPECT_NEAR(point.position.x, hit.x, 1e-6);
        EXPECT_NEAR(point.position.z, hit.z, 1e-6);
    }
    EXPECT_EQ(next, floor.points.size());
}

TEST(RaySets, diffuseRaysAreCosineWeighted) {
    const Floor floor;
    const std::vector<Ray> rays = diffuseRays(floor.points, 256);
    ASSERT_EQ(rays.size(), 65536u);
    dvec3 sum(0.0);
    double squares = 0.0;
    for (size_t j = 0; j < rays.size(); ++j) {
        EXPECT_EQ(rays[j].origin, vec3(floor.points[j % floor.points.size()].position));
        EXPECT_NEAR(glm::length(rays[j].direction), 1.0f, 1e-6f);
        EXPECT_GE(rays[j].direction.y, 0.0f);
        sum += dvec3(rays[j].direction);
        squares += double(rays[j].direction.y) * double(rays[j].direction.y);
    }
    // Density cos / pi: the mean is 2/3 along the normal and 0 across it, the mean of cos^2 is 1/2. Four standard
    // deviations of the mean of 65536.
    const dvec3 mean = sum / double(rays.size());
    EXPECT_NEAR(mean.y, 2.0 / 3.0, 4.0 * 0.2357 / 256.0);
    EXPECT_NEAR(mean.x, 0.0, 4.0 * 0.5 / 256.0);
    EXPECT_NEAR(mean.z, 0.0, 4.0 * 0.5 / 256.0);
    EXPECT_NEAR(squares / double(rays.size()), 0.5, 4.0 * 0.2887 / 256.0);
}

// Diffuse directions about any normal lie on its side: the basis is orthonormal also near -z, where it changes sign.
TEST(RaySets, diffuseRaysFollowTheNormal) {
    for (const dvec3& n : {dvec3(0, 0, 1), dvec3(0, 0, -1), dvec3(1, 0, 0), dvec3(0.6, -0.8, 0), dvec3(0, -1, -1e-9)}) {
        const SurfacePoint point{dvec3(0), glm::normalize(n)};
        dvec3 sum(0.0);
        const std::vector<Ray> rays = diffuseRays({&point, 1}, 64);
        for (const Ray& ray : rays) {
            EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
            EXPECT_GE(glm::dot(dvec3(ray.direction), point.normal), -1e-7);
            sum += dvec3(ray.direction);
        }
        EXPECT_NEAR(glm::distance(sum / double(rays.size()), 2.0 / 3.0 * point.normal), 0.0, 0.04);
    }
}

TEST(RaySets, shadowRaysEndAtTheLight) {
    const Floor floor;
    const double diagonal = std::sqrt(3.0);
    const dvec3 light = dvec3(0.5) + diagonal * glm::normalize(dvec3(-0.4, 0.8, 0.5));
    dvec3 low(1e9);
    dvec3 high(-1e9);
    for (const Ray& ray : shadowRays(floor.points, kUnit, 64)) {
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
        const dvec3 end = dvec3(ray.origin) + double(ray.tMax) * dvec3(ray.direction);
        low = glm::min(low, end - light);
        high = glm::max(high, end - light);
    }
    for (int axis = 0; axis < 3; ++axis) {  // the light is a cube of a tenth of the diagonal, and all of it is used
        EXPECT_NEAR(low[axis], -0.05 * diagonal, 1e-3);
        EXPECT_NEAR(high[axis], 0.05 * diagonal, 1e-3);
    }
}

TEST(RaySets, areEmptyWithoutHits) {
    EXPECT_TRUE(diffuseRays({}, 8).empty());
    EXPECT_TRUE(shadowRays({}, kUnit, 8).empty());
}

// Cauchy: the mean length of uniformly distributed lines within a convex body is 4 volumes over its surface.
TEST(RaySets, uniformLinesHaveTheMeanChordOfTheBox) {
    const vec3 corner(3.0f, -1.0f, 0.5f);
    for (const vec3& extent : {vec3(1, 1, 1), vec3(4, 2, 1), vec3(10, 0.1f, 0.3f)}) {
        const Box box{corner, corner + extent};
        const std::vector<Ray> lines = uniformLines(box, 20000, 7);
        ASSERT_EQ(lines.size(), 20000u);
        double sum = 0.0, squares = 0.0;
        for (const Ray& line : lines) {
            double from = -1e30, to = 1e30;
            for (int axis = 0; axis < 3; ++axis) {
                const double a = (double{box.lo[axis]} - line.origin[axis]) / line.direction[axis];
                const double b = (double{box.hi[axis]} - line.origin[axis]) / line.direction[axis];
                from = std::max(from, std::min(a, b));
                to = std::min(to, std::max(a, b));
            }
            EXPECT_GT(from, 0.0) << "starts before the box";
            sum += std::max(to - from, 0.0);
            squares += (to - from) * (to - from);
        }
        const double count = static_cast<double>(lines.size()), mean = sum / count;
        const double error = std::sqrt((squares / count - mean * mean) / count);
        const double volume = double{extent.x} * extent.y * extent.z;
        const double surface =
            2.0 * (double{extent.x} * extent.y + double{extent.y} * extent.z + double{extent.z} * extent.x);
        EXPECT_NEAR(mean, 4.0 * volume / surface, 4.0 * error);
        std::printf("seed 7: mean chord %.5f, expected %.5f, standard error %.5f\n", mean, 4.0 * volume / surface,
                    error);
    }
}

TEST(RaySets, uniformLinesOfAFlatBoxCrossIt) {
    for (const Ray& line : uniformLines({vec3(0), vec3(1, 0, 1)}, 100, 1)) {
        const double t = -double{line.origin.y} / line.direction.y;
        EXPECT_NEAR(line.origin.x + t * line.direction.x, 0.5, 0.5 + 1e-5);
        EXPECT_NEAR(line.origin.z + t * line.direction.z, 0.5, 0.5 + 1e-5);
    }
    EXPECT_TRUE(uniformLines({vec3(0), vec3(1, 0, 0)}, 100, 1).empty()) << "no area, no lines";
    EXPECT_TRUE(uniformLines(emptyBox(), 100, 1).empty());
}

// Fixed for good: published figures rest on them. Primary and shadow rays use only operations that IEEE 754 rounds
// exactly, but for the tangent; diffuse rays use sine and cosine of the C library and are left out.
TEST(RaySets, areFixed) {
    const Floor floor;
    EXPECT_EQ(hashOf(primaryRays(kUnit, false, 64)), 5743815558633666491ull);
    EXPECT_EQ(hashOf(primaryRays(kUnit, true, 64)), 1897895112267101477ull);
    EXPECT_EQ(hashOf(shadowRays(floor.points, kUnit, 64)), 4102275122011454443ull);
}

}  // namespace
}  // namespace cleave
