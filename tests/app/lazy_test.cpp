// --lazy, on the command line: the same hits and pictures, or a sentence.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/ray_file.h"

namespace cleave::test {
namespace {

using Json = nlohmann::json;

const std::string kScene = CLEAVE_SOURCE "/scenes/still_life.glb";

// Down on one place of the still life, which has 68,016 triangles.
std::vector<Ray> fewRays() {
    std::vector<Ray> rays;
    for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 30; ++j) {
            const float x = 0.004f * static_cast<float>(i), z = 0.004f * static_cast<float>(j);
            rays.push_back({vec3(x, 50.0f, z), 0.0f, vec3(0.01f * x, -1.0f, 0.02f), infinity()});
        }
    return rays;
}

class LazyPrograms : public testing::Test {
  protected:
    TemporaryFolder folder;
    void SetUp() override { put(folder / "rays.npy", rayFile(fewRays())); }

    Outcome trace(const std::string& name, std::vector<std::string> more) const {
        std::vector<std::string> all{
            "trace", kScene, folder / "rays.npy", "-o", folder / (name + ".npy"), "--json", folder / (name + ".json")};
        all.insert(all.end(), more.begin(), more.end());
        return runCleave(all);
    }
    Json figures(const std::string& name) const { return Json::parse(contentOf(folder / (name + ".json"))); }
};

TEST_F(LazyPrograms, TraceAndShowTheSame) {
    for (const std::string how : {"on", "off"}) {
        const Outcome traced = trace(how, {"--lazy", how, "--check", "900"});
        ASSERT_EQ(traced.status, 0) << traced.err;
        EXPECT_EQ(traced.out.find("lazily") != std::string::npos, how == "on") << traced.out;
        const Outcome shown = runCleave({"render", kScene, "-o", folder / (how + ".png"), "--size", "64x36", "--lazy",
                                         how, "--spp", "2", "--check", "100"});
        ASSERT_EQ(shown.status, 0) << shown.err;
    }
    EXPECT_EQ(contentOf(folder / "on.npy"), contentOf(folder / "off.npy"));
    EXPECT_EQ(contentOf(folder / "on.png"), contentOf(folder / "off.png"));
    const Json on = figures("on")["build"], off = figures("off")["build"];
    EXPECT_GT(on["lazyBuiltShare"], 0.0);
    EXPECT_LT(on["lazyBuiltShare"], 0.5) << "the rays go to one place";
    EXPECT_LT(on["nodes"], off["nodes"]);
    EXPECT_GT(on["neverBuilt"], 0);
    EXPECT_GT(on["expansions"], 0);
    EXPECT_FALSE(off.contains("lazyBuiltShare"));
}

// By itself where rays are few, unless a builder is asked for.
TEST_F(LazyPrograms, ChooseByTheNumberOfRays) {
    ASSERT_EQ(trace("few", {}).status, 0);
    EXPECT_TRUE(figures("few")["build"].contains("lazyBuiltShare"));
    ASSERT_EQ(trace("named", {"--builder", "gpu"}).status, 0);
    EXPECT_FALSE(figures("named")["build"].contains("lazyBuiltShare"));
    std::vector<Ray> many;
    for (int i = 0; i < 160; ++i)
        for (const Ray& ray : fewRays()) many.push_back(ray);
    put(folder / "rays.npy", rayFile(many));
    ASSERT_EQ(trace("many", {}).status, 0);
    EXPECT_FALSE(figures("many")["build"].contains("lazyBuiltShare"));
}

TEST_F(LazyPrograms, SayWhyTheWholeTreeIsNeeded) {
    const auto refused = [&](const Outcome& outcome, const std::string& why) {
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.errorLines(), 1u);
    };
    refused(trace("a", {"--lazy", "on", "--all", "3"}), "do not wait");
    refused(trace("b", {"--lazy", "on", "--builder", "exact"}), "only the builder gpu");
    refused(trace("c", {"--lazy", "on", "--instances", "on"}), "each mesh a tree");
    refused(trace("d", {"--lazy", "on", "--split-moving", "on"}), "a tree of its own");
    refused(trace("e", {"--lazy", "on", "--keep-all"}), "leaves nothing out");
    refused(runCleave({"render", kScene, "-o", folder / "p.png", "--lazy", "on", "--view", "path"}), "paths");
    refused(runCleave({"render", kScene, "-o", folder / "p.png", "--lazy", "on", "--view", "steps"}), "shows it");
    refused(trace("f", {"--lazy", "perhaps"}), "perhaps");
}

}  // namespace
}  // namespace cleave::test
