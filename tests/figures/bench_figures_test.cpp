#include "figures/bench_figures.h"
#include "figures/peer_figures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/text.h"
#include "base/warm_up.h"
#include "figures/json.h"
#include "figures/timing.h"

namespace cleave::test {
namespace {

BuilderFigures figuresOf(Builder builder, double sahCost, uint64_t references) {
    BuilderFigures f;
    f.built.builder = builder;
    f.built.runs = {3.0, 1.5, 2.0};
    f.built.ms = medianOf(f.built.runs);
    f.built.peakBytes = 3u << 20;
    f.built.statistics.nodes = 1234567;
    f.built.statistics.references = references;
    f.built.statistics.maxDepth = 9;
    f.built.statistics.sahCost = sahCost;
    f.modes.resize(1);
    SetFigures& primary = f.modes[0].sets[0];
    primary.rays = 1000000;
    primary.ms = 500.0;
    primary.runs = {400.0, 500.0, 800.0};
    primary.check.rays = 2048;
    return f;
}

TEST(Timing, WarmsUpUntilTheTimeHasGoneByAndAtLeastOnce) {
    const Stopwatch watch;
    int quick = 0, slow = 0;
    warmUp([&] { quick++; });
    EXPECT_GE(watch.milliseconds(), kWarmUpMs);
    EXPECT_GE(quick, 1);
    warmUp([&] {
        slow++;
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kWarmUpMs));
    });
    EXPECT_EQ(slow, 1);
}

TEST(Timing, Median) {
    EXPECT_EQ(medianOf({5.0}), 5.0);
    EXPECT_EQ(medianOf({9.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(medianOf({9.0, 1.0, 2.0, 4.0}), 3.0);
}

TEST(Timing, RaysPerSecond) {
    EXPECT_EQ(mraysPerSecond(1000000, 500.0), 2.0);
    EXPECT_EQ(mraysPerSecond(1000000, 0.0), std::nullopt);
    EXPECT_EQ(mraysPerSecond(0, 1.0), std::nullopt);
}

TEST(Text, AlignsColumns) {
    EXPECT_EQ(alignedTable({{"a", "bb"}, {"ccc", "d"}}, "lr"), "a    bb\nccc   d\n");
    EXPECT_EQ(alignedTable({{"\xC3\xA9", "b"}, {"cc", "d"}}, "ll"), "\xC3\xA9   b\ncc  d\n") << "UTF-8 has its width";
}

TEST(Text, Numbers) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(69451), "69,451");
    EXPECT_EQ(grouped(1234567), "1,234,567");
    EXPECT_EQ(fixed(1.25, 1), "1.2");
    EXPECT_EQ(fixed(std::nullopt, 1), "-");
    EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 1), "-");
    EXPECT_EQ(bytesText(3u << 20), "3.0 MiB");
}

TEST(Text, OneLineHasNoControlCharacters) { EXPECT_EQ(oneLine("a\nb\x1b[31mc\n"), "a b [31mc"); }

TEST(BenchTable, BuildersSideBySideWithRatios) {
    const std::string table =
        treeTable({figuresOf(Builder::gpu, 110.0, 3000), figuresOf(Builder::exact, 100.0, 2000)}, 1000);
    EXPECT_EQ(table, R"(
builder  build ms      min..max  SAH cost  /exact      nodes  references  /triangle  /exact  depth  inner  leaves  triangles     peak
gpu         2.000  1.500..3.000   110.000   1.100  1,234,567       3,000       3.00   1.500      9      -       -          -  3.0 MiB
exact       2.000  1.500..3.000   100.000   1.000  1,234,567       2,000       2.00   1.000      9      -       -          -  3.0 MiB
)" + 1);
}

TEST(BenchTable, WithoutExactThereAreNoRatiosToIt) {
    const std::string table = treeTable({figuresOf(Builder::gpu, 110.0, 3000)}, 1000);
    EXPECT_EQ(table.find("/exact"), std::string::npos);
    EXPECT_NE(table.find("3,000"), std::string::npos);
    EXPECT_NE(treeTable({figuresOf(Builder::gpu, 1.0, 0)}, 0).find("-"), std::string::npos) << "an empty scene";
}

TEST(BenchTable, Rays) {
    EXPECT_EQ(rayTable({figuresOf(Builder::gpu, 110.0, 3000)}),
              "builder  primary ms  Mrays/s  diffuse ms  Mrays/s  shadow ms  Mrays/s  checked  wrong  undecided\n"
              "gpu         500.000    2.000           -        -          -        -    2,048      0          0\n");
}

