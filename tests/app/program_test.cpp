// The built program from outside: exit status, what it prints, which files are there afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "shared/ray.h"
#include "support/program.h"
#include "support/ray_file.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Program : public testing::Test {
  protected:
    void SetUp() override {
        scene_ = (folder_ / "scene.gltf").string();
        put(scene_, triangleScene());
    }
    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    Json reportOf(const std::string& name) const { return Json::parse(contentOf(folder_ / name)); }

    // The files beside the scene, in order of their names.
    std::vector<std::string> outputs() const {
        std::vector<std::string> names = folder_.names();
        std::erase_if(names, [](const std::string& name) { return name == "scene.gltf" || name.ends_with(".npy.in"); });
        std::sort(names.begin(), names.end());
        return names;
    }
    void expectFailure(const std::vector<std::string>& arguments, int status, const std::string& part) {
        const Outcome outcome = runCleave(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        EXPECT_EQ(outputs(), std::vector<std::string>{}) << "nothing may be left behind";
    }
    // A ray straight down onto the triangle, one past it, one that is none.
    void putRays(const std::string& name) const {
        put(folder_ / name, rayFile({{{0, 0, 2}, 0, {0, 0, -2}, infinity()},
                                     {{9, 9, 2}, 0, {0, 0, -1}, infinity()},
                                     {{0, 0, 2}, 0, {0, 0, 0}, infinity()}}));
    }

    TemporaryFolder folder_;
    std::string scene_;
};

TEST_F(Program, WrongUseIsStatus2) {
    for (const auto& wrong : std::vector<std::vector<std::string>>{{},
                                                                   {"rendr"},
                                                                   {"report"},
                                                                   {"render", "--size", "big"},
                                                                   {"render", scene_, "--builder", "nope"},
                                                                   {"render", scene_, "--spp", "4", "--view", "steps"},
                                                                   {"trace", scene_},
                                                                   {"query", scene_, at("points.npy.in")},
                                                                   {"info"},
                                                                   {"info", scene_, "--runs", "3"},
                                                                   {"bench"},
                                                                   {"devices", "extra"}})
        expectFailure(wrong, 2, "error: ");
    expectFailure({"render", scene_, "-o", at("out.png"), "--camera", "nope"}, 2, "main");
}

TEST_F(Program, HelpAndVersionAreStatus0) {
    for (const auto& asked : std::vector<std::vector<std::string>>{
             {"--help"}, {"--version"}, {"render", "--help"}, {"bench", "--help"}, {"trace", "--version"}}) {
        const Outcome outcome = runCleave(asked);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_FALSE(outcome.out.empty());
        EXPECT_EQ(outcome.err, "");
    }
}

TEST_F(Program, FailuresAreStatus1WithOneLine) {
    const std::string missing = at("none.glb");
    expectFailure({"info", missing}, 1, "none.glb");
    expectFailure({"render", missing, "-o", at("out.png")}, 1, "none.glb");
    expectFailure({"bench", missing}, 1, "none.glb");
    expectFailure({"trace", scene_, at("none.npy"), "-o", at("hits.npy")}, 1, "none.npy");
    expectFailure({"render", scene_, "-o", at("no/such/out.png")}, 1, "there is no folder");
    expectFailure({"render", scene_, "-o", at("out.png"), "--json", at("no/r.json")}, 1, "there is no folder");
    expectFailure({"info", scene_, "--json", folder_.path().string()}, 1, "it is a folder");
    expectFailure({"render", scene_, "-o", at("out.png"), "--device", "no such device"}, 1, "no such device");
}

TEST_F(Program, BadRaysLeaveNoOutput) {
    putRays("cut.npy.in");
    fs::resize_file(folder_ / "cut.npy.in", fs::file_size(folder_ / "cut.npy.in") - 1);
    expectFailure({"trace", scene_, at("cut.npy.in"), "-o", at("hits.npy")}, 1, "announces 3 rays");
}

