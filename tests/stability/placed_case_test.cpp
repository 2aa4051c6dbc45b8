// Cases in places are what stability says of them.
#include "stability/placed_case.h"

#include <gtest/gtest.h>

#include "stability/cases.h"
#include "tree/triangle_set.h"

namespace cleave {
namespace {

constexpr uint64_t kSeed = 1;

std::vector<Triangle> made(const StabilityCase& from) {
    Random random(seedFor(kSeed, from.name));
    return from.make(random, true);
}

size_t placesOf(const PlacedCase& placed) {
    size_t places = 0;
    for (const PlacedMesh& place : placed.instances.places) places += place.isWorld == 0 ? 1 : 0;
    return places;
}

double volume(std::span<const Triangle> triangles) {
    double sum = 0.0;
    for (const Triangle& t : triangles) sum += glm::dot(dvec3(t.a), glm::cross(dvec3(t.b), dvec3(t.c))) / 6.0;
    return sum;
}

TEST(PlacedCases, KeepTheCaseInItsOwnPlaceFirst) {
    for (const StabilityCase& from : stabilityCases()) {
        SCOPED_TRACE(from.name);
        const std::vector<Triangle> mesh = made(from);
        Random random(kSeed);
        const PlacedCase placed = placedCase(mesh, random);
        ASSERT_EQ(placed.world.size(), 3 * mesh.size());
        EXPECT_EQ(placed.instances.triangles, placed.world.size());
        for (size_t i = 0; i < mesh.size(); ++i) {
            if (!isFiniteTriangle(mesh[i])) continue;
            const Triangle& t = placed.world[i];
            ASSERT_TRUE(t.a == mesh[i].a && t.b == mesh[i].b && t.c == mesh[i].c) << i;
        }
    }
}

// Else instances would be tried in name only: what cannot be placed is copied.
TEST(PlacedCases, AreNearlyAllPlacedThrice) {
    size_t thrice = 0;
    for (const StabilityCase& from : stabilityCases()) {
        Random random(kSeed);
        thrice += placesOf(placedCase(made(from), random)) == 3 ? 1 : 0;
    }
    EXPECT_GE(thrice, 40u);
}

TEST(PlacedCases, TurnStretchAndMirror) {
    Random random(kSeed);
    const std::vector<Triangle> mesh{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                     {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const PlacedCase placed = placedCase(mesh, random);
    const std::span<const Triangle> all = placed.world;
    EXPECT_NEAR(volume(all.first(4)), 1.0 / 6.0, 1e-6);
    EXPECT_GT(volume(all.subspan(4, 4)), 1.0 / 6.0 / 8.0);
    EXPECT_NEAR(volume(all.subspan(8)), -1.0 / 6.0, 1e-6) << "mirrored";
    for (const vec3& v : {all[4].b - all[4].a, all[4].c - all[4].a, all[5].c - all[5].a})
        EXPECT_TRUE(v.x != 0.0f && v.y != 0.0f && v.z != 0.0f) << "turned";
}

}  // namespace
}  // namespace cleave
