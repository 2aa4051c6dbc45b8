#include "app/lighting.h"

#include <gtest/gtest.h>

#include <limits>

namespace cleave::test {
namespace {

gltf::Material emitting(float factor, float strength = 1.0f) {
    gltf::Material material;
    material.emissive = vec3(factor, 0.0f, 0.0f);
    material.emissiveStrength = strength;
    return material;
}

// Triangles of area 1/2 times their size squared, one of each material.
struct World {
    Scene scene;
    PosedScene posed;

    void add(const gltf::Material& material, float size = 1.0f) {
        posed.materialOf.push_back(static_cast<uint32_t>(scene.materials.size()));
        scene.materials.push_back(material);
        posed.triangles.push_back({vec3(0.0f), vec3(size, 0.0f, 0.0f), vec3(0.0f, size, 0.0f)});
    }
    Lighting lighting() const { return lightingOf(scene, posed); }
};

TEST(Lighting, LampsTakeThePlaceOfTheSun) {
    World world;
    world.add(emitting(0.0f));
    EXPECT_EQ(world.lighting().lights.size(), 1u) << "the sun";
    EXPECT_EQ(world.lighting().emitters.slots, 0u);
    world.add(emitting(0.5f, 4.0f), 3.0f);
    const Lighting lit = world.lighting();
    EXPECT_TRUE(lit.lights.empty());
    EXPECT_EQ(largestComponent(lit.sky.zenith), 0.0f);
    ASSERT_EQ(lit.emitters.slots, 1u);
    EXPECT_EQ(lit.emitterTable[0].first, 1u);
    EXPECT_FLOAT_EQ(lit.emitters.scale, 1.0f / 3.0f) << "an area of 4.5, a brightness of 2";
}

TEST(Lighting, UnlitAndDecorativeSurfacesAreNotLookedFor) {
    gltf::Material unlit = emitting(1.0f), display = emitting(1.0f), tube = emitting(1.0f, 5.0f);
    unlit.unlit = true;
    display.emissiveTexture.emplace();
    tube.emissiveTexture.emplace();
    EXPECT_EQ(lampBrightness(unlit), 0.0f);
    EXPECT_EQ(lampBrightness(display), 0.0f);
    EXPECT_EQ(lampBrightness(tube), 5.0f);
    World world;
    world.add(unlit);
    world.add(display);
    EXPECT_EQ(world.lighting().lights.size(), 1u) << "the sun";
    EXPECT_EQ(world.lighting().emitters.slots, 0u);
}

TEST(Lighting, TrianglesThatNoRayMeetsAreNotLookedFor) {
    World world;
    world.add(emitting(1.0f), 0.0f);
    world.add(emitting(1.0f), std::numeric_limits<float>::quiet_NaN());
    world.add(emitting(1.0f), std::numeric_limits<float>::infinity());
    EXPECT_EQ(world.lighting().emitters.slots, 0u);
    world.add(emitting(1.0f));
    const Lighting lit = world.lighting();
    ASSERT_EQ(lit.emitters.slots, 1u);
    EXPECT_EQ(lit.emitterTable[0].first, 3u);
}

// From atoms to galaxies; and what no float can hold is left to chance.
TEST(Lighting, ScalesAreNoMatter) {
    for (const float size : {1e-18f, 1.0f, 1e18f}) {
        World world;
        world.add(emitting(2.0f), size);
        EXPECT_FLOAT_EQ(world.lighting().emitters.scale, 1.0f / size);
    }
}

// As far as rays may go, without overflow.
TEST(Lighting, TheReachOfShadeIsAShareOfTheDiagonal) {
    EXPECT_FLOAT_EQ(ambientReachOf({{-1, -2, 0}, {1, 4, 3}}), 0.35f);
    EXPECT_FLOAT_EQ(ambientReachOf({vec3(-3e38f), vec3(3e38f)}), 0.05f * 1.7320508f * 2.0f * 3e38f);
    EXPECT_FALSE(std::isnan(ambientReachOf(emptyBox())));
}

// A brightness that is infinite would be the whole of every chance.
TEST(Lighting, BrightnessIsFinite) {
    gltf::Material blinding = emitting(1.0f, 3e38f);
    blinding.emissive = vec3(1.0f);
    EXPECT_EQ(lampBrightness(blinding), kLargestFloat);
    World world;
    world.add(blinding);
    EXPECT_EQ(world.lighting().emitters.slots, 1u);
    EXPECT_GT(world.lighting().emitters.scale, 0.0f);
}

}  // namespace
}  // namespace cleave::test