TEST_F(Program, InfoTellsSceneAndTree) {
    const Outcome outcome = runCleave({"info", scene_, "--builder", "exact", "--validate", "--json", at("i.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part : {"triangles", "camera 0", "main", "SAH cost", "valid"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " in\n" << outcome.out;
    const Json report = reportOf("i.json");
    EXPECT_EQ(report["scene"]["triangles"], 1);
    EXPECT_EQ(report["scene"]["leftOut"]["points"], 0);
    EXPECT_EQ(report["scene"]["leftOut"]["noArea"], 0);
    EXPECT_EQ(report["build"]["builder"], "exact");
    EXPECT_EQ(report["build"]["references"], 1);
    EXPECT_EQ(report["validation"]["ok"], true);
    uint64_t reasons = 0;
    for (const auto& reason : report["build"]["leafReasons"]) reasons += reason.get<uint64_t>();
    EXPECT_EQ(reasons, report["build"]["leaves"].get<uint64_t>());
    EXPECT_GT(report["total"]["ms"], 0.0);
    EXPECT_GT(report["process"]["peakBytes"], report["build"]["peakBytes"]);
    EXPECT_EQ(outputs(), std::vector<std::string>{"i.json"});
}

// One triangle in one leaf: its test and the leaf's visit.
TEST_F(Program, ReportsNameTheConstantsOfTheirCost) {
    for (const char* builder : {"exact", "gpu"}) {
        const Outcome outcome = runCleave({"info", scene_, "--builder", builder, "--cost-leaf", "3", "--stop", "sa-n",
                                           "--cost-intersect", "8", "--json", at("i.json")});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const Json build = reportOf("i.json")["build"];
        EXPECT_EQ(build["sahCost"], 11.0);
        EXPECT_EQ(build["costTraverse"], 15.0) << "also where the stop does not go by it";
        EXPECT_EQ(build["costIntersect"], 8.0);
        EXPECT_EQ(build["costLeaf"], 3.0);
        EXPECT_EQ(build["emptyBonus"], 0.8);
    }
}

TEST_F(Program, InfoWithACpuBuilderNeedsNoDevice) {
    const std::string noDriver = "VK_DRIVER_FILES=/dev/null VK_ICD_FILENAMES=/dev/null";
    for (const char* builder : {"exact", "twin", "brute"}) {
        const Outcome outcome = runCleave({"info", scene_, "--builder", builder}, noDriver);
        EXPECT_EQ(outcome.status, 0) << builder << ": " << outcome.err;
    }
    const Outcome outcome = runCleave({"info", scene_, "--builder", "gpu", "--quiet"}, noDriver);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
}

TEST_F(Program, QuietPrintsNothing) {
    const Outcome outcome = runCleave({"info", scene_, "--builder", "exact", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(Program, AFullOutputIsAFailure) {
    const Outcome outcome = runCleave({"--help"}, "exec 9>/dev/full; f() { \"$@\" >&9; }; f");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
}

TEST_F(Program, TraceAnswersRays) {
    putRays("rays.npy.in");
    for (const char* builder : {"gpu", "gpu-exact", "exact", "twin", "brute"}) {
        const Outcome outcome = runCleave({"trace", scene_, at("rays.npy.in"), "-o", at("hits.npy"), "--builder",
                                           builder, "--check", "3", "--json", at("t.json")});
        ASSERT_EQ(outcome.status, 0) << builder << ": " << outcome.err;
        const std::string bytes = contentOf(folder_ / "hits.npy");
        ASSERT_EQ(bytes.size() % 64, 48u);
        Hit hits[3];
        std::memcpy(hits, bytes.data() + bytes.size() - sizeof hits, sizeof hits);
        EXPECT_EQ(hits[0].t, 1.0f) << "in units of the direction, which is 2 long";
        EXPECT_EQ(hits[0].prim, 0u);
        EXPECT_EQ(hits[0].u, 0.25f);
        EXPECT_EQ(hits[0].v, 0.25f);
        EXPECT_EQ(hits[1].prim, kNone);
        EXPECT_EQ(hits[1].t, infinity());
        EXPECT_EQ(hits[2].prim, kNone);
        const Json report = reportOf("t.json");
        EXPECT_EQ(report["trace"]["rays"], 3);
        EXPECT_EQ(report["trace"]["invalidRays"], 1);
        EXPECT_EQ(report["trace"]["cappedRays"], 0);
        EXPECT_EQ(report["check"]["mismatches"], 0);
        EXPECT_EQ(report["check"]["rays"], 3);
        EXPECT_TRUE(report["device"]["name"].is_string());
    }
    EXPECT_EQ(outputs(), (std::vector<std::string>{"hits.npy", "t.json"}));
}

TEST_F(Program, TraceWithAnyHit) {
    putRays("rays.npy.in");
    const Outcome outcome =
        runCleave({"trace", scene_, at("rays.npy.in"), "-o", at("hits.npy"), "--any", "--check", "3"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Program, ASavedTreeAnswersAsTheOneThatWasSaved) {
    putRays("rays.npy.in");
    const std::string tree = at("tree.npy.in");  // not an output
    ASSERT_EQ(runCleave({"info", scene_, "--save-tree", tree}).status, 0);
    const std::string saved = contentOf(tree);
    ASSERT_EQ(runCleave({"trace", scene_, at("rays.npy.in"), "-o", at("built.npy")}).status, 0);
    const Outcome loaded = runCleave({"trace", scene_, at("rays.npy.in"), "-o", at("loaded.npy"), "--tree", tree,
                                      "--check", "3", "--json", at("t.json")});
    ASSERT_EQ(loaded.status, 0) << loaded.err;
    EXPECT_EQ(contentOf(at("built.npy")), contentOf(at("loaded.npy")));
    EXPECT_EQ(reportOf("t.json")["build"]["builder"], "saved");
    EXPECT_EQ(runCleave({"render", scene_, "-o", at("p.png"), "--size", "8x8", "--tree", tree}).status, 0);
    EXPECT_EQ(runCleave({"info", scene_, "--validate", "--tree", tree}).status, 0);
    for (const char* name : {"built.npy", "loaded.npy", "t.json", "p.png"}) fs::remove(at(name));

    const auto refused = [&](const std::string& content, const std::string& part) {
        put(tree, content);
        expectFailure({"trace", scene_, at("rays.npy.in"), "-o", at("h.npy"), "--tree", tree}, 1, part);
    };
    refused("", "tree.npy.in: cannot load the tree");
    refused(saved.substr(0, saved.size() - 4), "bytes");
    refused(std::string(saved).replace(60, 1, 1, static_cast<char>(saved[60] ^ 4)), "checksum");
    refused(std::string(200, 'x'), "these bytes are none");
    put(tree, saved);
    std::string other = triangleScene();
    other.replace(other.find("\"buffers\""), 0, "\"extras\": 1, ");  // the same triangles
    put(scene_, other);
    EXPECT_EQ(runCleave({"info", scene_, "--tree", tree}).status, 0);
    expectFailure({"info", std::string(CLEAVE_SOURCE) + "/scenes/cornell.glb", "--tree", tree}, 1, "other triangles");
    expectFailure({"info", scene_, "--tree", at("none")}, 1, "cannot read the tree");
    expectFailure({"info", scene_, "--save-tree", at("no/such")}, 1, "cannot write");
}

TEST_F(Program, TheSameRenderTwiceGivesTheSameBytes) {
    for (const char* view : {"shaded", "normals", "depth", "steps", "leaves"}) {
        for (const char* name : {"a.png", "b.png"}) {
            const Outcome outcome =
                runCleave({"render", scene_, "-o", at(name), "--size", "128x96", "--view", view, "--quiet"});
            ASSERT_EQ(outcome.status, 0) << view << ": " << outcome.err;
            EXPECT_EQ(outcome.out, "");
        }
        EXPECT_EQ(contentOf(folder_ / "a.png").substr(0, 4), "\x89PNG");
        EXPECT_EQ(contentOf(folder_ / "a.png"), contentOf(folder_ / "b.png")) << view;
    }
    EXPECT_EQ(outputs(), (std::vector<std::string>{"a.png", "b.png"}));
}

TEST_F(Program, RenderWritesEveryKeyOfItsReport) {
    const Outcome outcome = runCleave({"render", scene_, "-o", at("a.png"), "--size", "64x48", "--camera", "main",
                                       "--check", "500", "--json", at("r.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json report = reportOf("r.json");
    for (const char* key : {"/scene/triangles",
                            "/scene/leftOut",
                            "/device/name",
                            "/build/builder",
                            "/build/ms",
                            "/build/setupMs",
                            "/build/sahCost",
                            "/build/treeHash",
                            "/build/nodes",
                            "/build/leaves",
                            "/build/references",
                            "/build/maxDepth",
                            "/build/peakBytes",
                            "/build/expectedInner",
                            "/build/expectedLeaves",
                            "/build/expectedTriangles",
                            "/build/memoryLimited",
                            "/trace/rays",
                            "/trace/ms",
                            "/trace/mraysPerSecond",
                            "/trace/traversal",
                            "/trace/invalidRays",
                            "/trace/cappedRays",
                            "/check/rays",
                            "/check/mismatches",
                            "/check/undecided",
                            "/check/maxRelativeTError",
                            "/total/ms"})
        EXPECT_TRUE(report.contains(Json::json_pointer(key))) << key;
    EXPECT_EQ(report["trace"]["rays"], 64 * 48);
    EXPECT_EQ(report["check"]["rays"], 500);
    EXPECT_EQ(report["check"]["mismatches"], 0);
    EXPECT_GT(report["trace"]["ms"], 0.0);
}

TEST_F(Program, PathsAreTheSameBytesEveryTime) {
    for (const char* name : {"a.png", "b.png"}) {
        const Outcome outcome = runCleave({"render", scene_, "-o", at(name), "--size", "32x24", "--view", "path",
                                           "--spp", "3", "--check", "100", "--json", at("p.json")});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("3 samples per pixel"), std::string::npos) << outcome.out;
    }
    EXPECT_EQ(contentOf(folder_ / "a.png"), contentOf(folder_ / "b.png"));
    const Json report = reportOf("p.json");
    EXPECT_EQ(report["render"]["samples"], 3);
    EXPECT_EQ(report["check"]["mismatches"], 0);
    EXPECT_EQ(report["check"]["rays"], 100);
}

TEST_F(Program, MoreSamplesSmoothTheEdgesOfAShadedPicture) {
    const auto render = [&](const char* samples) {
        const Outcome outcome = runCleave({"render", scene_, "-o", at("a.exr"), "--size", "32x24", "--spp", samples});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return contentOf(folder_ / "a.exr");
    };
    const std::string one = render("1");
    EXPECT_EQ(one.substr(0, 4), "\x76\x2f\x31\x01") << "the mark of OpenEXR";
    EXPECT_NE(one, render("4"));
}

TEST_F(Program, ATimeLimitKeepsTheSamplesThatThereAre) {
    const Outcome outcome = runCleave({"render", scene_, "-o", at("a.png"), "--size", "64x48", "--view", "path",
                                       "--spp", "1000000", "--time-limit", "0.2", "--json", at("p.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const uint64_t samples = reportOf("p.json")["render"]["samples"];
    EXPECT_GE(samples, 1u);
    EXPECT_LT(samples, 1000000u);
    EXPECT_TRUE(contentOf(folder_ / "a.png").starts_with("\x89PNG"));
}

// The program is told to end once it has begun to take samples; it writes what it has and says so.
TEST_F(Program, AnInterruptedPictureIsSaved) {
    const std::string interrupted = "f() { \"$@\" & sleep 3; kill -TERM $!; wait $!; }; f";
    const Outcome outcome = runCleave({"render", scene_, "-o", at("a.png"), "--size", "64x48", "--view", "path",
                                       "--spp", "10000000", "--time-limit", "60"},
                                      interrupted);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted after"), std::string::npos) << outcome.err;
    EXPECT_TRUE(contentOf(folder_ / "a.png").starts_with("\x89PNG"));
}

TEST_F(Program, AnotherEyeGivesAnotherPicture) {
    const auto render = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", scene_, "-o", at("a.png"), "--size", "64x48", "--view", "depth"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = runCleave(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return contentOf(folder_ / "a.png");
    };
    const std::string own = render({});
    EXPECT_EQ(own, render({"--camera", "0"}));
    EXPECT_NE(own, render({"--eye", "1,2,3", "--look", "0,0,0"}));
    EXPECT_NE(own, render({"--fov", "10"}));
}

TEST_F(Program, BenchComparesPeersOnTheSameRays) {
    const Outcome outcome = runCleave({"bench", scene_, "--runs", "1", "--builder", "exact", "--check", "64", "--peers",
                                       "--work", "--json", at("b.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json report = reportOf("b.json");
    ASSERT_EQ(report["builders"].size(), 1u);
    ASSERT_EQ(report["peers"].size(), 6u);
    for (const Json& peer : report["peers"]) {
        const std::string name = peer["name"];
        EXPECT_NE(outcome.out.find(name), std::string::npos) << name << " in\n" << outcome.out;
        if (peer.contains("missing")) continue;
        const bool isSlow = name.starts_with("ray-") && peer["order"] == "file";
        for (const char* set : {"primary", "diffuse", "shadow"}) {
            EXPECT_LE(peer["sets"][set]["rays"], isSlow ? 65536 : 1024 * 1024) << name;
            EXPECT_LE(peer["sets"][set]["disagreements"], 100) << name << ", " << set;
            EXPECT_GT(peer["sets"][set]["mraysPerSecond"], 0.0) << name << ", " << set;
        }
    }
    const Json& work = report["sets"]["primary"]["work"];
    EXPECT_GT(work["leaves"], 0.0);
    EXPECT_EQ(work["triangles"], work["leaves"]) << "the scene is one triangle, its tree one leaf";
}

TEST_F(Program, BenchShowsBuildersSideBySide) {
    const Outcome outcome =
        runCleave({"bench", scene_, "--runs", "1", "--builder", "gpu,exact", "--check", "64", "--json", at("b.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part : {"gpu", "exact", "/exact", "primary ms", "Mrays/s"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " in\n" << outcome.out;
    const Json report = reportOf("b.json");
    for (const char* set : {"primary", "diffuse", "shadow"}) {
        EXPECT_EQ(report["sets"][set]["rays"], 1024 * 1024) << set;
        EXPECT_GT(report["sets"][set]["ms"], 0.0) << set;
        EXPECT_EQ(report["sets"][set]["check"]["rays"], 64) << set;
        EXPECT_EQ(report["sets"][set]["check"]["mismatches"], 0) << set;
    }
    ASSERT_EQ(report["builders"].size(), 2u);
    EXPECT_EQ(report["builders"][1]["build"]["builder"], "exact");
    for (const char* set : {"primary", "diffuse", "shadow"}) {
        const std::string hash = report["sets"][set]["hitsHash"];
        EXPECT_EQ(hash.size(), 16u) << set;
        EXPECT_EQ(report["builders"][1]["sets"][set]["hitsHash"], hash) << set << " rays have one answer";
    }
    EXPECT_NE(report["sets"]["primary"]["hitsHash"], report["sets"]["diffuse"]["hitsHash"]);
    EXPECT_EQ(report["check"]["rays"], 3 * 64);
}

TEST_F(Program, BenchOfTheSurveyMeasuresEveryBuilder) {
    const Outcome outcome =
        runCleave({"bench", scene_, "--survey", "--runs", "2", "--check", "64", "--json", at("s.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part :
         {"Table 5.1", "Table 6.1", "Table 6.2", "Table 7.1", "Section 4", "Section 5", "hunt-hybrid", "12.7m"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " in\n" << outcome.out;
    const Json report = reportOf("s.json");
    EXPECT_EQ(report["scene"]["triangles"], 1);
    EXPECT_TRUE(report["survey"]["model"].is_null());
    ASSERT_EQ(report["survey"]["builders"].size(), 9u);
    for (const Json& builder : report["survey"]["builders"]) {
        const bool isMedian = std::string(builder["builder"]).ends_with("median");
        EXPECT_EQ(builder["pure"].is_null(), isMedian) << builder["builder"];
        if (!isMedian) {
            EXPECT_EQ(builder["pure"]["allThreadsMs"].size(), 2u);
            EXPECT_EQ(builder["pure"]["check"]["mismatches"], 0);
            EXPECT_EQ(builder["pure"]["treeHash"], builder["treeHash"]) << "one triangle";
        }
        EXPECT_EQ(builder["allThreadsMs"].size(), 2u);
        EXPECT_EQ(builder["oneThreadMs"].size(), builder["builder"] == "gpu" ? 0u : 2u);
        EXPECT_EQ(builder["primaryMs"].size(), 2u);
        EXPECT_EQ(builder["check"]["rays"], 2 * 64);
        EXPECT_EQ(builder["check"]["mismatches"], 0);
    }
    const Json& medians = report["survey"]["medians"];
    EXPECT_EQ(medians["trees"].size(), 2u * 3 * 4);
    EXPECT_EQ(medians["trees"][0]["axes"], "all");
    EXPECT_EQ(medians["trees"][1]["leafSize"], 4);
    EXPECT_EQ(medians["trees"][23]["builder"], "object-median");
    EXPECT_EQ(medians["exactSahCost"], report["survey"]["builders"][0]["sahCost"]);
}

// Every row against the definition, by the rows of the file alone.
void expectFronts(const Json& rows) {
    for (const Json& row : rows) {
        bool beaten = false;
        for (const Json& other : rows) {
            if (other["scene"] != row["scene"]) continue;
            const double error = row["error"], ms = row["ms"], otherError = other["error"], otherMs = other["ms"];
            beaten |= otherError <= error && otherMs <= ms && (otherError < error || otherMs < ms);
        }
        EXPECT_EQ(row["pareto"], !beaten) << row;
    }
}

// The rows of a report's figures.
void expectErrors(const Json& report) {
    const Json& errors = report["errors"];
    ASSERT_GE(errors["tree"].size(), 10u) << "builders at their defaults, and exact with two other costs";
    ASSERT_EQ(errors["rays"].size(), errors["tree"].size());
    ASSERT_EQ(report["predictions"].size(), errors["tree"].size());
    ASSERT_EQ(errors["hits"].size(), 9u) << "three traversals, three triangle tests";
    for (const char* kind : {"tree", "rays", "hits"}) {
        for (const Json& row : errors[kind]) {
            for (const char* key : {"scene", "builder", "settings"}) EXPECT_TRUE(row[key].is_string()) << kind << key;
            for (const char* key : {"error", "ms", "msLow", "msHigh"}) EXPECT_TRUE(row[key].is_number()) << kind << key;
            EXPECT_TRUE(row["pareto"].is_boolean());
            EXPECT_EQ(row["scene"], "scene.gltf");
            EXPECT_EQ(row["runs"], 2);
            EXPECT_LE(row["msLow"], row["ms"]);
            EXPECT_GE(row["msHigh"], row["ms"]);
        }
        expectFronts(errors[kind]);
    }
    ASSERT_EQ(errors["picture"].size(), 5u) << "2 to 32 samples";
    for (const Json& row : errors["picture"]) {
        EXPECT_GT(row["error"], 0.0) << "the triangle's edges";
        EXPECT_LT(row["error"], 100.0);
        EXPECT_LE(row["similarity"], 1.0);
        EXPECT_EQ(row["runs"], 2);
        EXPECT_GT(row["ms"], 0.0);
    }
    expectFronts(errors["picture"]);
    EXPECT_LT(report["picture"]["slopeBySamples"], -0.4);
    EXPECT_GT(report["picture"]["slopeBySamples"], -0.6);
    EXPECT_LT(report["picture"]["slope"], 0.0);
    EXPECT_GT(report["picture"]["scenes"][0]["referenceError"], 0.0);
    EXPECT_EQ(errors["tree"][0]["builder"], "exact");
    EXPECT_EQ(errors["tree"][0]["error"], 0.0);
    EXPECT_EQ(errors["rays"][0]["error"], 0.0);
    for (const Json& row : errors["hits"]) EXPECT_EQ(row["error"], 0.0) << "one triangle has no edge to slip through";
    EXPECT_TRUE(report["device"]["name"].is_string());
    EXPECT_GT(report["total"]["ms"], 0.0);
}

// Ended without a chance to clean up, after some figures; the next run takes these over and writes what a run without
// an interruption does. Both take half a minute, so that one test looks at all of it.
TEST_F(Program, ReportGoesOnAfterAnInterruption) {
    const std::vector<std::string> asked{"report", scene_, "-o", at("r"), "--quick", "--check", "64", "--peers"};
    const std::string notes = at("r/unfinished.jsonl");
    const std::string interrupted = "f() { \"$@\" & while [ \"$(cat '" + notes +
                                    "' 2>/dev/null | wc -l)\" -lt 6 ] && kill -0 $! 2>/dev/null; do "
                                    "sleep 0.02; done; kill -9 $!; wait $!; }; f";
    ASSERT_NE(runCleave(asked, interrupted).status, 0);
    std::istringstream before(contentOf(notes));
    std::string ofRun, ofFirstTree;
    ASSERT_TRUE(std::getline(before, ofRun) && std::getline(before, ofFirstTree));
    EXPECT_FALSE(fs::exists(folder_ / "r/index.html")) << "nothing half-written";

    put(folder_ / "r/index.html", std::string(1 << 20, 'x'));
    const Outcome second = runCleave(asked);
    ASSERT_EQ(second.status, 0) << second.err;
    EXPECT_NE(second.out.find("going on"), std::string::npos) << second.out;
    const Json report = reportOf("r/report.json");
    expectErrors(report);
    EXPECT_EQ(report["interrupted"], true);
    const Json noted = Json::parse(ofFirstTree)["figure"];
    ASSERT_EQ(noted["builder"], "exact");
    const double first = noted["runs"][0], low = report["errors"]["tree"][0]["msLow"],
                 high = report["errors"]["tree"][0]["msHigh"];
    EXPECT_TRUE(low == first || high == first) << "of two runs the first is that of the interrupted run";

    const std::string page = contentOf(folder_ / "r/index.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    EXPECT_EQ(page.find("xxx"), std::string::npos) << "nothing of what was there remains";
    EXPECT_EQ(page.find("<script"), std::string::npos);
    for (const std::string& part : {std::string("scene.gltf"), "cleave report " + scene_, std::string("--quick"),
                                    std::string("taken before one"), std::string("Pictures of paths in scene.gltf"),
                                    std::string("Peers in scene.gltf"), std::string("stack-walk-c++")})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "r"), {}), 3) << "the pictures, and nothing else";
    const std::string plot = contentOf(folder_ / "r/pictures/scene-tree.svg");
    EXPECT_TRUE(plot.starts_with("<svg xmlns=")) << plot.substr(0, 80);
    EXPECT_NE(page.find(plot), std::string::npos) << "the page has the same drawing";
    for (const char* picture : {"steps-gpu", "paths-2-samples", "paths-reference"})
        EXPECT_TRUE(
            contentOf(folder_ / "r/pictures" / (std::string("scene-") + picture + ".png")).starts_with("\x89PNG"))
            << picture;
}

TEST_F(Program, ReportGoesOnAfterASceneThatFails) {
    put(folder_ / "bad.gltf", "{ no <scene>");
    const Outcome outcome =
        runCleave({"report", at("bad.gltf"), scene_, "-o", at("r"), "--quick", "--runs", "1", "--check", "64"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("1 of 2 scenes"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("bad.gltf"), std::string::npos) << outcome.err;
    const Json errors = reportOf("r/report.json")["errors"];
    EXPECT_GE(errors["tree"].size(), 10u);
    EXPECT_EQ(errors["tree"][0]["scene"], "scene.gltf");
    EXPECT_EQ(errors["tree"][0]["runs"], 1);
    const std::string page = contentOf(folder_ / "r/index.html");
    EXPECT_NE(page.find("No figures"), std::string::npos);
    EXPECT_NE(page.find("bad.gltf"), std::string::npos);
}

TEST_F(Program, ReportIsRefusedBeforeAnyWork) {
    expectFailure({"report", scene_, "-o", at("no/such")}, 1, "cannot make the folder");
    expectFailure({"report", scene_, "-o", scene_}, 1, "it is a file");
    expectFailure({"report", scene_, "-o", "/proc/report"}, 1, "cannot make the folder");
    expectFailure({"report", at("none.glb"), "-o", at("r")}, 1, "none.glb");
    expectFailure({"report", at("none.glb"), at("nor.glb"), "-o", at("r"), "--quiet"}, 1, "2 of 2 scenes");
    expectFailure({"report", scene_, scene_}, 2, "given twice");
    expectFailure({"report", scene_, "--quick", "--builder", "gpu"}, 2, "--peers");
}

TEST_F(Program, DevicesListsThem) {
    const Outcome outcome = runCleave({"devices", "--json", at("d.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(reportOf("d.json")["devices"].is_array());
    EXPECT_FALSE(outcome.out.empty());
}

TEST_F(Program, StabilityPrintsATableAndWritesEveryCell) {
    const TemporaryFolder folder;
    const Outcome run = runCleave({"stability", "--quick", "--cases", "four,flat-x", "--rays", "20", "--builder",
                                   "exact,spatial-median", "--json", folder / "s.json"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("all cells are within their bounds"), std::string::npos) << run.out;
    const auto json = nlohmann::json::parse(contentOf(folder / "s.json"))["stability"];
    EXPECT_EQ(json["cases"].size(), 2u);
    EXPECT_EQ(json["brokenCells"], 0u);
    // Two builders; three traversals, two trees and an uncounted one for two queries, and one on the host; by one
    // builder three traversals of instances for two queries. A tetrahedron has no split plane, so three families fewer.
    EXPECT_EQ(json["cells"].size(), (2u * 11u + 6u) * (14u + 17u));
    for (const auto& cell : json["cells"]) {
        EXPECT_EQ(cell["wrong"], 0u);
        EXPECT_EQ(cell["differing"], 0u);
        EXPECT_GT(cell["rays"], 0u);
    }
    EXPECT_EQ(json["queries"].size(), 2u * 2u * 5u);
    EXPECT_EQ(json["differingQueries"], 0u);
    uint64_t asked = 0;
    for (const auto& cell : json["queries"]) asked += cell["asked"].get<uint64_t>();
    EXPECT_GT(asked, 200u);
    EXPECT_NE(run.out.find("queries that differ"), std::string::npos) << run.out;
}

TEST_F(Program, StabilityShootsFromInsideOfClosedMeshes) {
    const TemporaryFolder folder;
    const Outcome run = runCleave({"stability", "--leaks", "30000", "--builder", "exact", "--json", folder / "l.json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const auto json = nlohmann::json::parse(contentOf(folder / "l.json"))["leaks"];
    EXPECT_EQ(json["leaks"], 0u);
    EXPECT_EQ(json["rays"], 30000u);
    EXPECT_EQ(json["meshes"].size(), 10u * 3u) << "by three traversals";
}

}  // namespace
}  // namespace cleave::test
