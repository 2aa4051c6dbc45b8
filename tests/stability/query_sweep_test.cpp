// Queries answer as brute force by exact predicates does, over all cases; and what is spoilt turns its cell red.
#include "stability/query_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "builders/builder_names.h"
#include "stability/cases.h"
#include "stability/closed_meshes.h"
#include "support/device.h"

namespace cleave {
namespace {

constexpr uint64_t kSeed = 7;
constexpr QuerySweepSettings kSettings{200, 20'000, kSeed, 2};

struct Made {
    std::vector<Triangle> world;
    TriangleSet set = makeTriangleSet(world);
    std::shared_ptr<DeviceTree> tree =
        uploadTree(test::device(), set, cpuBuilder("exact").build(set, BuildSettings{}).tree);
};

class QuerySweepTest : public testing::Test {
  protected:
    Tracer tracer{test::device()};
    Searcher searcher{test::device()};

    QueriesUnderTest queries(const Made& made) { return queriesOf("exact", *made.tree, tracer, searcher); }
    // The queries whose cells are red.
    std::string red(const Made& made, const QueriesUnderTest& tested) {
        const QuerySweep sweep("mesh", made.world, made.set, kSettings);
        std::string names;
        for (const QueryCell& cell : sweep.run(tested)) names += cell.differing > 0 ? cell.query + " " : "";
        return names;
    }
    Made closed() { return {closedMeshes(kSeed).front().triangles}; }
};

TEST_F(QuerySweepTest, AllCasesAreAsBruteForce) {
    std::map<std::string, uint64_t> asked;
    for (const StabilityCase& made : stabilityCases()) {
        SCOPED_TRACE(made.name);
        Random random(seedFor(kSeed, made.name));
        const Made scene{made.make(random, true)};
        const QuerySweep sweep(std::string(made.name), scene.world, scene.set, kSettings);
        const std::vector<QueryCell> cells = sweep.run(queries(scene));
        EXPECT_NO_THROW(requireAsBruteForce(cells));
        for (const QueryCell& cell : cells) asked[cell.query] += cell.asked;
    }
    for (const char* query : {"all", "count", "nearest", "overlaps"}) EXPECT_GT(asked[query], 1000u) << query;
}

TEST_F(QuerySweepTest, SpoiltAnswersTurnTheirCellRed) {
    const Made made = closed();
    const QueriesUnderTest good = queries(made);
    EXPECT_EQ(red(made, good), "");
    const auto spoilt = [&](const auto& spoil) {
        QueriesUnderTest bad = good;
        spoil(bad);
        return red(made, bad);
    };
    const auto firstHit = [](std::vector<Hit>& hits) -> Hit& {
        return *std::find_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.prim != kNone; });
    };
    // A t, a number, or one hit too few.
    const auto spoilAll = [&](const std::function<void(Hit&)>& spoil) {
        return spoilt([&](QueriesUnderTest& bad) {
            bad.all = [&, spoil](std::span<const Ray> rays, uint32_t most) {
                std::vector<Hit> hits = good.all(rays, most);
                spoil(firstHit(hits));
                return hits;
            };
        });
    };
    EXPECT_EQ(spoilAll([](Hit& hit) { hit.t *= 1.00001f; }), "all ");
    EXPECT_EQ(spoilAll([](Hit& hit) { hit.prim ^= 1u; }), "all ");
    EXPECT_EQ(spoilAll([](Hit& hit) { hit = missedHit(); }), "all ");
    for (const bool spoilsSigned : {false, true})
        EXPECT_EQ(spoilt([&](QueriesUnderTest& bad) {
                      bad.count = [&, spoilsSigned](std::span<const Ray> rays, bool isSigned) {
                          std::vector<int32_t> counts = good.count(rays, isSigned);
                          if (isSigned == spoilsSigned) counts[3] += 1;
                          return counts;
                      };
                  }),
                  "count ");
    EXPECT_EQ(spoilt([&](QueriesUnderTest& bad) {
                  bad.contains = [&](std::span<const vec3> points) {
                      std::vector<uint8_t> isInside = good.contains(points);
                      isInside[5] ^= 1;
                      return isInside;
                  };
              }),
              "contains ");
    const auto spoilNearest = [&](const std::function<void(Hit&)>& spoil) {
        return spoilt([&](QueriesUnderTest& bad) {
            bad.nearest = [&, spoil](std::span<const vec3> points) {
                std::vector<Hit> hits = good.nearest(points);
                for (Hit& hit : hits) spoil(hit);
                return hits;
            };
        });
    };
    EXPECT_EQ(spoilNearest([](Hit& hit) { hit.t *= 1.001f; }), "nearest ");
    EXPECT_EQ(spoilNearest([](Hit& hit) { hit.prim = 0; }), "nearest ");
    EXPECT_EQ(spoilNearest([](Hit& hit) { hit = missedHit(); }), "nearest ");
    EXPECT_EQ(spoilt([&](QueriesUnderTest& bad) {
                  bad.overlaps = [&](std::span<const Box> boxes) {
                      std::vector<uvec2> pairs = good.overlaps(boxes);
                      pairs.pop_back();
                      return pairs;
                  };
              }),
              "overlaps ");
}

TEST_F(QuerySweepTest, TheRunFailsAndNamesTheCell) {
    const QueryCell good{"a", "gpu", "all", 10, 0, ""}, bad{"b", "gpu", "count", 10, 2, "ray 3"};
    const std::vector<QueryCell> cells{good, bad};
    EXPECT_NO_THROW(requireAsBruteForce({cells.data(), 1}));
    try {
        requireAsBruteForce(cells);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("b, gpu, count: 2 of 10, first ray 3"), std::string::npos);
    }
}

}  // namespace
}  // namespace cleave
