#include "judge/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "builders/builders.h"
#include "judge/reference_bvh.h"
#include "judge/reference_triangle.h"
#include "judge/validate.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

// The whole of this folder over one scene: sound trees, equal answers, and a reference that agrees.
void expectAllAgree(const std::vector<Triangle>& world, const std::vector<Ray>& rays) {
    const TriangleSet set = makeTriangleSet(world);
    const KdTree trees[] = {buildExact(set, {}), buildBrute(set)};
    for (const KdTree& tree : trees) {
        const ValidationReport report = validate(tree, set, depthLimit(BuildSettings{}, set.included.size()));
        EXPECT_TRUE(report.ok()) << (report.ok() ? "" : report.errors[0]);
    }
    const Reference reference(world, set.included);
    for (const Query query : {Query::closest, Query::any}) {
        std::vector<Hit> hits;
        for (const Ray& ray : rays) {
            hits.push_back(bruteForce(set, ray, query));
            const Hit walked = stackWalk(trees[0], set, ray, query);
            if (query == Query::any) {
                ASSERT_EQ(walked.prim == kNone, hits.back().prim == kNone) << hits.size() - 1;
                continue;
            }
            ASSERT_EQ(walked.prim, hits.back().prim) << hits.size() - 1;
            ASSERT_EQ(walked.t, hits.back().t);
            ASSERT_EQ(walked.u, hits.back().u);
            ASSERT_EQ(walked.v, hits.back().v);
        }
        const CheckResult result = check(reference, rays, hits, query, rays.size());
        EXPECT_EQ(result.rays, rays.size());
        EXPECT_EQ(result.mismatches, 0u) << result.first;
        EXPECT_LT(result.maxRelativeTError, 1e-6);
    }
}

TEST(Oracles, AgreeOnRandomScenes) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        expectAllAgree(test::soup(seed, seed * 3, seed % 2 == 0 ? 0.1f : 0.4f), test::raysAt(seed, 120, 0.0f, 1.0f));
    }
}
// Coordinates 0 to 8: planes through many vertices, sheets in split planes, rays through edges and vertices.
TEST(Oracles, AgreeOnIntegerCoordinates) {
    for (uint32_t seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE(seed);
        const uint32_t side = 1u << seed % 4;
        expectAllAgree(test::integerSoup(seed, 4 + seed, side), test::integerRays(seed, 150, side));
    }
}
TEST(Oracles, AgreeAtEveryScale) {
    for (const float scale : {1e-30f, 1e-7f, 1e7f, 1e18f}) {
        SCOPED_TRACE(scale);
        std::vector<Ray> rays = test::raysAt(3, 200, 0.0f, 1.0f);
        for (Ray& ray : rays) ray.origin *= scale;
        expectAllAgree(test::transformed(test::soup(3, 80, 0.3f), scale, vec3(0.0f)), rays);
    }
}
TEST(Oracles, AgreeFarFromTheOrigin) {
    std::vector<Ray> rays = test::raysAt(4, 200, 0.0f, 1000.0f);
    for (Ray& ray : rays) ray.origin += vec3(1e6f);
    expectAllAgree(test::transformed(test::soup(4, 80, 0.3f), 1000.0f, vec3(1e6f)), rays);
}
TEST(Oracles, AgreeForExtremeDirectionLengths) {
    for (const float length : {1e-30f, 1e30f}) {
        std::vector<Ray> rays = test::raysAt(5, 200, 0.0f, 1.0f);
        for (Ray& ray : rays) ray.direction *= length;
        expectAllAgree(test::soup(5, 80, 0.3f), rays);
    }
}
TEST(Oracles, AgreeOnDegenerateScenes) {
    const Triangle good{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}}, point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    const Triangle bad{{std::nanf(""), 0, 0}, {1, 0, 0}, {0, 1, 0}};
    std::vector<Triangle> flat = test::integerSoup(1, 40, 4), line;
    for (Triangle& t : flat) t.a.y = t.b.y = t.c.y = 2.0f;
    for (int i = 0; i < 20; ++i) {
        const auto x = static_cast<float>(i);
        line.push_back({{x, x, x}, {x + 1, x + 1, x + 1}, {x + 3, x + 3, x + 3}});
    }
    const std::vector<std::vector<Triangle>> scenes{{},
                                                    {good},
                                                    std::vector<Triangle>(100, good),
                                                    {good, point, bad, test::soup(1, 1, 0.5f)[0]},
                                                    {point, bad},
                                                    {bad, good},
                                                    flat,
                                                    line};
    for (size_t i = 0; i < scenes.size(); ++i) {
        SCOPED_TRACE(i);
        expectAllAgree(scenes[i], test::integerRays(1, 200, 4));
        expectAllAgree(scenes[i], test::raysAt(1, 100, 0.0f, 1.0f));
    }
}

