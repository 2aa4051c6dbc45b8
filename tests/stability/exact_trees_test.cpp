// Exact SAH on the device over the cases that are hard on numbers: the tree of the exact builder on the CPU.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "run/gpu_builder.h"
#include "stability/cases.h"
#include "support/device.h"

namespace cleave::test {

// Nodes are large early, so that their planes are found by bins.
TEST(ExactTrees, AreTheSameOnTheDevice) {
    GpuBuilder builder(device());
    BuildSettings settings;
    settings.exactUpTo = 8;
    size_t nodes = 0;
    for (const StabilityCase& made : stabilityCases()) {
        SCOPED_TRACE(std::string(made.name) + ", seed 1");
        Random random(seedFor(1, made.name));
        const std::vector<Triangle> world = made.make(random, true);
        const KdTree exact = buildExact(makeTriangleSet(world), settings);
        settings.exact = true;
        const KdTree tree = readBack(*builder.build(DeviceTriangles(device(), world), settings).tree);
        EXPECT_EQ(treeHash(tree), treeHash(exact));
        nodes += tree.nodes.size();
    }
    EXPECT_GT(nodes, 10'000u);
}

}  // namespace cleave::test
