#include "view/navigation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <sstream>

#include "app/option_values.h"

namespace cleave {
namespace {

using glm::dvec2;
using glm::dvec3;

const Box kBounds{{-1, -2, -3}, {4, 3, 2}};
constexpr uint32_t kWidth = 400, kHeight = 300;

Navigation started() {
    Navigation navigation;
    navigation.take(defaultCamera(kBounds), kBounds, "");
    return navigation;
}

// Where a point is in the picture, by solving for the pixel whose ray goes there.
dvec2 placeOf(const Camera& camera, const dvec3& p) {
    const ImageCamera image = imageCamera(camera, kWidth, kHeight, 1e30f);
    const dvec3 way = p - image.eye;
    const double distance = glm::dot(way, image.forward);
    return {0.5 * kWidth + glm::dot(way, image.right) / distance / image.pixel,
            0.5 * kHeight - glm::dot(way, image.up) / distance / image.pixel};
}

TEST(Navigation, OrbitsAtAConstantDistanceOfThePivot) {
    Navigation navigation = started();
    const dvec3 pivot = navigation.pivot(), before = navigation.camera().eye;
    const double distance = glm::length(before - pivot);
    for (int i = 0; i < 50; ++i) {
        navigation.orbit(0.1, 0.05);
        EXPECT_EQ(navigation.pivot(), pivot);
        EXPECT_NEAR(glm::length(navigation.camera().eye - pivot), distance, 1e-9 * distance);
        EXPECT_NEAR(placeOf(navigation.camera(), pivot).x, 0.5 * kWidth, 1e-6);
        EXPECT_GT(navigation.camera().up.y, 0.0) << "it does not turn over";
    }
    navigation = started();
    navigation.orbit(0.3, 0.0);
    EXPECT_NEAR(navigation.camera().eye.y, before.y, 1e-9) << "a turn to the side keeps the height";
    const dvec2 a(before.x - pivot.x, before.z - pivot.z);
    const dvec2 b(navigation.camera().eye.x - pivot.x, navigation.camera().eye.z - pivot.z);
    EXPECT_NEAR(std::acos(glm::dot(a, b) / glm::length(a) / glm::length(b)), 0.3, 1e-9);
}

TEST(Navigation, WhatIsDraggedToTheRightTurnsToTheRight) {
    Navigation navigation = started();
    const dvec3 front = navigation.pivot() + 0.5 * (navigation.camera().eye - navigation.pivot());
    const double before = placeOf(navigation.camera(), front).x;
    navigation.orbit(0.1, 0.0);
    EXPECT_GT(placeOf(navigation.camera(), front).x, before);
}

TEST(Navigation, PannedThePivotFollowsTheCursor) {
    Navigation navigation = started();
    const dvec3 pivot = navigation.pivot();
    const dvec2 before = placeOf(navigation.camera(), pivot);
    navigation.pan(0.2, -0.1);  // in heights of the picture: 60 pixels to the right, 30 down
    const dvec2 after = placeOf(navigation.camera(), pivot);
    EXPECT_NEAR(after.x - before.x, 60.0, 1e-6);
    EXPECT_NEAR(after.y - before.y, 30.0, 1e-6);
}

TEST(Navigation, ZoomsByATenthOfTheWay) {
    Navigation navigation = started();
    const double before = glm::length(navigation.camera().eye - navigation.pivot());
    navigation.zoom(1.0);
    EXPECT_NEAR(glm::length(navigation.camera().eye - navigation.pivot()), 0.9 * before, 1e-9);
    for (int i = 0; i < 10000; ++i) navigation.zoom(1.0);
    EXPECT_GT(glm::length(navigation.camera().eye - navigation.pivot()), 0.0) << "never into the pivot";
}

TEST(Navigation, FliesWhereItLooks) {
    Navigation navigation = started();
    const Camera before = navigation.camera();
    navigation.fly({0.0, 0.0, 0.5});
    const double diagonal = std::sqrt(75.0);
    EXPECT_NEAR(glm::dot(navigation.camera().eye - before.eye, before.forward), 0.5 * diagonal, 1e-9);
    EXPECT_NEAR(glm::dot(navigation.camera().forward, before.forward), 1.0, 1e-12);
}

TEST(Navigation, FramesTheWholeScene) {
    for (const double aspect : {16.0 / 9.0, 1.0, 0.5}) {
        Navigation navigation = started();
        navigation.fly({3.0, 1.0, -5.0});
        navigation.frame(kBounds, aspect);
        const double half = 0.5 * kHeight;
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 p(corner & 1 ? kBounds.hi.x : kBounds.lo.x, corner & 2 ? kBounds.hi.y : kBounds.lo.y,
                          corner & 4 ? kBounds.hi.z : kBounds.lo.z);
            const dvec2 at = placeOf(navigation.camera(), p) - dvec2(0.5 * kWidth, half);
            EXPECT_LE(std::abs(at.y), half);
            EXPECT_LE(std::abs(at.x), half * aspect);
        }
    }
}

// What --eye, --look and --fov make of the text is the camera, to the last bit.
TEST(Navigation, TellsItsCameraExactly) {
    Navigation navigation = started();
    EXPECT_EQ(navigation.renderOptions(), "") << "not moved, it is the default one";
    navigation.orbit(0.1234, -0.0567);
    navigation.pan(0.01, 0.02);
    navigation.zoom(0.7);
    std::istringstream words(navigation.renderOptions());
    std::string eye, look, fov, option;
    words >> option >> eye >> option >> look >> option >> fov;
    ASSERT_TRUE(parsePoint(eye) && parsePoint(look) && parseNumber(fov)) << navigation.renderOptions();
    const Camera told = overridden(defaultCamera(kBounds), kBounds,
                                   {parsePoint(eye), parsePoint(look), glm::radians(*parseNumber(fov))});
    EXPECT_EQ(told.eye, navigation.camera().eye);
    EXPECT_EQ(told.forward, navigation.camera().forward);
    EXPECT_EQ(told.up, navigation.camera().up);
    EXPECT_EQ(told.verticalFov, navigation.camera().verticalFov);
}

TEST(Navigation, MakesAParallelCameraAPerspectiveOneThatShowsAsMuch) {
    Camera parallel = lookAt({0, 0, 10}, {0, 0, 0}, 0.0);
    parallel.orthographic = true;
    parallel.orthographicHeight = 4.0;
    Navigation navigation;
    navigation.take(parallel, {{-1, -1, -1}, {1, 1, 1}}, "--camera 0");
    EXPECT_TRUE(navigation.camera().orthographic);
    EXPECT_EQ(navigation.renderOptions(), "--camera 0");
    navigation.orbit(0.0, 0.0);
    EXPECT_FALSE(navigation.camera().orthographic);
    const double distance = glm::length(navigation.camera().eye - navigation.pivot());
    EXPECT_NEAR(2.0 * distance * std::tan(0.5 * navigation.camera().verticalFov), 4.0, 1e-9);
}

TEST(Navigation, StaysFiniteWhereTheSceneIsAPoint) {
    Navigation navigation;
    const Box point{{2, 2, 2}, {2, 2, 2}};
    navigation.take(defaultCamera(point), point, "");
    navigation.orbit(0.5, 0.5);
    navigation.zoom(100.0);
    navigation.fly({1, 1, 1});
    navigation.frame(point, 1.5);
    const Camera& camera = navigation.camera();
    EXPECT_TRUE(std::isfinite(camera.eye.x) && std::isfinite(camera.forward.x) && std::isfinite(camera.up.y));
}

}  // namespace
}  // namespace cleave
