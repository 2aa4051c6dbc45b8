// Rays that are none, and files that hold no rays: misses that are counted, or status 1 with one line and no output.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/ray_file.h"

namespace cleave::test {
namespace {

using Json = nlohmann::json;

const float kNan = std::numeric_limits<float>::quiet_NaN();

// Straight down onto the middle of the triangle, at t = 1.
Ray goodRay() { return {{0, 0, 2}, 0.0f, {0, 0, -2}, infinity()}; }

using Spoil = std::function<void(Ray&)>;

// Each of them alone makes a good ray a bad one.
std::vector<Spoil> spoilers() {
    std::vector<Spoil> all;
    for (const float bad : {kNan, -kNan, infinity(), -infinity()}) {
        for (int axis = 0; axis < 3; ++axis) {
            all.push_back([=](Ray& r) { r.origin[axis] = bad; });
            all.push_back([=](Ray& r) { r.direction[axis] = bad; });
        }
        all.push_back([=](Ray& r) { r.tMin = bad; });
        if (bad != infinity()) all.push_back([=](Ray& r) { r.tMax = bad; });
    }
    all.push_back([](Ray& r) { r.direction = vec3(0.0f); });
    all.push_back([](Ray& r) { r.direction = vec3(-0.0f, 0.0f, -0.0f); });
    all.push_back([](Ray& r) { r.tMin = -1.0f; });
    all.push_back([](Ray& r) { r.tMin = -std::numeric_limits<float>::denorm_min(); });
    all.push_back([](Ray& r) {
        r.tMin = 2.0f;
        r.tMax = 0.5f;
    });
    all.push_back([](Ray& r) {
        r.tMin = std::nextafter(1.0f, 2.0f);
        r.tMax = 1.0f;
    });
    return all;
}

class BadRays : public testing::Test {
  protected:
    void SetUp() override { put(folder_ / "scene.gltf", triangleScene()); }
    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    Outcome trace(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"trace", at("scene.gltf"), at("rays.npy"), "-o", at("hits.npy")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCleave(arguments);
    }
    std::vector<Hit> hits(size_t count) const {
        const std::string bytes = contentOf(folder_ / "hits.npy");
        std::vector<Hit> all(count);
        if (bytes.size() < count * sizeof(Hit)) return {};
        std::memcpy(all.data(), bytes.data() + bytes.size() - count * sizeof(Hit), count * sizeof(Hit));
        return all;
    }
    void expectRefused(const std::string& file, const std::string& part) const {
        SCOPED_TRACE(part);
        put(folder_ / "rays.npy", file);
        const Outcome outcome = trace({"--builder", "exact"});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        EXPECT_EQ(folder_.names().size(), 2u) << "nothing may be left beside the scene and the rays";
    }

