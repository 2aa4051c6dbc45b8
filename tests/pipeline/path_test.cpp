// Whole pictures of paths where the light that they show is known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "render/albedo_table.h"
#include "render/alias_table.h"
#include "shared/tone.h"
#include "support/lit_world.h"
#include "support/runners.h"

namespace cleave::test {

namespace {

constexpr uint32_t kSeed = 5;
constexpr vec3 kBlack{0.0f};

// A sphere of radius 1 about the origin from subdivided octahedra: closed and convex.
std::vector<Triangle> sphere(int subdivisions) {
    const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<Triangle> all;
    for (const vec3& a : {x, -x})
        for (const vec3& b : {y, -y})
            for (const vec3& c : {z, -z}) all.push_back({a, b, c});
    for (int i = 0; i < subdivisions; ++i) {
        std::vector<Triangle> finer;
        for (const Triangle& t : all) {
            const vec3 ab = glm::normalize(t.a + t.b), bc = glm::normalize(t.b + t.c), ca = glm::normalize(t.c + t.a);
            for (const Triangle& part : {Triangle{t.a, ab, ca}, {t.b, bc, ab}, {t.c, ca, bc}, {ab, bc, ca}})
                finer.push_back(part);
        }
        all = finer;
    }
    return all;
}

std::vector<Triangle> box() {
    std::vector<Triangle> all;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            vec3 corner[4];
            for (int i = 0; i < 4; ++i) {
                corner[i][axis] = side;
                corner[i][(axis + 1) % 3] = i % 2 == 0 ? -1.0f : 1.0f;
                corner[i][(axis + 2) % 3] = i / 2 == 0 ? -1.0f : 1.0f;
            }
            all.push_back({corner[0], corner[1], corner[2]});
            all.push_back({corner[3], corner[2], corner[1]});
        }
    return all;
}

PictureRequest requestOf(const ImageCamera& camera, uint32_t samples, uint32_t bounces) {
    PictureRequest request;
    request.camera = camera;
    request.view = View::path;
    request.traversal = Traversal::stack;
    request.samples = samples;
    request.bounces = bounces;
    request.seed = kSeed;
    return request;
}

// In a closed box that emits 1 and reflects a half of what comes, light is 1 + 1/2 + 1/4 + ... = 2.
TEST(Paths, AClosedBoxThatEmitsOneShowsTheSumOfItsBounces) {
    const ImageCamera camera = cameraAt({0.1, 0.2, 0.3}, {1, 0.1, -0.2}, {0, 1, 0}, 0.8, 64);
    for (const float base : {0.2f, 0.5f, 0.8f})
        for (const float roughness : {1.0f, 0.4f}) {
            if (base < 0.5f && roughness < 1.0f) continue;  // facets alone reflect more than that near the horizon
            const PictureRequest request = requestOf(camera, 32, 64);
            const Mean light = meanOf(radiance(box(), surface(base, 0.0f, roughness, 1.0f), request));
            std::printf("seed %u: base %.1f, roughness %.1f: light %.5f, standard error %.5f\n", kSeed, double{base},
                        double{roughness}, light.value, light.error);
            EXPECT_NEAR(light.value, 1.0 / (1.0 - double{base}), 4.0 * light.error);
        }
}

// White, under a sky of 1 everywhere: what comes back is what came in, whatever the angle and the roughness.
TEST(Paths, AWhiteConvexBodyUnderAUniformSkyIsNotSeen) {
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {1.0f, 0.5f, 0.1f}) {
            PictureRequest request = requestOf(cameraAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.3, 48), 32, 64);
            request.lighting.sky = {vec3(1.0f), vec3(1.0f)};
            const Mean mean = meanOf(radiance(sphere(4), surface(1.0f, metallic, roughness), request));
            std::printf("seed %u: metallic %.0f, roughness %.1f: %.5f, standard error %.5f\n", kSeed, metallic,
                        roughness, mean.value, mean.error);
            EXPECT_NEAR(mean.value, 1.0, 4.0 * mean.error + 0.002);
        }
}

