// Shaded pictures of several samples where the light that they show is known.
#include <cstdio>

#include "shared/surface.h"
#include "support/lit_world.h"

namespace cleave::test {

namespace {

constexpr uint32_t kSeed = 3;
constexpr float kReach = 0.5f;

PictureRequest requestOf(const ImageCamera& camera, uint32_t samples) {
    PictureRequest request;
    request.camera = camera;
    request.samples = samples;
    request.seed = kSeed;
    return request;
}

// The share of a disc of radius 1 beyond a chord in the distance `x` from its middle.
double shareBeyond(double x) {
    if (std::abs(x) >= 1.0) return x < 0.0 ? 1.0 : 0.0;
    return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / std::acos(-1.0);
}

// Looks up at the square in y = 0 from below, where no sun is, at the point (x, 0, 0) of it.
PictureRequest ceilingAt(double x, uint32_t samples) {
    return requestOf(cameraAt({x, -0.3, 0}, {x, 0, 0}, {0, 0, 1}, 1e-5, 64), samples);
}

void add(std::vector<Triangle>& world, const vec3& corner, const vec3& one, const vec3& other) {
    world.push_back({corner, corner + one, corner + other});
    world.push_back({corner + one + other, corner + other, corner + one});
}

TEST(Shaded, APlaneGetsAllOfTheLightFromAround) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    const std::vector<vec3> single = radiance(floorSquare(), white, ceilingAt(0.1, 1));
    const std::vector<vec3> several = radiance(floorSquare(), white, ceilingAt(0.1, 16));
    for (size_t i = 0; i < several.size(); ++i) ASSERT_NEAR(several[i].x, single[i].x, 1e-6f) << "pixel " << i;
}

// Beside a wall, the rays that meet it within their reach are those whose share across it is more than distance over
// reach. Directions by their cosine are the points of the disc under them, evenly.
TEST(Shaded, AWallTakesItsShareOfTheLightFromAround) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    std::vector<Triangle> world = floorSquare();
    add(world, {0, 0, -1}, {0, 0, 2}, {0, -2, 0});
    const double all = meanOf(radiance(floorSquare(), white, ceilingAt(0.1, 1))).value;
    for (const double share : {1e-4, 0.3, 0.7, 1.1}) {
        PictureRequest request = ceilingAt(share * double{kReach}, 16);
        request.ambientReach = kReach;
        const Mean light = meanOf(radiance(world, white, request));
        const double expected = 1.0 - shareBeyond(share);
        std::printf("seed %u: %.4f of the reach from the wall: %.5f, standard error %.5f, expected %.5f\n", kSeed,
                    share, light.value / all, light.error / all, expected);
        EXPECT_NEAR(light.value / all, expected, 4.0 * light.error / all + 1e-6);
    }
}

// At the edge where two walls meet, half of the sky is seen from either, however far the walls reach.
TEST(Shaded, AnEdgeSeesHalfOfTheSky) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    std::vector<Triangle> world;
    add(world, {-1, 0, -1e5f}, {1e5f, 0, 0}, {0, 0, 2e5f});
    const double all = meanOf(radiance(world, white, ceilingAt(1e-3, 1))).value;
    add(world, {0, 0, -1e5f}, {0, 0, 2e5f}, {0, -1e5f, 0});
    const Mean light = meanOf(radiance(world, white, ceilingAt(1e-3, 16)));
    std::printf("seed %u: %.5f, standard error %.5f, expected 0.5\n", kSeed, light.value / all, light.error / all);
    EXPECT_NEAR(light.value / all, 0.5, 4.0 * light.error / all);
}

// The edge of a half-plane across the sun's direction, seen before its disc from a point of the floor. The edge runs
// so that what it leaves of the disc is as high over the floor as what it covers.
TEST(Shaded, AnEdgeHidesItsShareOfTheSun) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    const vec3 sun = towardsSun(), across = glm::normalize(glm::cross(sun, vec3(0, 1, 0)));
    const vec3 along = glm::cross(sun, across);
    constexpr float kAway = 5.0f;
    const float radius = kAway * kSineOfSun / std::sqrt(1.0f - kSineOfSun * kSineOfSun);
    PictureRequest request = requestOf(cameraAt({0, 0.5, 0}, {0, 0, 0}, {0, 0, 1}, 1e-6, 64), 16);
    request.ambientReach = kReach;
    const auto light = [&](float edge) {
        std::vector<Triangle> world = floorSquare();
        add(world, kAway * sun + edge * radius * across - along, 2.0f * along, across);
        return meanOf(radiance(world, white, request));
    };
    const double full = light(2.0f).value, shade = light(-2.0f).value;
    EXPECT_NEAR(full - shade, double{kSunLight} * double{sun.y}, 1e-4);
    for (const float edge : {-1.05f, -0.5f, 0.0f, 0.3f, 1.05f}) {
        const Mean found = light(edge);
        const double share = (found.value - shade) / (full - shade), error = found.error / (full - shade);
        const double expected = 1.0 - shareBeyond(double{edge});
        std::printf("seed %u: edge at %.2f: %.5f of the sun, standard error %.5f, expected %.5f\n", kSeed, double{edge},
                    share, error, expected);
        EXPECT_NEAR(share, expected, 4.0 * error + 2e-4);
    }
}

// Rays to the light from all around look through what is not there, too.
TEST(Shaded, AlphaTakesItsShareOfTheLightFromAround) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    Material pane = white;
    pane.baseColour.w = 0.25f;
    pane.flags = kMaterialBlend;
    std::vector<Triangle> world = floorSquare();
    const size_t second = world.size();
    add(world, {-1e4f, -0.4f, -1e4f}, {2e4f, 0, 0}, {0, 0, 2e4f});
    const double all = meanOf(radiance(floorSquare(), white, ceilingAt(0.1, 1))).value;
    const Mean light = meanOf(radiance(world, {white, pane}, second, ceilingAt(0.1, 16)));
    std::printf("seed %u: %.5f, standard error %.5f, expected 0.75\n", kSeed, light.value / all, light.error / all);
    EXPECT_NEAR(light.value / all, 0.75, 4.0 * light.error / all + 1e-4);
}

TEST(Shaded, IsTheSameEveryTimeAndOtherwiseByAnotherSeed) {
    const Material white = surface(1.0f, 0.0f, 1.0f);
    std::vector<Triangle> world = floorSquare();
    add(world, {0, 0, -1}, {0, 0, 2}, {0, -2, 0});
    PictureRequest request = ceilingAt(0.1, 2);
    const std::vector<vec3> first = radiance(world, white, request);
    EXPECT_EQ(first, radiance(world, white, request));
    request.seed++;
    EXPECT_NE(first, radiance(world, white, request));
}

}  // namespace

}  // namespace cleave::test
