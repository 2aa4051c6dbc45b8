// Rays that look through what is not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "run/renderer.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"

namespace cleave::test {
namespace {

constexpr uint32_t kSeed = 9;

ImageCamera cameraAt(const glm::dvec3& eye, const glm::dvec3& forward, uint32_t size) {
    ImageCamera c{};
    c.eye = eye;
    c.forward = glm::normalize(forward);
    c.right = glm::normalize(glm::cross(c.forward, glm::dvec3(0.1, 1, 0)));
    c.up = glm::cross(c.right, c.forward);
    c.pixel = 0.8 / size;
    c.width = c.height = size;
    c.tMax = infinity();
    return c;
}

struct Shown {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<vec3> radiance;
};

Shown shown(const std::vector<Triangle>& world, const SurfaceData& data, const PictureRequest& request) {
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const DeviceSurfaces surfaces(device(), data);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    Renderer& renderer = sharedRenderer();
    EXPECT_EQ(renderer.render(*tree, triangles, surfaces, request).cappedRays, 0u);
    return {renderer.readRays(), renderer.readHits(), renderer.readRadiance()};
}

// The first hit of a ray, by testing each triangle by itself, that `counts`.
template <typename Counts>
Hit firstHit(const TriangleSet& set, const Ray& ray, const Counts& counts) {
    Hit first = missedHit();
    for (const uint32_t number : set.included) {
        const TriangleSet one = {{set.triangles[number]}, {0}, set.bounds, set.exponent, 0, 0};
        Hit hit = bruteForce(one, ray, Query::closest);
        if (hit.prim == kNone) continue;
        hit.prim = number;
        if ((hit.t < first.t || (hit.t == first.t && number < first.prim)) && counts(hit)) first = hit;
    }
    return first;
}

struct RandomScene {
    std::vector<Triangle> world = mixedTriangles(300, kSeed);
    SurfaceData data;

    // A third of the triangles is opaque, a third has an alpha that goes from corner to corner and is masked, a third
    // is seen from the front only.
    RandomScene() {
        std::mt19937 random(kSeed);
        std::uniform_real_distribution<float> unit(0.0f, 1.0f);
        data.materials = {plainMaterial(vec4(1.0f), vec3(0.0f), 0.0f, 1.0f, 0),
                          plainMaterial(vec4(1.0f), vec3(0.0f), 0.0f, 1.0f, kMaterialMask),
                          plainMaterial(vec4(1.0f), vec3(0.0f), 0.0f, 1.0f, kMaterialSingleSided)};
        data.parts = kPartColours;
        data.hasAlpha = data.singleSided = true;
        for (uint32_t i = 0; i < world.size(); ++i) data.surfaceOf.push_back(i % 3 | (i % 2 == 0 ? 0u : kMirrored));
        for (size_t i = 0; i < 3 * world.size(); ++i) data.colours.emplace_back(1, 1, 1, unit(random));
    }