// A point light over a rough floor: irradiance is intensity cosine / distance^2, and of that a white surface shows 1 /
// pi.
TEST(Paths, APointLightGivesTheInverseSquare) {
    for (const float height : {0.5f, 1.0f, 2.0f}) {
        PictureRequest request = requestOf(cameraAt({0, 3, 0}, {0, 0, 0}, {0, 0, 1}, 0.001, 8), 4, 1);
        request.lighting.lights = {{{0, height, 0}, kLightPoint, {0, -1, 0}, 0.0f, vec3(2.0f), infinity(), 0, 0}};
        const Mean mean = meanOf(radiance(floorSquare(), surface(0.5f, 0.0f, 1.0f), request));
        const Mean twice = [&] {
            request.lighting.lights[0].position.y = 2.0f * height;
            return meanOf(radiance(floorSquare(), surface(0.5f, 0.0f, 1.0f), request));
        }();
        EXPECT_NEAR(mean.value / twice.value, 4.0, 1e-3);
        EXPECT_GT(mean.value, 0.0);
    }
}

// The sun is seen past what is between: half of the floor lies in the shadow of a wall.
TEST(Paths, WhatIsBetweenCastsAShadow) {
    std::vector<Triangle> world = floorSquare();
    world.push_back({{0, 0, -9}, {0, 0, 9}, {0, 9, 0}});
    PictureRequest request = requestOf(cameraAt({0.3, 3, 0}, {0.3, 0, 0}, {0, 0, 1}, 0.01, 8), 4, 1);
    LightSource sun{};
    sun.kind = kLightDirectional;
    sun.intensity = vec3(3.0f);
    sun.direction = glm::normalize(vec3(1.0f, -1.0f, 0.0f));
    request.lighting.lights = {sun};
    EXPECT_EQ(meanOf(radiance(world, surface(0.5f, 0.0f, 1.0f), request)).value, 0.0);
    request.lighting.lights[0].direction.x *= -1.0f;
    EXPECT_GT(meanOf(radiance(world, surface(0.5f, 0.0f, 1.0f), request)).value, 0.1);
}

// Two samples of one seed are not those of the next in another order, either: their sums would be the same.
TEST(Paths, AreTheSameEveryTimeAndOtherwiseByAnotherSeed) {
    PictureRequest request = requestOf(cameraAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.3, 32), 2, 3);
    request.lighting.sky = {vec3(1.0f), kBlack};
    request.seed = 4;
    const std::vector<vec3> first = radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request);
    EXPECT_EQ(first, radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request));
    for (const uint32_t seed : {5u, 6u, 0x80000000u}) {
        request.seed = seed;
        const std::vector<vec3> other = radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request);
        size_t same = 0;
        for (size_t i = 0; i < first.size(); ++i) same += first[i] == other[i] && first[i].x > 0.0f ? 1 : 0;
        EXPECT_LT(same, first.size() / 2) << seed << ": the background is, which is nearly even";
    }
}

// Whatever the exposure, in PNG; in EXR it is the colour, too. The floor fills the picture.
TEST(Paths, UnlitSurfacesShowTheirColour) {
    const std::vector<Triangle> world = floorSquare();
    Material floor = surface(0.0f, 0.0f, 1.0f, 9.0f);
    floor.baseColour = {0.9f, 0.5f, 0.05f, 1.0f};
    floor.flags = kMaterialUnlit;
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    SurfaceData data;
    data.surfaceOf.assign(world.size(), 0);
    data.materials = {floor};
    const DeviceSurfaces surfaces(device(), data);
    Renderer& renderer = sharedRenderer();
    for (const View view : {View::path, View::shaded})
        for (const float exposure : {0.25f, 1.0f, 4.0f}) {
            PictureRequest request = requestOf(cameraAt({0, 1, 0}, {0, 0, 0}, {0, 0, 1}, 0.5, 16), 4, 3);
            request.view = view;
            request.exposure = exposure;
            const Picture picture = renderer.render(*tree, triangles, surfaces, request);
            for (const uint32_t pixel : picture.pixels)
                ASSERT_EQ(pixel, packedColour(encoded(vec3(floor.baseColour)))) << exposure;
            for (const vec3& radiance : renderer.readRadiance())
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(radiance[k], floor.baseColour[k], 1e-6f);
        }
}

