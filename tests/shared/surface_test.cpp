#include "shared/surface.h"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::test {
namespace {

constexpr uint32_t kAll = kPartNormals | kPartColours | kPartTextures;

// A triangle in the plane z = 0 whose front looks along z; its texture's u grows along x, and v along -y.
struct OneTriangle {
    Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    std::vector<uint32_t> surfaceOf = {0};
    std::vector<Material> materials = {plainMaterial({1, 1, 1, 1}, vec3(0.0f), 0.5f, 0.5f, 0)};
    std::vector<vec3> normals = std::vector<vec3>(3, vec3(0, 0, 1));
    std::vector<vec4> colours = std::vector<vec4>(3, vec4(1.0f));
    std::vector<vec2> texCoords = {{0, 1}, {1, 1}, {0, 0}};
    std::vector<TextureMap> maps;
    std::vector<uint32_t> texels;

    Material& material() { return materials[0]; }
    // A map of one texel everywhere.
    uint32_t map(uint32_t texel, uint32_t flags = 0) {
        maps.push_back({static_cast<uint32_t>(texels.size()), 1, 1, flags, {1, 0, 0, 1}, {0, 0}});
        texels.push_back(texel);
        return static_cast<uint32_t>(maps.size() - 1);
    }
    SurfaceArrays arrays() const {
        return {{surfaceOf.data()}, {materials.data()}, {normals.data()}, {colours.data()},
                {texCoords.data()}, {texCoords.data()}, {maps.data()},    {texels.data()}};
    }
    HitSurface at(float u, float v, const vec3& direction = {0, 0, -1}, uint32_t parts = kAll) const {
        return hitSurface(arrays(), parts, {1.0f, 0, u, v}, triangle, direction);
    }
};

void expectNear(const vec3& got, const vec3& want, float tolerance = 1e-5f) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], want[k], tolerance) << "component " << k;
}

TEST(HitSurface, MixesCornersByTheHitsWeights) {
    OneTriangle t;
    t.normals = {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
    t.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}};
    t.material().baseColour = {0.5f, 1, 1, 1};
    const HitSurface s = t.at(0.25f, 0.5f);
    expectNear(vec3(s.baseColour), {0.125f, 0.25f, 0.5f});
    EXPECT_NEAR(s.baseColour.w, 0.5f, 1e-6f);
    expectNear(s.normal, glm::normalize(vec3(0, 0.5f, 0.5f)));
    expectNear(s.facing, {0, 0, 1});
}

TEST(HitSurface, PartsThatAreNotThereAreNotRead) {
    OneTriangle t;
    t.normals.assign(3, {1, 0, 0});
    t.colours.assign(3, vec4(0.0f));
    const HitSurface s = t.at(0.2f, 0.2f, {0, 0, -1}, 0);
    expectNear(s.normal, {0, 0, 1});
    expectNear(vec3(s.baseColour), {1, 1, 1});
}

TEST(HitSurface, NormalsTurnToTheRayAndStayInItsHemisphere) {
    OneTriangle t;
    t.normals.assign(3, glm::normalize(vec3(0.6f, 0, 0.8f)));
    expectNear(t.at(0.2f, 0.2f, {0, 0, 1}).normal, {-0.6f, 0, -0.8f});
    t.normals.assign(3, vec3(0.0f));
    expectNear(t.at(0.2f, 0.2f, {0, 0, 1}).normal, {0, 0, -1});
    t.normals.assign(3, vec3(std::nanf("")));
    expectNear(t.at(0.2f, 0.2f, {0, 0, -1}).normal, {0, 0, 1});
}

TEST(HitSurface, MapsMultiplyFactors) {
    OneTriangle t;
    t.material() = plainMaterial({0.5f, 1, 1, 0.5f}, {2, 4, 0}, 0.5f, 0.8f, kMaterialUnlit);
    t.material().occlusionStrength = 0.5f;
    t.material().baseColourMap = t.map(0xFF00FF80u, kMapSrgb);
    t.material().metallicRoughnessMap = t.map(0x00FF3300u);
    t.material().occlusionMap = t.map(0x00FFFF00u);
    t.material().emissionMap = t.map(0xFFFF33FFu);
    const HitSurface s = t.at(0.3f, 0.3f);
    expectNear(vec3(s.baseColour), {0.5f * 0.2158605f, 1, 0});
    EXPECT_NEAR(s.baseColour.w, 0.5f, 1e-6f);
    EXPECT_NEAR(s.roughness, 0.8f * 0.2f, 1e-6f);
    EXPECT_NEAR(s.metallic, 0.5f, 1e-6f);
    EXPECT_NEAR(s.occlusion, 0.5f, 1e-6f);
    expectNear(s.emission, {2, 0.8f, 0});
    EXPECT_EQ(s.flags, kMaterialUnlit);
}

