#include "twin/passes.h"

namespace cleave::twin {

SplitBoxes partsOf(const BuildArrays& a, const PrimRef& r, const Split& s) {
    const Box box{r.lo, r.hi};
    if (a.args.clip != 0) return splitBoxes(withoutNumber(a.triangles[r.prim]), box, s.axis, s.position);
    return {leftOf(box, s.axis, s.position), rightOf(box, s.axis, s.position)};
}

namespace {

uint32_t classifyOne(BuildArrays& a, uint32_t depth, uint32_t i) {
    const PrimRef& r = a.refsIn(depth)[i];
    const Split& s = a.nodesIn(depth)[r.node].split;
    if (s.axis >= kLeafAxis) return 0;
    const int axis = static_cast<int>(s.axis);
    const uint32_t side = sideOf(r.lo[axis], r.hi[axis], s.position, s.planarLeft);
    if (side != (kLeft | kRight)) return side;
    const SplitBoxes parts = partsOf(a, r, s);
    a.clipped[2 * i] = parts.left;
    a.clipped[2 * i + 1] = parts.right;
    return kClipped | (isEmpty(parts.left) ? 0 : kLeft) | (isEmpty(parts.right) ? 0 : kRight);
}

}  // namespace

void classify(BuildArrays& a, uint32_t depth) {
    const uint32_t count = a.state.level[depth].refCount;
    const uint32_t batches = ceilDiv(a.state.level[depth].subtreeRefCount, kBatch);
    for (uint32_t block = 0; block < ceilDiv(count, kBlock); block++) {
        glm::uvec4& sums = a.blockSums[block];
        sums = block < batches ? glm::uvec4(0, 0, sums.z, sums.w) : glm::uvec4(0);
    }
    for (uint32_t i = 0; i < count; i++) {
        glm::uvec4& sums = a.blockSums[i / kBlock];
        const uint32_t side = classifyOne(a, depth, i);
        a.sides[i] = sideWord(side, sums.x, sums.y);
        sums.x += (side & kLeft) ? 1 : 0;
        sums.y += (side & kRight) ? 1 : 0;
    }
}

}  // namespace cleave::twin