TEST(BenchTable, WaysOfRaysSideBySide) {
    BuilderFigures figures = figuresOf(Builder::gpu, 110.0, 3000);
    figures.modes.push_back(figures.modes[0]);
    figures.modes[1].traversal = Traversal::stack;
    figures.modes[1].test = TriangleTest::plain;
    figures.modes[1].sets[0].check.mismatches = 7;
    figures.modes[0].sets[0].work = RayWork{20.0, 5.0, 8.0, 1.0, 3.0, 0.75};
    const std::string table = rayTable({figures});
    EXPECT_NE(table.find("gpu      restart    watertight     500.000"), std::string::npos) << table;
    EXPECT_NE(table.find("12.50 %    2,048      0"), std::string::npos) << table;
    EXPECT_NE(table.find("gpu      stack      plain "), std::string::npos) << table;
    EXPECT_NE(table.find("-    2,048      7"), std::string::npos) << table;
}

TEST(BenchTable, WorkOfRays) {
    BuilderFigures figures = figuresOf(Builder::gpu, 110.0, 3000);
    figures.modes[0].sets[0].work = RayWork{20.0, 5.0, 8.0, 1.0, 3.0, 0.75};
    EXPECT_EQ(workTable({figures}),
              "builder  traversal  test        rays     inner  leaves  triangles  in double  restarts  lanes in use\n"
              "gpu      restart    watertight  primary  20.00    5.00       8.00       1.00      3.00        75.0 %\n");
}

// Three rays in subgroups of two: 10 and 30 visits together take 2 x 30 places, 20 alone as many as 2 x 20.
TEST(RayWork, HandWorkedAverages) {
    const std::vector<StepCount> steps{{8, 2, 4, 1, 0, 1}, {20, 10, 6, 3, 0, 2}, {15, 5, 2, 2, 0, 0}};
    const RayWork work = workOf(steps, 2);
    EXPECT_DOUBLE_EQ(work.inner, 43.0 / 3.0);
    EXPECT_DOUBLE_EQ(work.leaves, 17.0 / 3.0);
    EXPECT_DOUBLE_EQ(work.triangles, 4.0);
    EXPECT_DOUBLE_EQ(work.resolved, 1.0);
    EXPECT_DOUBLE_EQ(work.restarts, 2.0);
    EXPECT_DOUBLE_EQ(work.lanesInUse, 60.0 / 100.0);
    EXPECT_DOUBLE_EQ(workOf({}, 8).lanesInUse, 0.0);
}

BuilderFigures figuresBesidePeers() {
    BuilderFigures ours = figuresOf(Builder::exact, 100.0, 2000);
    for (SetFigures& set : ours.modes[0].sets) {
        set.rays = 1000000;
        set.runs = {400.0, 500.0, 800.0};
    }
    return ours;
}

TEST(PeerTable, RatesBesideOurs) {
    PeerFigures peer;
    peer.name = "embree";
    peer.order = "file";
    peer.buildRuns = {3.0, 1.0, 2.0};
    peer.sets = {PeerSetFigures{1000000, 3, {200.0, 250.0, 1000.0}}, PeerSetFigures{1000000, 10001, {}},
                 PeerSetFigures{1000000, 0, {1000.0}}};
    PeerFigures absent;
    absent.name = "ray-query";
    absent.order = "morton";
    absent.missing = "not here";
    const std::string table = peerTable({figuresBesidePeers()}, {peer, absent});
    EXPECT_NE(table.find("4.00  1.00..5.00   0.50"), std::string::npos) << table;
    EXPECT_NE(table.find("wrong"), std::string::npos) << table;
    EXPECT_NE(table.find("2.00"), std::string::npos) << table;
    EXPECT_NE(table.find("3,000,000  10,004"), std::string::npos) << table;
    EXPECT_NE(table.find("ray-query, morton: not here"), std::string::npos) << table;
    const Json json = peerJson(peer);
    EXPECT_EQ(json["buildMs"], 2.0);
    EXPECT_EQ(json["sets"]["primary"]["disagreements"], 3);
    EXPECT_EQ(json["sets"]["primary"]["mraysPerSecond"], 4.0);
    EXPECT_EQ(json["sets"]["diffuse"]["mraysPerSecond"], nullptr);
    EXPECT_EQ(json["sets"]["diffuse"]["wrong"], true);
    EXPECT_EQ(peerJson(absent)["missing"], "not here");
}

TEST(BenchTable, KernelsByTheirShare) {
    BuilderFigures figures = figuresOf(Builder::gpu, 110.0, 3000);
    EXPECT_EQ(kernelLines({figures}), "");
    figures.built.profile.passes = {{"bin", 1.0}, {"classify", 3.0}};
    EXPECT_EQ(kernelLines({figures}), "gpu build by kernel, %: classify 75.0 bin 25.0\n");
}

