// --instances, on the command line: the same hits and pictures, or a sentence.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace cleave::test {
namespace {

using Json = nlohmann::json;

// The triangle three times, once mirrored, beside one that is not shared, and the camera.
std::string threeTimes() {
    Json scene = Json::parse(triangleScene());
    scene["nodes"].push_back({{"mesh", 0}, {"translation", {0.5, 0.25, -1}}, {"scale", {-0.5, 1, 2}}});
    scene["nodes"].push_back({{"mesh", 0}, {"translation", {-0.25, 0, 0.5}}, {"rotation", {0.6, 0, 0, 0.8}}});
    scene["nodes"].push_back({{"mesh", 1}, {"translation", {0, -0.5, -2}}});
    scene["meshes"].push_back(scene["meshes"][0]);
    scene["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    return scene.dump();
}

void putRays(const std::filesystem::path& file) {
    std::vector<float> values;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            const float x = static_cast<float>(i) * 0.1f - 1.5f, y = static_cast<float>(j) * 0.1f - 1.5f;
            for (const float v : {x, y, 3.0f, 0.0f, 0.01f * y, 0.02f, -1.0f, std::numeric_limits<float>::infinity()})
                values.push_back(v);
        }
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (1600, 8), }";
    header.resize(117, ' ');
    header += '\n';
    std::string bytes("\x93NUMPY\x01\x00\x76\x00", 10);
    bytes += header + std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    put(file, bytes);
}

TEST(InstancesOfPrograms, TraceAndShowTheSame) {
    const TemporaryFolder folder;
    put(folder / "s.gltf", threeTimes());
    putRays(folder / "rays.npy");
    for (const std::string how : {"on", "off"}) {
        const Outcome traced =
            runCleave({"trace", folder / "s.gltf", folder / "rays.npy", "-o", folder / (how + ".npy"), "--instances",
                       how, "--json", folder / (how + ".json"), "--check", "1600"});
        ASSERT_EQ(traced.status, 0) << traced.err;
        const Outcome shown = runCleave({"render", folder / "s.gltf", "-o", folder / (how + ".png"), "--view", "depth",
                                         "--size", "64x48", "--instances", how, "--check", "100"});
        ASSERT_EQ(shown.status, 0) << shown.err;
    }
    EXPECT_EQ(contentOf(folder / "on.npy"), contentOf(folder / "off.npy"));
    EXPECT_EQ(contentOf(folder / "on.png"), contentOf(folder / "off.png"));
    const Json on = Json::parse(contentOf(folder / "on.json")), off = Json::parse(contentOf(folder / "off.json"));
    EXPECT_EQ(on["scene"]["triangles"], 4);
    EXPECT_EQ(off["scene"]["triangles"], 4);
    EXPECT_EQ(on["build"]["instances"]["places"], 3);
    EXPECT_EQ(on["build"]["instances"]["restTriangles"], 1);
    EXPECT_EQ(on["build"]["trees"], 2);
    EXPECT_EQ(off["build"]["trees"], 1);
    EXPECT_FALSE(off["build"].contains("instances"));
    EXPECT_EQ(on["check"]["mismatches"], 0);
}

TEST(InstancesOfPrograms, SayWhyThereAreNone) {
    const TemporaryFolder folder;
    put(folder / "one.gltf", triangleScene());
    put(folder / "s.gltf", threeTimes());
    putRays(folder / "rays.npy");
    const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& why) {
        arguments.insert(arguments.end(), {"--instances", "on"});
        const Outcome outcome = runCleave(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.errorLines(), 1u);
    };
    refused({"trace", folder / "one.gltf", folder / "rays.npy", "-o", folder / "h.npy"}, 1, "stands in two places");
    refused({"trace", folder / "s.gltf", folder / "rays.npy", "-o", folder / "h.npy", "--all", "3"}, 2, "single tree");
    refused({"render", folder / "s.gltf", "-o", folder / "p.png"}, 2, "only the views depth, steps and leaves");
    refused({"render", folder / "s.gltf", "-o", folder / "p.png", "--view", "depth", "--frames", "0:1", "--fps", "1"},
            2, "frames");
}

}  // namespace
}  // namespace cleave::test
