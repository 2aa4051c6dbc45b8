#include "app/session.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "figures/timing.h"
#include "support/program.h"

namespace cleave::test {
namespace {

std::string complaintOf(uint64_t cappedRays, const CheckResult& check) {
    try {
        requireAnswered(cappedRays, check, "scene.glb");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(RequireAnswered, OneWrongRayIsAFailure) {
    CheckResult check;
    check.rays = 2048;
    check.undecided = 3;
    EXPECT_EQ(complaintOf(0, check), "") << "undecided rays are told, but no failure";
    check.mismatches = 1;
    check.first = "ray 5 hits 7";
    const std::string complaint = complaintOf(0, check);
    for (const char* part : {"scene.glb", "1 of 2,048", "ray 5 hits 7"})
        EXPECT_NE(complaint.find(part), std::string::npos) << complaint;
}

TEST(RequireAnswered, ARayThatWasGivenUpIsAFailure) {
    EXPECT_EQ(complaintOf(0, {}), "");
    EXPECT_NE(complaintOf(1, {}).find("given up"), std::string::npos);
}

// Loads and builds on the CPU; no device is opened.
TEST(Session, BuildsWithoutADevice) {
    const TemporaryFolder folder;
    put(folder / "scene.gltf", triangleScene());
    Options options;
    options.quiet = true;
    cleave::Run run(options);
    Session session(run, folder / "scene.gltf");
    EXPECT_EQ(session.posed().triangles.size(), 1u);
    EXPECT_EQ(session.worldBounds().lo, vec3(-1, -1, 0));
    EXPECT_EQ(session.worldBounds().hi, vec3(3, 3, 0));
    const BuiltTree built = session.buildTimed(Builder::exact, 3);
    EXPECT_EQ(built.runs.size(), 3u);
    EXPECT_EQ(built.ms, medianOf(built.runs));
    EXPECT_EQ(built.hash, treeHash(built.tree));
    EXPECT_EQ(built.statistics.references, 1u);
    EXPECT_GE(built.peakBytes, sizeof(KdNode) + sizeof(uint32_t));
    EXPECT_FALSE(run.device.isOpen());
    EXPECT_EQ(run.device.name(), std::nullopt);
}

TEST(Session, CheckFindsAWrongHit) {
    const TemporaryFolder folder;
    put(folder / "scene.gltf", triangleScene());
    Options options;
    options.quiet = true;
    cleave::Run run(options);
    Session session(run, folder / "scene.gltf");
    const std::vector<Ray> rays{{vec3(0, 0, 2), 0, vec3(0, 0, -1), infinity()}};
    std::vector<Hit> hits{{2.0f, 0, 0.25f, 0.25f}};
    EXPECT_EQ(session.check(rays, hits, Query::closest, 1).mismatches, 0u);
    hits[0].t = 2.001f;
    EXPECT_EQ(session.check(rays, hits, Query::closest, 1).mismatches, 1u);
    EXPECT_EQ(session.check(rays, hits, Query::any, 1).mismatches, 0u) << "any hit: hit or miss only";
}

TEST(DefaultScene, IsThere) { EXPECT_TRUE(std::filesystem::exists(defaultScene())); }

}  // namespace
}  // namespace cleave::test