TEST(BenchTable, PassesAndLevelsByElement) {
    BuilderFigures figures = figuresOf(Builder::gpu, 110.0, 3000);
    EXPECT_EQ(passTable({figures}), "");
    BuildProfile& profile = figures.built.profile;
    profile.passes = {{"next_level", 1.0, 2, 2, "", 0}, {"classify", 3.0, 2, 6, "references", 1500}};
    profile.levels = {{1000, 1, 2.5}, {500, 2, 1.5}};
    profile.nodes = 3;
    const std::string table = passTable({figures});
    // 3 ms are 500,000 ns for each of 6 workgroups, 2,000 for each of 1,500 references, 1,000,000 for each of 3 nodes.
    for (const char* cell : {"75.0 %", "500000.0", "2000.0", "1000000.0", "references"})
        EXPECT_NE(table.find(cell), std::string::npos) << cell << "\n" << table;
    // The second level: 1.5 ms are 3,000 ns for each of 500 references and 750,000 for each of 2 nodes.
    for (const char* cell : {"1.500", "3000.0", "750000.0"})
        EXPECT_NE(table.find(cell), std::string::npos) << cell << "\n" << table;
}

std::vector<Hit> threeHits() {
    return {{1.0f, 7, 0.25f, 0.5f}, {infinity(), kNone, 0.0f, 0.0f}, {2.0f, 3, 0.0f, 1.0f}};
}

TEST(HitsHash, SeesEveryBitOfClosestHitsAndTheirOrder) {
    const std::vector<Hit> hits = threeHits();
    const std::string hash = hitsHash(hits, Query::closest);
    EXPECT_EQ(hash.size(), 16u);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
    EXPECT_EQ(hitsHash(threeHits(), Query::closest), hash);
    for (size_t bit = 0; bit < hits.size() * sizeof(Hit) * 8; ++bit) {
        std::vector<Hit> other = hits;
        reinterpret_cast<unsigned char*>(other.data())[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
        EXPECT_NE(hitsHash(other, Query::closest), hash) << "bit " << bit;
    }
    std::vector<Hit> swapped = hits;
    std::swap(swapped[0], swapped[2]);
    EXPECT_NE(hitsHash(swapped, Query::closest), hash);
    EXPECT_NE(hitsHash(std::span(hits).first(2), Query::closest), hash);
}

TEST(HitsHash, AnyHitsCountByWhetherThereIsOne) {
    const std::string hash = hitsHash(threeHits(), Query::any);
    std::vector<Hit> other = threeHits();
    other[0] = {9.0f, 8, 0.75f, 0.125f};
    EXPECT_EQ(hitsHash(other, Query::any), hash) << "the triangle is the tree's choice";
    for (size_t i = 0; i < 3; ++i) {
        other = threeHits();
        other[i].prim = other[i].prim == kNone ? 0 : kNone;
        EXPECT_NE(hitsHash(other, Query::any), hash) << "ray " << i;
    }
}

TEST(JsonReport, KeysOfABuild) {
    const Json json = buildJson(figuresOf(Builder::exact, 100.0, 2000).built);
    for (const char* key :
         {"builder", "ms", "setupMs", "sahCost", "treeHash", "nodes", "leaves", "references", "maxDepth", "peakBytes",
          "memoryLimited", "expectedInner", "expectedLeaves", "expectedTriangles"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["builder"], "exact");
    EXPECT_EQ(json["sahCost"], 100.0);
    EXPECT_TRUE(json["expectedInner"].is_null());
}

TEST(JsonReport, KeysOfTraceAndCheck) {
    const Json trace = traceJson(Traversal::stack, TriangleTest::plain, 1000000, 500.0, 3, 0);
    EXPECT_EQ(trace["rays"], 1000000);
    EXPECT_EQ(trace["ms"], 500.0);
    EXPECT_EQ(trace["mraysPerSecond"], 2.0);
    EXPECT_EQ(trace["traversal"], "stack");
    EXPECT_EQ(trace["triangleTest"], "plain");
    EXPECT_EQ(trace["invalidRays"], 3);
    EXPECT_TRUE(traceJson(Traversal::restart, TriangleTest::watertight, 0, 0.0, 0, 0)["mraysPerSecond"].is_null());
    CheckResult check;
    check.rays = 7;
    check.undecided = 1;
    const Json json = checkJson(check);
    EXPECT_EQ(json["rays"], 7);
    EXPECT_EQ(json["mismatches"], 0);
    EXPECT_EQ(json["undecided"], 1);
    EXPECT_EQ(json["maxRelativeTError"], 0.0);
    EXPECT_TRUE(numberJson(std::numeric_limits<double>::quiet_NaN()).is_null());
}

}  // namespace
}  // namespace cleave::test
