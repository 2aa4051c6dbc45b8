#include "app/needs.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "shared/ray.h"
#include "support/program.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kScenes = fs::path(CLEAVE_SOURCE) / "scenes";
constexpr uint32_t kSeed = 21;

TEST(Needs, ListWhatIsLeftOutAndNotKept) {
    Needs needs(only(Need::normals));
    EXPECT_EQ(needs.line(), "");
    needs.leaveOut(Need::zAxis, "the scene is flat");
    needs.leaveOut(Need::normals, "there are none");
    needs.leaveOut(Need::textures, "there are none");
    needs.leaveOut(Need::unusedImages, uint64_t{3});
    EXPECT_EQ(needs.line(), "left out: textures, z axis, unused images\n");
    EXPECT_TRUE(needs.isLeftOut(Need::zAxis));
    EXPECT_FALSE(needs.isLeftOut(Need::normals)) << "it is kept";
    EXPECT_FALSE(needs.isLeftOut(Need::xAxis));
    EXPECT_EQ(needs.leftOut().at(Need::unusedImages), Reason(uint64_t{3}));
}

TEST(Needs, AFlatAxisIsFoundByItsBounds) {
    const auto flatAlong = [](int axis) {
        PosedScene posed;
        Triangle t{{0, 1, 2}, {3, 5, 4}, {9, 7, 8}};
        for (vec3* corner : {&t.a, &t.b, &t.c})
            if (axis >= 0) (*corner)[axis] = 0.5f;
        posed.triangles = {t};
        Needs needs;
        findInScene(needs, {}, finiteBounds(posed.triangles), true);
        return needs.line();
    };
    EXPECT_EQ(flatAlong(-1), "");
    EXPECT_EQ(flatAlong(0), "left out: x axis\n");
    EXPECT_EQ(flatAlong(1), "left out: y axis\n");
    EXPECT_EQ(flatAlong(2), "left out: z axis\n");
    Needs needs;
    findInScene(needs, {}, emptyBox(), true);
    EXPECT_EQ(needs.line(), "") << "without a triangle no axis is flat";
}

TEST(Needs, FewTrianglesNeedNoTree) {
    const auto foundFor = [](size_t triangles, bool mayDoWithout) {
        TriangleSet set;
        set.triangles.resize(triangles);
        Needs needs;
        findInBuild(needs, set, 160, mayDoWithout);
        return needs.line();
    };
    EXPECT_EQ(foundFor(kFewTriangles, true), "left out: tree\n");
    EXPECT_EQ(foundFor(kFewTriangles, false), "left out: large nodes\n");
    EXPECT_EQ(foundFor(kFewTriangles + 1, true), "left out: large nodes\n");
    EXPECT_EQ(foundFor(160, true), "left out: large nodes\n");
    EXPECT_EQ(foundFor(161, true), "");
}

