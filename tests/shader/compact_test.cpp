// The kernel that copies a tree without slack, against what the host reads of either.
#include <gtest/gtest.h>

#include <cstring>

#include "builders/builders.h"
#include "gpu/commands.h"
#include "run/context_of.h"
#include "run/ranges.h"
#include "run/tracer.h"
#include "shared/tree.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/trace_cases.h"

namespace cleave::test {

namespace {

// A tree, copied into memory of just its size.
DeviceTree compacted(const Context& context, const DeviceTree& tree) {
    DeviceTree copy;
    copy.memory = Buffer(device(), tree.header.bytes);
    Commands commands(device());
    commands.begin();
    cmdCompact(commands.handle(), context, tree.address(), rangeOf(copy.memory));
    commands.run();
    copy.memory.read(0, &copy.header, sizeof(copy.header));
    return copy;
}

}  // namespace

TEST(Compact, KeepsATreeAtEverySize) {
    const auto context = contextOf(device(), {}, Building{.trees = true});
    for (const uint32_t n : kSizes) {
        SCOPED_TRACE("triangles " + std::to_string(n));
        const TriangleSet set = mixedSet(n, n + 1);
        const KdTree tree = buildSpatialMedian(set, BuildSettings{});
        const auto original = uploadTree(device(), set, tree);
        const DeviceTree copy = compacted(*context, *original);
        EXPECT_EQ(std::memcmp(&copy.header, &original->header, offsetof(TreeHeader, triangles)), 0);
        for (const auto address : {copy.header.triangles, copy.header.nodes, copy.header.leafRefs}) {
            EXPECT_GE(address, copy.address() + sizeof(TreeHeader));
            EXPECT_LE(address, copy.address() + copy.header.bytes);
        }
        const KdTree back = readBack(copy);
        ASSERT_EQ(back.nodes.size(), tree.nodes.size());
        EXPECT_EQ(std::memcmp(back.nodes.data(), tree.nodes.data(), tree.nodes.size() * sizeof(KdNode)), 0);
        EXPECT_EQ(back.leafTriangles, tree.leafTriangles);
        std::vector<TreeTriangle> triangles(n);
        copy.memory.read(copy.header.triangles - copy.address(), triangles.data(), n * sizeof(TreeTriangle));
        for (uint32_t i = 0; i < n; i++) {
            ASSERT_EQ(std::memcmp(&triangles[i], &set.triangles[i], sizeof(Triangle)), 0) << i;
            ASSERT_EQ(triangles[i].number, i);
        }
    }
}

// The copy stands by itself: the original is gone when its rays are traced.
TEST(Compact, DoesNotPointIntoTheOriginal) {
    const auto context = contextOf(device(), {}, Building{.trees = true});
    const TriangleSet set = mixedSet(500, 3);
    const std::vector<Ray> rays = mixedRays(500, 3);
    auto original = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    Tracer& tracer = sharedTracer();
    const std::vector<Hit> want = tracer.trace(*original, rays).hits;
    const DeviceTree copy = compacted(*context, *original);
    original->memory.write(0, std::vector<char>(original->memory.size()).data(), original->memory.size());
    const std::vector<Hit> hits = tracer.trace(copy, rays).hits;
    EXPECT_EQ(std::memcmp(hits.data(), want.data(), want.size() * sizeof(Hit)), 0);
}

}  // namespace cleave::test
