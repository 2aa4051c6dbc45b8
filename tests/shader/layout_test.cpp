#include "layout.h"

#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "record/recorder.h"
#include "support/device.h"

namespace cleave {
std::span<const Spirv> testKernels() noexcept;
}

namespace cleave::test {

TEST(Layout, HostFindsWhatTheShaderWrote) {
    const PipelineHome home = pipelineHome();
    Kernel kernel;
    ASSERT_EQ(kernel.create(home, findSpirv(testKernels(), "layout"), sizeof(uint64_t), {}), VK_SUCCESS);
    const Buffer buffer(device(), sizeof(LayoutRecord));
    Commands commands(device());
    commands.begin();
    commands.fillZero(buffer.handle());
    Recorder(*home.functions, commands.handle()).dispatch(kernel, buffer.address(), 1);
    commands.run();
    const LayoutRecord r = buffer.download<LayoutRecord>(1)[0];
    EXPECT_EQ(r.box.lo, glm::vec3(1, 2, 3));
    EXPECT_EQ(r.box.hi, glm::vec3(4, 5, 6));
    EXPECT_EQ(r.node.plane, 7u);
    EXPECT_EQ(r.node.link, 8u);
    EXPECT_EQ(r.split.cost, 9.0f);
    EXPECT_EQ(r.split.axis, 10u);
    EXPECT_EQ(r.split.position, 11.0f);
    EXPECT_EQ(r.split.planarLeft, 12u);
    EXPECT_EQ(r.ray.origin, glm::vec3(13, 14, 15));
    EXPECT_EQ(r.ray.tMin, 16.0f);
    EXPECT_EQ(r.ray.direction, glm::vec3(17, 18, 19));
    EXPECT_EQ(r.ray.tMax, 20.0f);
    EXPECT_EQ(r.hit.t, 21.0f);
    EXPECT_EQ(r.hit.prim, 22u);
    EXPECT_EQ(r.hit.u, 23.0f);
    EXPECT_EQ(r.hit.v, 24.0f);
    EXPECT_EQ(r.triangle.a, glm::vec3(25, 26, 27));
    EXPECT_EQ(r.triangle.b, glm::vec3(28, 29, 30));
    EXPECT_EQ(r.triangle.c, glm::vec3(31, 32, 33));
    EXPECT_EQ(r.ref.lo, glm::vec3(34, 35, 36));
    EXPECT_EQ(r.ref.prim, 37u);
    EXPECT_EQ(r.ref.hi, glm::vec3(38, 39, 40));
    EXPECT_EQ(r.ref.node, 41u);
    EXPECT_EQ(r.buildNode.cell.lo, glm::vec3(42, 43, 44));
    EXPECT_EQ(r.buildNode.cell.hi, glm::vec3(45, 46, 47));
    EXPECT_EQ(r.buildNode.first, 48u);
    EXPECT_EQ(r.buildNode.count, 49u);
    EXPECT_EQ(r.buildNode.treeNode, 50u);
    EXPECT_EQ(r.buildNode.chunk, 51u);
    EXPECT_EQ(r.buildNode.child, 52u);
    EXPECT_EQ(r.buildNode.leftBase, 53u);
    EXPECT_EQ(r.buildNode.rightBase, 54u);
    EXPECT_EQ(r.buildNode.split.cost, 55.0f);
    EXPECT_EQ(r.buildNode.split.planarLeft, 56u);
    EXPECT_EQ(r.chunk.node, 57u);
    EXPECT_EQ(r.chunk.first, 58u);
    EXPECT_EQ(r.chunk.count, 59u);
    EXPECT_EQ(r.steps.inner, 60u);
    EXPECT_EQ(r.steps.leaves, 61u);
    EXPECT_EQ(r.steps.triangles, 62u);
    EXPECT_EQ(r.steps.restarts, 63u);
    EXPECT_EQ(r.steps.hitLeaf, 64u);
    EXPECT_EQ(r.counters.invalidRays, 65u);
    EXPECT_EQ(r.counters.unfinishedRays, 66u);
    EXPECT_EQ(r.state.nodesUsed, 67u);
    EXPECT_EQ(r.state.leafRefsUsed, 68u);
    EXPECT_EQ(r.state.nodeBase, 69u);
    EXPECT_EQ(r.state.leafBase, 70u);
    EXPECT_EQ(r.state.levels, 71u);
    EXPECT_EQ(r.state.finish, 72u);
    EXPECT_EQ(r.state.neededRefs, 73u);
    EXPECT_EQ(r.state.neededLevelNodes, 74u);
    EXPECT_EQ(r.state.neededNodes, 75u);
    EXPECT_EQ(r.state.neededLeafRefs, 76u);
    EXPECT_EQ(r.state.refTotals, glm::uvec4(77, 78, 79, 80));
    EXPECT_EQ(r.state.level[0].refCount, 85u);
    EXPECT_EQ(r.state.level[0].nodeCount, 86u);
    EXPECT_EQ(r.state.level[0].chunkCount, 87u);
    EXPECT_EQ(r.state.level[1].refCount, 89u);
    EXPECT_EQ(r.state.level[1].nodeCount, 90u);
    EXPECT_EQ(r.state.level[1].chunkCount, 91u);
    EXPECT_EQ(r.state.level[kMaxDepth + 1].refCount, 93u);
    EXPECT_EQ(r.state.level[kMaxDepth + 1].nodeCount, 94u);
    EXPECT_EQ(r.state.level[kMaxDepth + 1].chunkCount, 95u);
    EXPECT_EQ(r.state.level[1].perChunk.x, 97u);
    EXPECT_EQ(r.state.level[1].perChunk.y, 98u);
    EXPECT_EQ(r.state.level[1].perChunk.z, 99u);
    EXPECT_EQ(r.state.level[1].perChunkGroup.x, 100u);
    EXPECT_EQ(r.state.level[1].perChunkGroup.y, 101u);
    EXPECT_EQ(r.state.level[1].perChunkGroup.z, 102u);
    EXPECT_EQ(r.state.level[1].perRefBlock.x, 106u);
    EXPECT_EQ(r.state.level[1].perRefBlock.y, 107u);
    EXPECT_EQ(r.state.level[1].perRefBlock.z, 108u);
    EXPECT_EQ(r.state.level[1].perBatch.x, 109u);
    EXPECT_EQ(r.state.level[1].perBatch.y, 110u);
    EXPECT_EQ(r.state.level[1].perBatch.z, 111u);
    EXPECT_EQ(r.state.level[1].perNodeBlock.x, 112u);
    EXPECT_EQ(r.state.level[1].perNodeBlock.y, 113u);
    EXPECT_EQ(r.state.level[1].perNodeBlock.z, 114u);
    EXPECT_EQ(r.state.level[1].once.x, 115u);
    EXPECT_EQ(r.state.level[1].once.y, 116u);
    EXPECT_EQ(r.state.level[1].once.z, 117u);
    uint32_t next = kFirstListed;
#define SEE(field) EXPECT_EQ(r.field, static_cast<decltype(r.field)>(next++)) << #field;
#define SEE_ADDRESS(field, Array) SEE(field)
    CLEAVE_LAYOUT_FIELDS(SEE, SEE, SEE, SEE, SEE_ADDRESS)
#define SEE_BUILD(name, Element, Array, count) SEE(buildArgs.name)
#define SEE_PICTURE(name, Element, Array, count) SEE(pictureArgs.name)
    CLEAVE_LAYOUT_ARRAYS(SEE_BUILD, SEE_PICTURE)
}

}  // namespace cleave::test