class NeedsOfPrograms : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::string at(const std::string& name) const { return (folder_ / name).string(); }

    // What a picture of the scene does without; rendered once for all who ask.
    Json leftOut(const std::string& scene, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"render", scene,       "--size", "16x9",
                                           "-o",     at("l.png"), "--json", at("l.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Json& known = leftOut_[arguments];
        if (known.is_null()) known = rendered(arguments);
        return known;
    }
    Json rendered(const std::vector<std::string>& arguments) {
        const Outcome outcome = runCleave(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        Json report = Json::parse(contentOf(folder_ / "l.json"));
        const bool tells = outcome.out.starts_with("left out: ");
        EXPECT_EQ(tells, report["scene"]["leftOut"].size() > 4) << outcome.out;  // the four counts are always there
        return report["scene"]["leftOut"];
    }
    std::string ours(const std::string& name) const { return (kScenes / name).string(); }

    // The bytes of a file that a run writes, without and with --keep-all.
    void expectTheSame(std::vector<std::string> arguments, const std::string& file) {
        ASSERT_EQ(runCleave(arguments).status, 0) << arguments[1];
        const std::string without = contentOf(folder_ / file);
        arguments.push_back("--keep-all");
        ASSERT_EQ(runCleave(arguments).status, 0) << arguments[1];
        EXPECT_EQ(contentOf(folder_ / file), without) << arguments[1];
        EXPECT_FALSE(without.empty());
    }

  private:
    std::map<std::vector<std::string>, Json> leftOut_;
};

// A scene, and how it is shown, that has no use for a part; and one that has.
TEST_F(NeedsOfPrograms, EachPartIsLeftOutWhereItIsNotNeeded) {
    std::string twoSided = triangleScene();
    const std::string primitive = R"("primitives":[{)";
    twoSided.replace(twoSided.find(primitive), primitive.size(), primitive + R"("material":0,)");
    twoSided.replace(twoSided.find(R"("scene":0)"), 9, R"("scene":0,"materials":[{"doubleSided":true}])");
    put(folder_ / "two.gltf", twoSided);
    struct Shown {
        std::string scene;
        std::vector<std::string> more;
    };
    struct Case {
        const char* part;
        Shown without, with;
    };
    const std::string cornell = ours("cornell.glb"), triangle = ours("triangle.gltf");
    const std::string moving = ours("features/animation.glb"), textured = ours("features/textures.glb");
    const Case cases[] = {
        {"textures", {cornell, {}}, {textured, {}}},
        {"vertexColours", {cornell, {}}, {ours("features/vertex_colours.glb"), {}}},
        {"normals", {cornell, {}}, {ours("features/smooth_normals.glb"), {}}},
        {"alphaTest", {cornell, {}}, {ours("features/alpha.glb"), {}}},
        {"emitters", {triangle, {"--view", "path"}}, {ours("features/emissive.glb"), {"--view", "path"}}},
        {"backFaces", {at("two.gltf"), {}}, {triangle, {}}},
        {"animation", {moving, {}}, {moving, {"--time", "0.5"}}},
        {"zAxis", {triangle, {}}, {cornell, {}}},
        {"tree", {triangle, {}}, {cornell, {}}},
        {"tree", {triangle, {}}, {triangle, {"--builder", "gpu"}}},
        {"tree", {triangle, {}}, {triangle, {"--view", "leaves"}}},
        {"largeNodes", {cornell, {}}, {ours("grid.glb"), {}}},
        {"trails", {triangle, {"--traversal", "stack"}}, {triangle, {"--traversal", "restart"}}},
        {"shadows", {triangle, {"--view", "normals"}}, {triangle, {}}},
        {"stepCounters", {triangle, {}}, {triangle, {"--view", "steps"}}},
        {"unusedImages", {textured, {"--view", "normals"}}, {textured, {}}},
    };
    for (const Case& c : cases) {
        EXPECT_TRUE(leftOut(c.without.scene, c.without.more).contains(c.part)) << c.part;
        EXPECT_FALSE(leftOut(c.with.scene, c.with.more).contains(c.part)) << c.part;
        std::vector<std::string> kept = c.without.more;
        kept.push_back("--keep-all");
        EXPECT_FALSE(leftOut(c.without.scene, kept).contains(c.part)) << c.part;
    }
    EXPECT_EQ(leftOut(textured, {"--view", "normals"})["unusedImages"].type(), Json::value_t::number_unsigned);
    EXPECT_EQ(leftOut(triangle)["zAxis"], "the scene is flat");
}

// Of every other scene that shows a feature, paths and the shaded view in turns; with CLEAVE_LONG of all scenes, both.
TEST_F(NeedsOfPrograms, PicturesAreTheSameWithEverythingKept) {
    const bool isLong = std::getenv("CLEAVE_LONG") != nullptr;
    const std::vector<fs::path> folders =
        isLong ? std::vector{kScenes, kScenes / "features"} : std::vector{kScenes / "features"};
    std::vector<fs::path> scenes;
    for (const fs::path& folder : folders)
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf") scenes.push_back(entry);
    ASSERT_GT(scenes.size(), 10u);
    std::ranges::sort(scenes);
    for (size_t i = 0; i < scenes.size(); ++i)
        for (const char* view : {"shaded", "path"}) {
            if (!isLong && (i % 2 != 0 || (i % 4 == 0) != (std::string(view) == "path"))) continue;
            SCOPED_TRACE(view);
            expectTheSame(
                {"render", scenes[i].string(), "--view", view, "--size", "48x27", "--spp", "2", "-o", at("p.exr")},
                "p.exr");
        }
    const char* const few[] = {"features/normal_map.glb", "triangle.gltf"};
    for (size_t i = 0; i < std::size(few); ++i)
        for (const char* view : {"normals", "depth", "steps", "leaves"}) {
            if (!isLong && i > 0 && std::string(view) != "steps") continue;
            SCOPED_TRACE(view);
            expectTheSame({"render", ours(few[i]), "--view", view, "--size", "48x27", "-o", at("p.png")}, "p.png");
        }
    expectTheSame({"render", ours("features/skin.glb"), "--time", "0.7", "--size", "48x27", "-o", at("p.png")},
                  "p.png");
    expectTheSame(
        {"render", ours("features/alpha.glb"), "--traversal", "restart", "--size", "48x27", "-o", at("p.png")},
        "p.png");
}

TEST_F(NeedsOfPrograms, HitsAreTheSameWithEverythingKept) {
    constexpr int kRays = 500;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::string rays;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray{vec3(unit(random), unit(random), unit(random)) * 3.0f, 0.0f,
                      vec3(unit(random), unit(random), unit(random)), infinity()};
        rays.append(reinterpret_cast<const char*>(&ray), sizeof ray);
    }
    const std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (500, 8), }\n";
    put(folder_ / "rays.npy",
        std::string("\x93NUMPY\1\0", 8) + static_cast<char>(header.size()) + std::string(1, '\0') + header + rays);
    for (const char* scene : {"triangle.gltf", "cornell.glb", "stack.glb", "features/alpha.glb"})
        for (const char* how : {"--traversal=stack", "--traversal=restart", "--count", "--all=3"}) {
            SCOPED_TRACE(how);
            expectTheSame({"trace", ours(scene), at("rays.npy"), how, "-o", at("hits.npy")}, "hits.npy");
        }
}

TEST_F(NeedsOfPrograms, BenchShowsWhatEachPartSaves) {
    const Outcome outcome =
        runCleave({"bench", ours("triangle.gltf"), "--needs", "--runs", "1", "--check", "64", "--json", at("n.json")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json rows = Json::parse(contentOf(folder_ / "n.json"))["needs"];
    for (const char* view : {"shaded", "path"})
        for (const char* kept : {"nothing", "textures", "z axis", "tree", "restart trails", "everything"}) {
            const auto row = std::find_if(rows.begin(), rows.end(),
                                          [&](const Json& r) { return r["view"] == view && r["kept"] == kept; });
            ASSERT_NE(row, rows.end()) << view << ", " << kept;
            EXPECT_GT((*row)["ms"], 0.0);
            EXPECT_GT((*row)["deviceBytes"], 0);
            EXPECT_NE(outcome.out.find(kept), std::string::npos);
        }
    for (const Json& row : rows) EXPECT_GE(row["deviceBytes"], rows[0]["deviceBytes"]) << row["kept"];
}

}  // namespace
}  // namespace cleave::test