TEST(Oracles, AnswerInvalidRaysWithMisses) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}});
    const Ray good{{0, 0, 0}, 0.0f, {0, 0, 1}, infinity()};
    EXPECT_EQ(bruteForce(set, good, Query::closest).t, 1.0f);
    std::vector<Ray> rays(4, good);
    rays[0].direction = vec3(0.0f);
    rays[1].origin.x = std::nanf("");
    rays[2].tMin = -1.0f;
    rays[3].tMax = -0.5f;
    for (const Ray& ray : rays) {
        EXPECT_EQ(bruteForce(set, ray, Query::any).prim, kNone);
        EXPECT_EQ(stackWalk(buildBrute(set), set, ray, Query::closest).prim, kNone);
    }
}

TEST(Oracles, HonourTheIntervalAndTheLowerNumber) {
    const Triangle t{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{t, t});
    const KdTree tree = buildBrute(set);
    for (const auto& [tMin, tMax, hits] :
         {std::tuple{0.0f, 1.0f, true}, {1.0f, 2.0f, true}, {0.0f, 0.999f, false}, {1.001f, infinity(), false}}) {
        const Ray ray{{0, 0, 0}, tMin, {0, 0, 1}, tMax};
        EXPECT_EQ(bruteForce(set, ray, Query::closest).prim, hits ? 0u : kNone);
        EXPECT_EQ(stackWalk(tree, set, ray, Query::closest).prim, hits ? 0u : kNone);
    }
}

