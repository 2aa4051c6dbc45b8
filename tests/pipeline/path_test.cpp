// Whole pictures of paths where the light that they show is known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "builders/builders.h"
#include "run/renderer.h"
#include "support/device.h"

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

// A square in the plane y = 0, of side 2.
std::vector<Triangle> floorSquare() {
    return {{{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}}, {{1, 0, 1}, {-1, 0, 1}, {1, 0, -1}}};
}

Material surface(float albedo, float metallic, float roughness, float emission = 0.0f) {
    return plainMaterial({albedo, albedo, albedo, 1.0f}, vec3(emission), metallic, roughness, 0);
}

ImageCamera cameraAt(glm::dvec3 eye, glm::dvec3 look, glm::dvec3 up, double tangent, uint32_t size) {
    ImageCamera c{};
    c.eye = eye;
    c.forward = glm::normalize(look - eye);
    c.right = glm::normalize(glm::cross(c.forward, up));
    c.up = glm::cross(c.right, c.forward);
    c.pixel = 2.0 * tangent / size;
    c.width = c.height = size;
    c.tMax = infinity();
    return c;
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

std::vector<vec3> radiance(const std::vector<Triangle>& world, const Material& material,
                           const PictureRequest& request) {
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    SurfaceData data;
    data.surfaceOf.assign(world.size(), 0);
    data.materials = {material};
    const DeviceSurfaces surfaces(device(), data);
    Tracer tracer(device());
    Renderer renderer(device(), tracer);
    const Picture picture = renderer.render(*tree, triangles, surfaces, request);
    EXPECT_EQ(picture.cappedRays, 0u);
    EXPECT_EQ(picture.samples, request.samples);
    return renderer.readRadiance();
}

struct Mean {
    double value = 0.0, error = 0.0;  // error: of the mean, one standard deviation
};
Mean meanOf(const std::vector<vec3>& pixels) {
    double sum = 0.0, squares = 0.0;
    for (const vec3& p : pixels) {
        sum += double{p.x};
        squares += double{p.x} * double{p.x};
    }
    const auto n = static_cast<double>(pixels.size());
    return {sum / n, std::sqrt(std::max(squares / n - sum / n * (sum / n), 0.0) / n)};
}

// In a closed box that emits 1 and reflects a half of what comes, light is 1 + 1/2 + 1/4 + ... = 2. A base colour of a
// half reflects a little more, for about 2 per cent of the light never reach it: the surface of a dielectric reflects
// those. What is reflected in all, 0.5 + 0.5 e, is measured under a uniform sky first.
TEST(Paths, AClosedBoxThatEmitsOneShowsTheSumOfItsBounces) {
    PictureRequest outside = requestOf(cameraAt({0.1, 4, 0.2}, {0, 0, 0}, {0, 0, 1}, 0.1, 48), 64, 1);
    outside.lighting.sky = {vec3(1.0f), vec3(1.0f)};
    const ImageCamera camera = cameraAt({0.1, 0.2, 0.3}, {1, 0.1, -0.2}, {0, 1, 0}, 0.8, 64);
    for (const float base : {0.0f, 0.5f, 0.8f}) {
        const Mean albedo = meanOf(radiance(floorSquare(), surface(base, 0.0f, 1.0f), outside));
        const Mean light = meanOf(radiance(box(), surface(base, 0.0f, 1.0f, 1.0f), requestOf(camera, 32, 64)));
        std::printf("seed %u: base %.1f: albedo %.5f, light %.5f, standard error %.5f\n", kSeed, double{base},
                    albedo.value, light.value, light.error);
        EXPECT_GE(albedo.value, double{base});
        EXPECT_LT(albedo.value, double{base} + 0.025);
        // The albedo is that of light that goes straight up; of all directions it differs by some 0.01.
        EXPECT_NEAR(1.0 - 1.0 / light.value, albedo.value, 0.015);
        EXPECT_GT(light.value, 1.0 / (1.0 - double{base}) - 4.0 * light.error);
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

TEST(Paths, AreTheSameEveryTimeAndOtherwiseByAnotherSeed) {
    PictureRequest request = requestOf(cameraAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.3, 32), 2, 3);
    request.lighting.sky = {vec3(1.0f), kBlack};
    const std::vector<vec3> first = radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request);
    EXPECT_EQ(first, radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request));
    request.seed = kSeed + 1;
    EXPECT_NE(first, radiance(sphere(2), surface(0.7f, 0.0f, 0.6f), request));
}

}  // namespace

}  // namespace cleave::test
