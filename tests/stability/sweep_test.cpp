// A small table has all cells within bounds, and a broken answer breaks its cell.
#include "stability/sweep.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "builders/builder_names.h"
#include "run/gpu_builder.h"
#include "stability/cases.h"
#include "stability/closed_meshes.h"
#include "support/device.h"
#include "support/runners.h"

namespace cleave {
namespace {

constexpr uint64_t kSeed = 7;
constexpr SweepSettings kSettings{100, 1'000'000, kSeed, 2};

TraversalUnderTest onDevice(const char* name, Traversal traversal, Query query = Query::closest) {
    const auto trace = [traversal, query](const TreeUnderTest& tree, std::span<const Ray> rays) {
        return test::sharedTracer().trace(*tree.onDevice, rays,
                                          {.query = query, .traversal = traversal, .countSteps = true});
    };
    return {traversalName(name, query), trace, UINT64_MAX, query};
}

std::shared_ptr<TreeUnderTest> hostTree(const char* builder, const TriangleSet& set) {
    auto tree = std::make_shared<TreeUnderTest>();
    tree->builder = builder;
    tree->tree = cpuBuilder(builder).build(set, {}).tree;
    return tree;
}

std::vector<Cell> sweep(const StabilityCase& made) {
    Random random(seedFor(kSeed, made.name));
    const std::vector<Triangle> world = made.make(random, true);
    const TriangleSet set = makeTriangleSet(world);
    SceneSweep scene(std::string(made.name), world, set, kSettings);
    const std::vector<TraversalUnderTest> traversals{
        onDevice("restart", Traversal::restart),         onDevice("stack", Traversal::stack),
        onDevice("short-stack", Traversal::shortStack),  onDevice("restart", Traversal::restart, Query::any),
        onDevice("stack", Traversal::stack, Query::any), hostStack(set, 1'000'000)};
    std::vector<Cell> cells;
    for (const char* builder : {"exact", "spatial-median"}) {
        const std::shared_ptr<TreeUnderTest> tree = hostTree(builder, set);
        tree->onDevice = uploadTree(test::device(), set, tree->tree);
        const std::vector<Cell> more = scene.run(tree, traversals);
        cells.insert(cells.end(), more.begin(), more.end());
    }
    return cells;
}

TEST(Sweep, AllCasesAreWithinBounds) {
    uint64_t rays = 0, hits = 0;
    for (const StabilityCase& made : stabilityCases()) {
        SCOPED_TRACE(made.name);
        const std::vector<Cell> cells = sweep(made);
        EXPECT_NO_THROW(requireWithinBounds(cells));
        for (const Cell& cell : cells) {
            rays += cell.rays;
            hits += cell.hits;
            EXPECT_LE(cell.maxUlpError, 0.51) << cell.family;
            EXPECT_TRUE(cell.traversal != "restart" || cell.hits == 0 || cell.mostSteps > 0);
        }
    }
    EXPECT_GT(rays, 300000u);
    EXPECT_GT(hits, 200000u);
}

// A walk on the host whose answers are spoilt on the way: the judge must not miss it.
class Spoilt : public testing::Test {
  protected:
    Spoilt() {
        Random random(kSeed);
        world = stabilityCases()[4].make(random, true);
        set = makeTriangleSet(world);
    }
    // The cells of one family where every hit went through `spoil`.
    std::vector<Cell> cells(const std::function<void(Hit&)>& spoil, Query query = Query::closest) {
        TraversalUnderTest walk = hostStack(set, UINT64_MAX);
        walk.query = query;
        walk.trace = [good = walk.trace, spoil](const TreeUnderTest& tree, std::span<const Ray> rays) {
            Tracer::Result result = good(tree, rays);
            for (Hit& hit : result.hits)
                if (hit.prim != kNone) {
                    spoil(hit);
                    break;
                }
            return result;
        };
        SceneSweep scene("four", world, set, kSettings);
        return scene.run(hostTree("exact", set), {&walk, 1});
    }
    const Cell& random(const std::vector<Cell>& all) { return all.front(); }
    std::vector<Triangle> world;
    TriangleSet set;
};

TEST_F(Spoilt, GoodAnswersPass) {
    const std::vector<Cell> all = cells([](Hit&) {});
    EXPECT_EQ(all.size(), 14u) << "there is no split plane to shoot at";
    for (const Cell& cell : all) EXPECT_EQ(whyBroken(cell), "") << cell.family;
}
TEST_F(Spoilt, MissesCount) {
    const std::vector<Cell> all = cells([](Hit& hit) { hit = missedHit(); });
    EXPECT_EQ(random(all).missed, 1u);
    EXPECT_EQ(random(all).differing, 1u);
    EXPECT_EQ(whyBroken(random(all)), "1 missed, 1 not as by brute force");
    EXPECT_NE(random(all).first.find("answered with a miss, by the reference triangle"), std::string::npos);
}
TEST_F(Spoilt, WrongTrianglesAndDistancesCount) {
    EXPECT_EQ(random(cells([](Hit& hit) { hit.t *= 1.00001f; })).wrong, 1u);
    EXPECT_EQ(random(cells([](Hit& hit) { hit.prim = (hit.prim + 1) % 4; })).wrong, 1u);
}
TEST_F(Spoilt, TheLastBitCounts) {
    const std::vector<Cell> all = cells([](Hit& hit) { hit.u = nextFloat(hit.u, true); });
    EXPECT_EQ(random(all).wrong, 0u);
    EXPECT_EQ(whyBroken(random(all)), "1 not as by brute force");
    const Cell moved = random(cells([](Hit& hit) { hit.t = nextFloat(hit.t, true); }));
    EXPECT_GE(moved.maxUlpError, 0.5);
    EXPECT_EQ(moved.differing, 1u);
}
TEST_F(Spoilt, AnyHitsMayBeLaterAndNoMore) {
    EXPECT_EQ(whyBroken(random(cells([](Hit& hit) { hit = {hit.t * 2.0f, 3 - hit.prim, 0, 0}; }, Query::any))), "");
    EXPECT_EQ(whyBroken(random(cells([](Hit& hit) { hit.t *= 0.5f; }, Query::any))), "1 not as by brute force");
    const std::vector<Cell> missing = cells([](Hit& hit) { hit = missedHit(); }, Query::any);
    EXPECT_EQ(whyBroken(random(missing)), "1 missed, 1 not as by brute force");
}
TEST_F(Spoilt, TheRunFailsAndNamesTheCell) {
    const std::vector<Cell> all = cells([](Hit& hit) { hit = missedHit(); });
    try {
        requireWithinBounds(all);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("four, exact, host-stack, random: 1 missed"), std::string::npos) << text;
    }
}

TEST(Bounds, OfUndecidedAndCappedRays) {
    Cell cell;
    cell.rays = 1000;
    EXPECT_EQ(whyBroken(cell), "");
    cell.undecided = 2;
    EXPECT_EQ(whyBroken(cell), "2 undecided");
    cell.isEdgeFamily = true;
    EXPECT_EQ(whyBroken(cell), "");
    cell.capped = 1;
    EXPECT_EQ(whyBroken(cell), "1 stopped by the step cap");
}

TEST(Leaks, AMillionRaysStayInside) {
    const std::vector<ClosedMesh> meshes = closedMeshes(kSeed);
    Leaks leaks;
    for (const ClosedMesh& mesh : meshes) {
        SCOPED_TRACE(mesh.name);
        const TriangleSet set = makeTriangleSet(mesh.triangles);
        const auto tree = uploadTree(test::device(), set, cpuBuilder("exact").build(set, {}).tree);
        const std::vector<Ray> rays = leakRays(mesh, 1'000'000 / meshes.size(), kSeed);
        countLeaks(leaks, rays, test::sharedTracer().trace(*tree, rays).hits);
        EXPECT_EQ(leaks.leaks, 0u);
    }
    EXPECT_EQ(leaks.rays, 1'000'000u);
}
TEST(Leaks, AHoleIsFound) {
    ClosedMesh mesh = closedMeshes(kSeed).front();
    const std::vector<Ray> rays = leakRays(mesh, 2000, kSeed);
    mesh.triangles.pop_back();
    const TriangleSet set = makeTriangleSet(mesh.triangles);
    std::vector<Hit> hits;
    for (const Ray& ray : rays) hits.push_back(bruteForce(set, ray, Query::closest));
    Leaks leaks;
    countLeaks(leaks, rays, hits);
    EXPECT_GT(leaks.leaks, 10u);
    EXPECT_LT(leaks.leaks, 200u) << "a twentieth of the faces is gone";
}

}  // namespace
}  // namespace cleave