std::vector<vec3> minus(std::vector<vec3> a, const std::vector<vec3>& b) {
    for (size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

// A square lamp of side 2 r in the plane y = height, which shines up and down.
std::vector<Triangle> lamp(float r, float height) {
    const vec3 a(-r, height, -r), b(r, height, -r), c(-r, height, r), d(r, height, r);
    return {{a, b, c}, {d, c, b}};
}

// Looks for the triangles from `first` on, which are all as bright.
void lookFor(PictureRequest& request, const std::vector<Triangle>& world, size_t first, const Material& lamp) {
    std::vector<double> powers;
    std::vector<uint32_t> triangles;
    for (size_t i = first; i < world.size(); ++i) {
        const Triangle& t = world[i];
        powers.push_back(0.5 * glm::length(glm::cross(glm::dvec3(t.b - t.a), glm::dvec3(t.c - t.a))) *
                         double{brightnessOf(lamp.emission)});
        triangles.push_back(static_cast<uint32_t>(i));
    }
    request.lighting.emitterTable = aliasTable(powers, triangles);
    request.lighting.emitters = {
        static_cast<uint32_t>(triangles.size()),
        static_cast<float>(1.0 / std::sqrt(std::accumulate(powers.begin(), powers.end(), 0.0)))};
}

// What a floor shows straight up of a lamp over it: the BRDF times the cosine, summed over a grid of points of the lamp
// in double, each of which is seen in the solid angle of its area times cosine over squared distance.
double reflectedOfLamp(const Material& floor, float r, float height, const glm::dvec3& at) {
    constexpr int kSteps = 400;
    static const std::vector<SpecularAlbedo> kAlbedo = albedoTable();
    const Surface surface{vec3(floor.baseColour), floor.metallic, floor.roughness};
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const glm::dvec3 there(r * (2.0 * (i + 0.5) / kSteps - 1.0), height, r * (2.0 * (j + 0.5) / kSteps - 1.0));
            const glm::dvec3 way = there - at;
            const double squared = glm::dot(way, way), cosine = way.y / std::sqrt(squared);
            const glm::dvec3 towards = way / std::sqrt(squared);
            const vec3 value = brdfTimesCosine(surface, {kAlbedo.data()}, vec3(0.0f, 0.0f, 1.0f),
                                               vec3(glm::dvec3(towards.x, towards.z, towards.y)));
            sum += double{value.x} * cosine / squared * (2.0 * r / kSteps) * (2.0 * r / kSteps);
        }
    return sum;
}

TEST(Paths, AFloorUnderALampShowsWhatTheSumOverTheLampGives) {
    for (const float r : {0.4f, 0.05f})
        for (const float roughness : {1.0f, 0.4f, 0.15f}) {
            const Material floor = surface(0.6f, 0.0f, roughness), shining = surface(0.0f, 0.0f, 1.0f, 3.0f);
            std::vector<Triangle> world = floorSquare();
            const size_t first = world.size();
            for (const Triangle& t : lamp(r, 0.5f)) world.push_back(t);
            // From below the lamp.
            PictureRequest request = requestOf(cameraAt({0.1, 0.4, 0.2}, {0.1, 0, 0.2}, {0, 0, 1}, 0.001, 32), 64, 1);
            const double expected = 3.0 * reflectedOfLamp(floor, r, 0.5f, {0.1, 0.0, 0.2});
            const Mean found = meanOf(radiance(world, {floor, shining}, first, request));
            lookFor(request, world, first, shining);
            const Mean looked = meanOf(radiance(world, {floor, shining}, first, request));
            std::printf(
                "seed %u: lamp of %.1f, roughness %.2f: %.5f; found %.5f, standard error %.5f; looked for %.5f, "
                "standard error %.5f; ratio of variances %.1f\n",
                kSeed, 2.0 * double{r}, double{roughness}, expected, found.value, found.error, looked.value,
                looked.error, std::pow(found.error / looked.error, 2.0));
            EXPECT_NEAR(found.value, expected, 4.0 * found.error + 1e-4 * expected);
            EXPECT_NEAR(looked.value, expected, 4.0 * looked.error + 1e-4 * expected);
            EXPECT_LT(looked.error, found.error);
        }
}

// Many bounces between all kinds of surfaces, with a lamp, a point light and a sky: whether lamps are looked for
// changes the noise and nothing else.
TEST(Paths, LookingForLampsChangesNoMean) {
    std::vector<Triangle> world = box();
    world.erase(world.begin(), world.begin() + 2);  // a side is open to the sky
    for (Triangle t : sphere(1)) {
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = *v * 0.4f;
        world.push_back(t);
    }
    const size_t first = world.size();
    for (const Triangle& t : lamp(0.3f, 0.9f)) world.push_back(t);
    world.push_back({{0.8f, -0.9f, -0.9f}, {0.9f, -0.9f, -0.8f}, {0.9f, -0.6f, -0.9f}});
    const ImageCamera camera = cameraAt({0.9, 0.3, 0.8}, {-0.2, -0.2, -0.3}, {0, 1, 0}, 0.7, 96);
    for (const float roughness : {1.0f, 0.4f, 0.15f})
        for (const bool alone : {true, false}) {
            const Material walls = surface(0.7f, roughness < 1.0f ? 0.5f : 0.0f, roughness);
            const Material shining = surface(0.3f, 0.0f, 0.5f, 4.0f);
            PictureRequest request = requestOf(camera, 24, 6);
            request.lighting.sky = {vec3(0.2f), vec3(0.1f)};
            if (!alone)
                request.lighting.lights = {
                    {{0.2f, 0.6f, 0.5f}, kLightPoint, {0, -1, 0}, 0.0f, vec3(0.3f), infinity(), 0, 0}};
            const std::vector<vec3> found = radiance(world, {walls, shining}, first, request);
            lookFor(request, world, first, shining);
            request.seed = kSeed + 1;
            const std::vector<vec3> looked = radiance(world, {walls, shining}, first, request);
            const Mean difference = meanOf(minus(looked, found));
            std::printf("seed %u: roughness %.2f%s: found %.5f, looked for %.5f more, standard error %.5f\n", kSeed,
                        double{roughness}, alone ? "" : ", point light", meanOf(found).value, difference.value,
                        difference.error);
            EXPECT_NEAR(difference.value, 0.0, 4.0 * difference.error);
            EXPECT_LT(difference.error, 0.02 * meanOf(found).value);
        }
}

// A lamp that three of ten rays find is three tenths as bright, however it is found.
TEST(Paths, TranslucentLampsShineByTheirAlpha) {
    const Material floor = surface(0.6f, 0.0f, 1.0f);
    Material shining = surface(0.0f, 0.0f, 1.0f, 3.0f);
    std::vector<Triangle> world = floorSquare();
    const size_t first = world.size();
    for (const Triangle& t : lamp(0.4f, 0.5f)) world.push_back(t);
    PictureRequest request = requestOf(cameraAt({0.1, 0.4, 0.2}, {0.1, 0, 0.2}, {0, 0, 1}, 0.001, 32), 64, 1);
    const double opaque = 3.0 * reflectedOfLamp(floor, 0.4f, 0.5f, {0.1, 0.0, 0.2});
    shining.baseColour.w = 0.3f;
    for (const bool masked : {false, true}) {
        shining.flags = masked ? kMaterialMask : kMaterialBlend;
        const double expected = masked ? 0.0 : 0.3 * opaque;
        request.lighting = {};
        for (const bool looks : {false, true}) {
            if (looks) lookFor(request, world, first, shining);
            const Mean mean = meanOf(radiance(world, {floor, shining}, first, request));
            std::printf("seed %u: %.5f, standard error %.5f, expected %.5f\n", kSeed, mean.value, mean.error, expected);
            EXPECT_NEAR(mean.value, expected, 4.0 * mean.error + 1e-4 * expected);
        }
    }
}

// Where everything shines, nothing is counted twice.
TEST(Paths, AClosedBoxIsAsBrightWhenItsWallsAreLookedFor) {
    const ImageCamera camera = cameraAt({0.1, 0.2, 0.3}, {1, 0.1, -0.2}, {0, 1, 0}, 0.8, 64);
    for (const float base : {0.0f, 0.5f, 0.8f}) {
        const Material walls = surface(base, 0.0f, 1.0f, 1.0f);
        PictureRequest request = requestOf(camera, 32, 64);
        const std::vector<vec3> found = radiance(box(), walls, request);
        lookFor(request, box(), 0, walls);
        const Mean difference = meanOf(minus(radiance(box(), walls, request), found));
        std::printf("seed %u: base %.1f: found %.5f, looked for %.5f more, standard error %.5f\n", kSeed, double{base},
                    meanOf(found).value, difference.value, difference.error);
        EXPECT_NEAR(difference.value, 0.0, 4.0 * difference.error + 1e-6);
        EXPECT_LT(difference.error, 0.004 * meanOf(found).value);
    }
}

}  // namespace

}  // namespace cleave::test