class Judge : public testing::Test {
  protected:
    const std::vector<Triangle> world{{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}, {{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}};
    const Reference reference{world, std::vector<uint32_t>{0, 1}};
    const Ray ray{{0, 0, 0}, 0.0f, {0, 0, 1}, 10.0f};
    Reference::Verdict of(const Ray& r, const Hit& hit, Query query = Query::closest) const {
        return reference.judge(r, hit, query).verdict;
    }
    static constexpr auto kAgrees = Reference::Verdict::agrees;
    static constexpr auto kMismatch = Reference::Verdict::mismatch;
    static constexpr auto kUndecided = Reference::Verdict::undecided;
};

TEST_F(Judge, CatchesWrongHits) {
    EXPECT_EQ(of(ray, {1.0f, 0, 0.25f, 0.5f}), kAgrees);
    EXPECT_EQ(of(ray, {1.0000005f, 0, 0, 0}), kAgrees);
    EXPECT_EQ(of(ray, {1.000002f, 0, 0, 0}), kMismatch);
    EXPECT_EQ(of(ray, {std::nanf(""), 0, 0, 0}), kMismatch);
    EXPECT_EQ(of(ray, {2.0f, 1, 0, 0}), kMismatch) << "not the closest";
    EXPECT_EQ(of(ray, {1.0f, 1, 0, 0}), kMismatch) << "that triangle is elsewhere";
    EXPECT_EQ(of(ray, {1.0f, 7, 0, 0}), kMismatch) << "no such triangle";
    EXPECT_EQ(of(ray, missedHit()), kMismatch);
    EXPECT_EQ(of(ray, missedHit(), Query::any), kMismatch);
    EXPECT_EQ(of(ray, {2.0f, 1, 0, 0}, Query::any), kAgrees);
    Ray away = ray;
    away.direction.z = -1.0f;
    EXPECT_EQ(of(away, missedHit()), kAgrees);
    EXPECT_EQ(of(away, {1.0f, 0, 0, 0}), kMismatch);
    EXPECT_EQ(of(away, {1.0f, 0, 0, 0}, Query::any), kMismatch);
}
TEST_F(Judge, LeavesTheEndsOfTheIntervalUndecided) {
    Ray ending = ray;
    ending.tMax = 1.0f;
    EXPECT_EQ(of(ending, missedHit()), kUndecided);
    EXPECT_EQ(of(ending, {1.0f, 0, 0, 0}), kAgrees);
    ending.tMax = 0.999f;
    EXPECT_EQ(of(ending, missedHit()), kAgrees);
    Ray touching = ray;
    touching.origin.z = 1.0f;
    EXPECT_EQ(of(touching, {0.0f, 0, 0, 0}), kAgrees) << "t = 0 is exact here";
    EXPECT_EQ(of(touching, {1.0f, 1, 0, 0}), kMismatch);
}
TEST_F(Judge, CheckCountsAndDescribes) {
    std::vector<Ray> rays(100, ray);
    std::vector<Hit> hits(100, Hit{1.0f, 0, 0, 0});
    hits[40].t = 1.5f;
    hits[70] = missedHit();
    const CheckResult all = check(reference, rays, hits, Query::closest, 1000);
    EXPECT_EQ(all.rays, 100u);
    EXPECT_EQ(all.mismatches, 2u);
    EXPECT_EQ(all.missed, 1u);
    EXPECT_EQ(all.falseHits, 0u);
    EXPECT_NE(all.first.find("ray 40"), std::string::npos) << all.first;
    const CheckResult some = check(reference, rays, hits, Query::closest, 10, 1);  // rays 0, 10, ... 90
    EXPECT_EQ(some.rays, 10u);
    EXPECT_EQ(some.mismatches, 2u);
    EXPECT_EQ(check(reference, {}, {}, Query::any, 10).rays, 0u);
    rays[20].direction = -ray.direction;
    EXPECT_EQ(check(reference, rays, hits, Query::closest, 1000).falseHits, 1u);
    hits.pop_back();
    EXPECT_THROW(check(reference, rays, hits, Query::closest, 10), Error);
}

// A ray through a vertex or an edge hits, one that passes it by next to nothing misses: double cannot tell them apart.
TEST(ReferenceTriangle, DecidesEdgesExactly) {
    const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const float far = 1048576.0f;
    const auto hits = [&](vec3 target, vec3 direction) {
        return intersectLine({target - direction, 0.0f, direction, infinity()}, t).hits;
    };
    EXPECT_TRUE(hits({0, 0, 0}, {1, 2, far}));
    EXPECT_TRUE(hits({0.5f, 0.5f, 0}, {-3, 7, far}));
    EXPECT_FALSE(hits({0.5f, 0, 0}, {1, 0, 0})) << "in the plane";
    const Triangle u{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}};  // its edge is x = y; the rays pass it by 2^-103
    const auto hitsAt = [&](float y) { return intersectLine({{0x1p-80f, y, 1}, 0.0f, {0, 0, -1}, 2.0f}, u).hits; };
    EXPECT_TRUE(hitsAt(0x1.fffffep-81f));
    EXPECT_TRUE(hitsAt(0x1p-80f));
    EXPECT_FALSE(hitsAt(0x1.000002p-80f));
    const auto missesBy = [&](float y) { return !intersectLine({{0.25f, y, 1}, 0.0f, {0, 0, -1}, 2.0f}, t).hits; };
    EXPECT_TRUE(missesBy(-0x1p-149f));
    EXPECT_FALSE(missesBy(0.0f));
    EXPECT_FALSE(missesBy(0x1p-149f));
}

TEST(ReferenceBvh, FindsWhatBruteForceFinds) {
    for (uint32_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        const bool integer = seed % 2 == 0;
        const std::vector<Triangle> world = integer ? test::integerSoup(seed, 200, 6) : test::soup(seed, 200, 0.1f);
        const std::vector<uint32_t> included = makeTriangleSet(world).included;
        const ReferenceBvh bvh(world, included);
        const auto rays = integer ? test::integerRays(seed, 100, 6) : test::raysAt(seed, 100, 0.0f, 1.0f);
        for (const Ray& ray : rays) {
            std::vector<uint32_t> expected, found;
            for (const uint32_t i : included)
                if (intersectLine(ray, world[i]).hits) expected.push_back(i);
            bvh.traverse(
                ray, [] { return double{infinity()}; },
                [&](uint32_t i) {
                    if (intersectLine(ray, world[i]).hits) found.push_back(i);
                });
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
        }
    }
}

}  // namespace
}  // namespace cleave