    TemporaryFolder folder_;
};

TEST_F(BadRays, AreMissesAndCountedWhateverTheBuilderAndTraversal) {
    std::vector<Ray> rays;
    for (const Spoil& spoil : spoilers()) {
        rays.push_back(goodRay());
        rays.push_back(goodRay());
        spoil(rays.back());
    }
    put(folder_ / "rays.npy", rayFile(rays));
    for (const auto& more : std::vector<std::vector<std::string>>{{},
                                                                  {"--any"},
                                                                  {"--builder", "brute"},
                                                                  {"--builder", "exact", "--traversal", "stack"},
                                                                  {"--traversal", "stack", "--any"}}) {
        std::vector<std::string> arguments = more;
        arguments.insert(arguments.end(), {"--check", "1000", "--json", at("report.json")});
        const Outcome outcome = trace(arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const std::vector<Hit> answers = hits(rays.size());
        ASSERT_EQ(answers.size(), rays.size());
        for (size_t i = 0; i < rays.size(); i += 2) {
            EXPECT_EQ(answers[i].prim, 0u) << "beside bad ray " << i / 2;
            EXPECT_EQ(answers[i].t, 1.0f);
            const Hit miss = missedHit();
            EXPECT_EQ(std::memcmp(&answers[i + 1], &miss, sizeof miss), 0) << "bad ray " << i / 2;
        }
        const Json report = Json::parse(contentOf(folder_ / "report.json"));
        EXPECT_EQ(report["trace"]["invalidRays"], rays.size() / 2);
        EXPECT_EQ(report["check"]["mismatches"], 0);
    }
}

TEST_F(BadRays, WhatIsUnusualButARayIsAnswered) {
    std::vector<Ray> rays(4, goodRay());
    rays[0].tMin = rays[0].tMax = 1.0f;  // an interval of one point, which is the hit
    rays[1].tMin = -0.0f;
    rays[2].direction = vec3(-0.0f, 0.0f, -std::numeric_limits<float>::denorm_min());
    rays[3].direction = vec3(0.0f, 0.0f, -std::numeric_limits<float>::max());
    put(folder_ / "rays.npy", npy("(4, 8)", bytesOf(rays)));
    const Outcome outcome = trace({"--json", at("report.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<Hit> answers = hits(4);
    EXPECT_EQ(answers[0].t, 1.0f);
    EXPECT_EQ(answers[1].t, 1.0f);
    EXPECT_EQ(answers[2].prim, kNone) << "t is beyond the largest float";
    EXPECT_EQ(answers[3].prim, 0u);
    EXPECT_EQ(Json::parse(contentOf(folder_ / "report.json"))["trace"]["invalidRays"], 0);
}

TEST_F(BadRays, FilesThatHoldNoRaysAreRefused) {
    const std::string data = bytesOf({goodRay(), goodRay()});
    const std::string good = npy("(2, 8)", data);
    expectRefused(npy("(2, 7)", data), "shape is not (N, 8)");
    expectRefused(npy("(16,)", data), "shape is not (N, 8)");
    expectRefused(npy("(8, 2)", data), "shape is not (N, 8)");
    expectRefused(npy("(2, 2, 4)", data), "shape is not (N, 8)");
    expectRefused(npy("(1, 8)", data, "<f8"), "type is '<f8'");
    expectRefused(npy("(2, 8)", data, "<i4"), "type is '<i4'");
    expectRefused(npy("(2, 8)", data, ">f4"), "type is '>f4'");
    expectRefused(npy("(2, 8)", data, "<f4", "True"), "Fortran order");
    expectRefused(good.substr(0, good.size() - 1), "announces 2 rays");
    expectRefused(good + "x", "announces 2 rays");
    expectRefused(good.substr(0, 40), "header is longer than the file");
    expectRefused(good.substr(0, 9), "cut short");
    expectRefused("", "cut short");
    expectRefused("0 0 2 0  0 0 -2 inf\n", "does not begin as a .npy file");
    expectRefused(triangleScene(), "does not begin as a .npy file");
}

// A failure leaves the hits of an earlier run as they are.
TEST_F(BadRays, ARefusalKeepsWhatWasThere) {
    put(folder_ / "hits.npy", "kept");
    put(folder_ / "rays.npy", npy("(2, 7)", ""));
    EXPECT_EQ(trace({"--builder", "exact"}).status, 1);
    EXPECT_EQ(contentOf(folder_ / "hits.npy"), "kept");
}

TEST_F(BadRays, NoRaysAreNoHits) {
    put(folder_ / "rays.npy", npy("(0, 8)", ""));
    for (const char* builder : {"gpu", "exact", "brute"}) {
        const Outcome outcome = trace({"--builder", builder, "--check", "10", "--json", at("report.json")});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(contentOf(folder_ / "hits.npy").find("'shape': (0,)"), std::string::npos);
        const Json report = Json::parse(contentOf(folder_ / "report.json"));
        EXPECT_EQ(report["trace"]["rays"], 0);
        EXPECT_EQ(report["trace"]["invalidRays"], 0);
    }
}

}  // namespace
}  // namespace cleave::test