// (0.5, 0, 0.866) in the map leans to where u grows; (0, 0.5, 0.866) to where v falls.
constexpr uint32_t kLeansU = 0xFFEE80BFu, kLeansV = 0xFFEEBF80u;
const vec3 kLeanU(0.5f, 0, 0.866f), kLeanV(0, 0.5f, 0.866f);

vec3 bent(OneTriangle t, uint32_t texel, const vec3& direction = {0, 0, -1}) {
    t.material().normalMap = t.map(texel);
    return t.at(0.25f, 0.25f, direction, kPartTextures).normal;
}

TEST(NormalMap, BendsAlongTheTexturesAxes) {
    OneTriangle t;
    expectNear(bent(t, 0xFFFF8080u), {0, 0, 1}, 0.006f);
    expectNear(bent(t, kLeansU), kLeanU, 0.006f);
    expectNear(bent(t, kLeansV), kLeanV, 0.006f);
    for (vec2& c : t.texCoords) c.x = -c.x;  // mirrored: u grows along -x
    expectNear(bent(t, kLeansU), {-0.5f, 0, 0.866f}, 0.006f);
    expectNear(bent(t, kLeansV), kLeanV, 0.006f);
    for (vec2& c : t.texCoords) c.x = 0.3f;  // no direction at all
    EXPECT_NEAR(glm::length(bent(t, kLeansU)), 1.0f, 1e-5f);
}

// A bump is a dent from behind: the normal there is the opposite.
TEST(NormalMap, IsReversedBehind) {
    expectNear(bent({}, kLeansU, {0, 0, 1}), -kLeanU, 0.006f);
    expectNear(bent({}, kLeansV, {0, 0, 1}), -kLeanV, 0.006f);
    OneTriangle mirrored;
    mirrored.surfaceOf[0] |= kMirrored;  // its front is where -z is
    expectNear(bent(mirrored, kLeansU, {0, 0, 1}), {0.5f, 0, -0.866f}, 0.006f);
    expectNear(bent(mirrored, kLeansU, {0, 0, -1}), {-0.5f, 0, 0.866f}, 0.006f);
}

TEST(NormalMap, ScaleWidensTheLean) {
    OneTriangle t;
    t.material().normalScale = 2.0f;
    expectNear(bent(t, kLeansU), glm::normalize(vec3(1.0f, 0, 0.866f)), 0.006f);
    t.material().normalScale = -1.0f;
    expectNear(bent(t, kLeansU), {-0.5f, 0, 0.866f}, 0.006f);
}

TEST(Alpha, MaskComparesAndBlendDraws) {
    OneTriangle t;
    t.material().baseColour.w = 0.4f;
    const auto there = [&](uint32_t flags, float cutoff, float chance) {
        t.material().flags = flags;
        t.material().alphaCutoff = cutoff;
        return isThere(t.arrays(), 0, t.material(), {1, 0, 0.2f, 0.2f}, chance);
    };
    EXPECT_TRUE(there(0, 0.5f, 0.9f)) << "opaque: alpha does not count";
    EXPECT_FALSE(there(kMaterialMask, 0.5f, 0.0f));
    EXPECT_TRUE(there(kMaterialMask, 0.4f, 0.9f)) << "alpha equal to the cutoff is there";
    EXPECT_TRUE(there(kMaterialBlend, 0.5f, 0.399f));
    EXPECT_FALSE(there(kMaterialBlend, 0.5f, 0.4f));
    t.material().baseColour.w = 0.0f;
    EXPECT_FALSE(there(kMaterialBlend, 0.5f, 0.0f));
}

TEST(Sides, FrontIsCounterclockwiseUnlessMirrored) {
    OneTriangle t;
    EXPECT_TRUE(comesToFront(t.arrays(), 0, t.triangle, {0.1f, 0.1f, -1}));
    EXPECT_FALSE(comesToFront(t.arrays(), 0, t.triangle, {0.1f, 0.1f, 1}));
    t.surfaceOf[0] |= kMirrored;
    EXPECT_FALSE(comesToFront(t.arrays(), 0, t.triangle, {0.1f, 0.1f, -1}));
    EXPECT_TRUE(comesToFront(t.arrays(), 0, t.triangle, {0.1f, 0.1f, 1}));
    t.surfaceOf[0] |= kNoBack;
    EXPECT_TRUE(comesToFront(t.arrays(), 0, t.triangle, {0.1f, 0.1f, -1}));
    EXPECT_EQ(materialOf(t.arrays(), 0).roughness, t.material().roughness) << "bits are no part of the number";
}

}  // namespace
}  // namespace cleave::test
