#include "scene/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene/not_found.h"
#include "scene/pose.h"

namespace cleave {
namespace {

using glm::dvec3;

constexpr double kRightAngle = std::numbers::pi / 2.0;

// One ray per pixel, through its centre, row by row.
std::vector<Ray> cameraRays(const Camera& camera, uint32_t width, uint32_t height) {
    const ImageCamera image = imageCamera(camera, width, height, infinity());
    std::vector<Ray> rays;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) rays.push_back(imageRay(image, x + 0.5, y + 0.5));
    return rays;
}

void expectNear(const vec3& v, const vec3& expected) { EXPECT_NEAR(glm::distance(v, expected), 0.0f, 1e-6f); }

TEST(Camera, castsRaysThroughPixelCentres) {
    // 90 degrees: at distance 1 the picture spans y from -1 to 1, and x from -2 to 2.
    const Camera camera = lookAt({1, 2, 3}, {1, 2, -5}, kRightAngle);
    const std::vector<Ray> rays = cameraRays(camera, 4, 2);
    ASSERT_EQ(rays.size(), 8u);
    expectNear(rays[0].direction, glm::normalize(vec3(-1.5f, 0.5f, -1.0f)));
    expectNear(rays[3].direction, glm::normalize(vec3(1.5f, 0.5f, -1.0f)));
    expectNear(rays[5].direction, glm::normalize(vec3(-0.5f, -0.5f, -1.0f)));
    for (const Ray& ray : rays) {
        EXPECT_EQ(ray.origin, vec3(1, 2, 3));
        EXPECT_EQ(ray.tMin, 0.0f);
        EXPECT_EQ(ray.tMax, infinity());
        EXPECT_TRUE(isValidRay(ray));
    }
}

TEST(Camera, castsParallelRaysWhenOrthographic) {
    Camera camera = lookAt({0, 0, 5}, {0, 0, 0}, 0.0);
    camera.orthographic = true;
    camera.orthographicHeight = 4.0;
    const std::vector<Ray> rays = cameraRays(camera, 2, 2);
    expectNear(rays[0].origin, {-1, 1, 5});
    expectNear(rays[3].origin, {1, -1, 5});
    for (const Ray& ray : rays) EXPECT_EQ(ray.direction, vec3(0, 0, -1));
}

TEST(Camera, isAFrameWhereverItLooks) {
    for (const dvec3& target : {dvec3(0, 0, 0), dvec3(0, 7, 0), dvec3(0, -7, 0), dvec3(1, 1e6, 0), dvec3(-3, 2, 1)}) {
        const Camera camera = lookAt({0, 0, 0}, target, 1.0);
        EXPECT_NEAR(glm::length(camera.forward), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(camera.up), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0, 1e-12);
    }
    EXPECT_EQ(lookAt({1, 1, 1}, {1, 1, 1}, 1.0).forward, dvec3(0, 0, -1));
    EXPECT_EQ(lookAt({0, 5, 0}, {0, 0, 0}, 1.0).up, dvec3(0, 0, -1));
    EXPECT_EQ(lookAt({0, 0, 0}, {0, 5, 0}, 1.0).up, dvec3(0, 0, 1));
}

TEST(Camera, defaultLooksAtTheCentreFromACorner) {
    const Camera camera = defaultCamera({vec3(-1, 0, 2), vec3(3, 2, 6)});  // centre (1, 1, 4), diagonal 6
    const dvec3 way = dvec3(0.6, 0.4, 0.7) / std::sqrt(1.01);
    EXPECT_NEAR(glm::distance(camera.eye, dvec3(1, 1, 4) + 6.6 * way), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.forward, -way), 0.0, 1e-12);
    EXPECT_DOUBLE_EQ(camera.verticalFov, std::numbers::pi / 4.0);
    EXPECT_NEAR(glm::length(defaultCamera(emptyBox()).eye), 1.1, 1e-12);
    EXPECT_TRUE(isValidRay(cameraRays(defaultCamera({vec3(5), vec3(5)}), 1, 1)[0]));
}

TEST(Camera, boundsLeaveOutWhatIsNotFinite) {
    const std::vector<Triangle> triangles = {{vec3(0), vec3(1, 0, 0), vec3(0, 2, 0)},
                                             {vec3(-9), vec3(NAN, 0, 0), vec3(9)},
                                             {vec3(-9), vec3(infinity(), 0, 0), vec3(9)},
                                             {vec3(0, 0, -3), vec3(0), vec3(0)}};
    const Box bounds = finiteBounds(triangles);
    EXPECT_EQ(bounds.lo, vec3(0, 0, -3));
    EXPECT_EQ(bounds.hi, vec3(1, 2, 0));
    EXPECT_TRUE(isEmpty(finiteBounds({})));
}

TEST(Camera, isChosenByNameThenByNumber) {
    PosedScene scene;
    scene.name = "scene";
    const Box bounds{vec3(0), vec3(1)};
    EXPECT_EQ(chooseCamera(scene, bounds, "").name, "default");
    EXPECT_THROW(chooseCamera(scene, bounds, "0"), NotFound);
    scene.cameras.resize(3);
    scene.cameras[0].name = "main";
    scene.cameras[1].name = "2";
    scene.cameras[2].name = "last";
    EXPECT_EQ(chooseCamera(scene, bounds, "").name, "main");
    EXPECT_EQ(chooseCamera(scene, bounds, "last").name, "last");
    EXPECT_EQ(chooseCamera(scene, bounds, "0").name, "main");
    EXPECT_EQ(chooseCamera(scene, bounds, "2").name, "2");
    try {
        chooseCamera(scene, bounds, "side");
        FAIL();
    } catch (const NotFound& error) {
        EXPECT_NE(std::string(error.what()).find("0 'main', 1 '2', 2 'last'"), std::string::npos) << error.what();
    }
}

TEST(Camera, yieldsToTheUser) {
    const Box bounds{vec3(-1), vec3(1)};
    const Camera base = defaultCamera(bounds);
    EXPECT_EQ(overridden(base, bounds, {}).eye, base.eye);
    EXPECT_EQ(overridden(base, bounds, {}).forward, base.forward);
    const Camera moved = overridden(base, bounds, {dvec3(0, 0, 4), std::nullopt, std::nullopt});
    EXPECT_EQ(moved.eye, dvec3(0, 0, 4));
    EXPECT_EQ(moved.forward, dvec3(0, 0, -1));
    EXPECT_EQ(moved.verticalFov, base.verticalFov);
    const Camera turned = overridden(moved, bounds, {std::nullopt, dvec3(0, 0, 8), 0.5});
    EXPECT_EQ(turned.eye, dvec3(0, 0, 4));
    EXPECT_EQ(turned.forward, dvec3(0, 0, 1));
    EXPECT_EQ(turned.verticalFov, 0.5);
    Camera flat = base;
    flat.orthographic = true;
    EXPECT_FALSE(overridden(flat, bounds, {std::nullopt, std::nullopt, 0.5}).orthographic);
}

}  // namespace
}  // namespace cleave
