#include "builders/builder_names.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "judge/oracle.h"
#include "judge/validate.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

constexpr Triangle kSheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

std::vector<Triangle> stack(uint32_t count, vec3 step) {
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 offset = step * static_cast<float>(i);
        triangles.push_back({kSheet.a + offset, kSheet.b + offset, kSheet.c + offset});
    }
    return triangles;
}

// Identical, coplanar and nearly flat triangles, sheets, needles, a huge one among tiny ones, a fan, two scales.
std::vector<std::vector<Triangle>> extremeScenes() {
    std::vector<std::vector<Triangle>> scenes{{}, {kSheet}, stack(500, vec3(0)), stack(500, vec3(0, 0, 1))};
    scenes.push_back(stack(500, vec3(0.01f, 0.02f, 0)));
    scenes.push_back(stack(100, vec3(0, 0, 1e-30f)));
    scenes.push_back(test::transformed(test::soup(1, 300, 0.02f), 1e-5f, vec3(0.7f)));
    scenes.back().push_back({{-1, -1, 0.7f}, {3, 0, 0.7f}, {0, 3, 0.7f}});
    scenes.push_back({});
    for (uint32_t i = 0; i < 400; ++i) {
        const float angle = static_cast<float>(i) * 0.0157f;
        scenes.back().push_back({vec3(0),
                                 {std::cos(angle), std::sin(angle), 0.1f},
                                 {std::cos(angle + 0.0157f), std::sin(angle + 0.0157f), -0.1f}});
    }
    scenes.push_back(test::soup(2, 100, 1.0f));
    for (Triangle& t : scenes.back()) t.c = t.a + (t.b - t.a) * 0.5f + vec3(0, 1e-7f, 0);
    return scenes;
}

void expectRightAnswers(const TreeBuilder& builder, const TriangleSet& set, const std::vector<Ray>& rays) {
    const BuildSettings settings;
    const KdTree tree = builder.build(set, settings).tree;
    const ValidationReport report = validate(tree, set, depthLimit(settings, set.included.size()));
    EXPECT_TRUE(report.ok()) << report.errors.front();
    for (const Ray& ray : rays) {
        const Hit expected = bruteForce(set, ray, Query::closest), hit = stackWalk(tree, set, ray, Query::closest);
        EXPECT_TRUE(hit.t == expected.t && hit.prim == expected.prim && hit.u == expected.u && hit.v == expected.v);
    }
}

class EveryBuilder : public testing::TestWithParam<TreeBuilder> {};

TEST_P(EveryBuilder, AnswersOnRandomSnappedScenes) {
    for (uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const uint32_t side = 2 + seed % 7;
        const float scale = 1.0f / 16.0f;  // exact; the tree's own space is within [-1, 1]
        const auto triangles = test::transformed(test::integerSoup(seed, 8 + seed * 7, side), scale, vec3(0));
        const TriangleSet set = makeTriangleSet(triangles);
        std::vector<Ray> rays = test::integerRays(seed, 200, side);
        for (Ray& ray : rays) ray.origin = ray.origin * std::ldexp(scale, -set.exponent);
        expectRightAnswers(GetParam(), set, rays);
    }
}

TEST_P(EveryBuilder, AnswersOnSoup) {
    const TriangleSet set = makeTriangleSet(test::soup(7, 3000, 0.03f));
    ASSERT_LE(set.exponent, 1);
    expectRightAnswers(GetParam(), set, test::raysAt(7, 300, 0.0f, std::ldexp(1.0f, -set.exponent)));
}

TEST_P(EveryBuilder, GivesValidTreesOfExtremeScenes) {
    for (const auto& triangles : extremeScenes()) {
        SCOPED_TRACE(triangles.size());
        const TriangleSet set = makeTriangleSet(triangles);
        expectRightAnswers(GetParam(), set, test::raysAt(3, 100, -0.5f, 1.0f));
    }
}

TEST_P(EveryBuilder, GivesTheSameTreeTwice) {
    const TriangleSet set = makeTriangleSet(test::soup(11, 2000, 0.05f));
    EXPECT_EQ(treeHash(GetParam().build(set, {}).tree), treeHash(GetParam().build(set, {}).tree));
}

TEST_P(EveryBuilder, IsFoundByItsName) {
    EXPECT_EQ(cpuBuilder(GetParam().name).build, GetParam().build);
    EXPECT_FALSE(GetParam().description.empty());
}

INSTANTIATE_TEST_SUITE_P(Cpu, EveryBuilder, testing::ValuesIn(cpuBuilders().begin(), cpuBuilders().end()),
                         [](const auto& test) {
                             std::string name(test.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(CpuBuilders, NamesAreDistinctAndOthersRefused) {
    std::set<std::string_view> names;
    for (const TreeBuilder& builder : cpuBuilders()) names.insert(builder.name);
    EXPECT_EQ(names.size(), cpuBuilders().size());
    EXPECT_EQ(cpuBuilders().front().name, "exact");
    try {
        cpuBuilder("oracle");
        FAIL() << "there is no such builder";
    } catch (const Error& error) {
        for (const char* part : {"'oracle'", "exact, ", "brute"})
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

}  // namespace

void PrintTo(const TreeBuilder& builder, std::ostream* out) { *out << builder.name; }

}  // namespace cleave