    bool isSeen(const Ray& ray, const Hit& hit) const {
        const uint32_t material = hit.prim % 3;
        if (material == 1) {
            const vec4* c = &data.colours[3 * hit.prim];
            return c[0].w * (1.0f - hit.u - hit.v) + c[1].w * hit.u + c[2].w * hit.v >= 0.5f;
        }
        const Triangle& t = world[hit.prim];
        const glm::dvec3 normal = glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
        const bool clockwise = glm::dot(normal, glm::dvec3(ray.direction)) > 0.0;
        return material == 0 || clockwise == (hit.prim % 2 == 1);
    }
};

// Alpha that comes close to the cutoff may be rounded to either side.
TEST(Alpha, PrimaryHitsAreTheFirstThatCountInEveryTraversal) {
    const RandomScene scene;
    const TriangleSet set = makeTriangleSet(scene.world);
    PictureRequest request;
    request.camera = cameraAt({0.4, 0.5, 3.5}, {0.02, 0.01, -1}, 64);
    for (const Traversal traversal : {Traversal::restart, Traversal::shortStack, Traversal::stack}) {
        request.traversal = traversal;
        const Shown got = shown(scene.world, scene.data, request);
        size_t found = 0, passed = 0;
        for (size_t i = 0; i < got.rays.size(); ++i) {
            const Ray& ray = got.rays[i];
            const Hit want = firstHit(set, ray, [&](const Hit& hit) { return scene.isSeen(ray, hit); });
            EXPECT_EQ(got.hits[i].prim, want.prim) << "seed " << kSeed << ", ray " << i;
            EXPECT_EQ(got.hits[i].t, want.t);
            found += want.prim != kNone ? 1 : 0;
            passed += want.prim != bruteForce(set, ray, Query::closest).prim ? 1 : 0;
        }
        EXPECT_GT(found, got.rays.size() / 5);
        EXPECT_GT(passed, got.rays.size() / 20) << "rays that look through something";
    }
}

// A picture whose rays take many dispatches is the picture, here too.
TEST(Alpha, GoesOnWhereTheStepLimitEndedARay) {
    const RandomScene scene;
    const TriangleSet set = makeTriangleSet(scene.world);
    const DeviceTriangles triangles(device(), scene.world);
    const DeviceSurfaces surfaces(device(), scene.data);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    Tracer& tracer = sharedTracer();
    Renderer usual(device(), tracer), limited(device(), tracer, {.stepLimit = 5});
    PictureRequest request;
    request.camera = cameraAt({0.4, 0.5, 3.5}, {0.02, 0.01, -1}, 48);
    for (const uint32_t samples : {1u, 2u}) {
        request.samples = samples;
        EXPECT_EQ(limited.render(*tree, triangles, surfaces, request).pixels,
                  usual.render(*tree, triangles, surfaces, request).pixels);
    }
}

std::vector<Triangle> square(float z) {
    return {{{-1, -1, z}, {1, -1, z}, {-1, 1, z}}, {{1, 1, z}, {-1, 1, z}, {1, -1, z}}};
}

SurfaceData twoSquares(const Material& front) {
    SurfaceData data;
    data.surfaceOf = {0, 0, 1, 1};
    data.materials = {front, plainMaterial({0, 0, 0, 1}, {1, 1, 1}, 0.0f, 1.0f, 0)};
    data.hasAlpha = !isOpaque(front);
    data.singleSided = (front.flags & kMaterialSingleSided) != 0;
    return data;
}

// A square before one that shines: what comes through is the share that the alpha leaves.
TEST(Alpha, BlendLetsItsShareThrough) {
    std::vector<Triangle> world = square(0.0f);
    for (const Triangle& t : square(-1.0f)) world.push_back(t);
    PictureRequest request;
    request.view = View::path;
    request.camera = cameraAt({0, 0, 3}, {0, 0, -1}, 16);
    request.camera.pixel = 0.01;
    request.samples = 64;
    request.seed = kSeed;
    for (const float alpha : {0.0f, 0.3f, 1.0f}) {
        const SurfaceData data = twoSquares(plainMaterial({0, 0, 0, alpha}, vec3(0.0f), 0.0f, 1.0f, kMaterialBlend));
        double sum = 0.0;
        const std::vector<vec3> radiance = shown(world, data, request).radiance;
        for (const vec3& pixel : radiance) sum += double{pixel.x};
        const double mean = sum / static_cast<double>(radiance.size());
        const double deviation = std::sqrt(double{alpha} * (1.0 - double{alpha}) / (64.0 * 256.0));
        std::printf("seed %u: alpha %.1f lets %.4f through\n", kSeed, double{alpha}, mean);
        // A black surface shows a little of the other's light, by its specular lobe.
        EXPECT_NEAR(mean, 1.0 - double{alpha}, 4.0 * deviation + 0.03 * double{alpha});
    }
}

// Under a light, half of the floor lies in the shadow of a fence whose alpha is 0.25.
TEST(Alpha, ShadowsAreAsDenseAsTheAlpha) {
    std::vector<Triangle> world = square(0.0f);
    for (const Triangle& t : square(1.0f)) world.push_back(t);
    PictureRequest request;
    request.view = View::path;
    request.bounces = 1;
    request.camera = cameraAt({0, 0, 0.5}, {0, 0, -1}, 16);
    request.camera.pixel = 0.01;
    request.samples = 64;
    request.seed = kSeed;
    request.lighting.lights = {{{0, 0, 50}, kLightPoint, {0, 0, -1}, 0.0f, vec3(3000.0f), infinity(), 0, 0}};
    const auto light = [&](float alpha) {
        SurfaceData data = twoSquares(plainMaterial(vec4(1.0f), vec3(0.0f), 0.0f, 1.0f, 0));
        data.materials[1] = plainMaterial({0, 0, 0, alpha}, vec3(0.0f), 0.0f, 1.0f, kMaterialBlend);
        data.hasAlpha = true;
        double sum = 0.0;
        for (const vec3& pixel : shown(world, data, request).radiance) sum += double{pixel.x};
        return sum;
    };
    EXPECT_NEAR(light(0.25f) / light(0.0f), 0.75, 4.0 * std::sqrt(0.25 * 0.75 / (64.0 * 256.0)));
    EXPECT_EQ(light(1.0f), 0.0);
}

// Cameras look through the back of a single-sided square, light does not.
TEST(Alpha, BacksAreHiddenFromCamerasOnly) {
    std::vector<Triangle> world = square(0.0f);
    for (const Triangle& t : square(-1.0f)) world.push_back(t);
    const Material black = plainMaterial({0, 0, 0, 1}, vec3(0.0f), 0.0f, 1.0f, kMaterialSingleSided);
    PictureRequest request;
    request.view = View::path;
    request.bounces = 0;
    const auto shows = [&](double side, SurfaceData data, bool turned) {
        if (turned) data.surfaceOf[0] = data.surfaceOf[1] = kMirrored;
        request.camera = cameraAt({0, 0, 3 * side}, {0, 0, -side}, 8);
        request.camera.pixel = 0.01;
        return double{shown(world, data, request).radiance[20].x};
    };
    EXPECT_EQ(shows(1, twoSquares(black), false), 0.0);
    EXPECT_EQ(shows(1, twoSquares(black), true), 1.0);
    request.bounces = 1;
    request.camera = cameraAt({0, 0, -0.5}, {0, 0, -1}, 8);
    request.lighting.lights = {{{0, 0, 9}, kLightPoint, {0, 0, -1}, 0.0f, vec3(3000.0f), infinity(), 0, 0}};
    SurfaceData data = twoSquares(black);
    data.materials[1] = plainMaterial(vec4(1.0f), vec3(0.0f), 0.0f, 1.0f, 0);
    data.surfaceOf[0] = data.surfaceOf[1] = kMirrored;  // its front is towards the lit floor
    EXPECT_EQ(double{shown(world, data, request).radiance[20].x}, 0.0) << "light is stopped";
}

}  // namespace
}  // namespace cleave::test
