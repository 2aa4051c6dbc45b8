#include <algorithm>
#include <map>

#include "shared/face_bins.h"
#include "twin/passes.h"

namespace cleave::twin {

namespace {

// References that begin, end and lie flat at a position.
struct At {
    uint32_t begin = 0, end = 0, flat = 0;
};

Split bestInBin(const BuildArrays& a, const BuildNode& node, uint32_t capacity, uint32_t axis, uint32_t bin) {
    const uint32_t word = faceWord(node.chunk, capacity, axis, bin);
    std::map<float, At> positions;
    uint32_t left = a.bins[word], right = a.bins[word + capacity];
    if (a.openBins[word] == kNone) return noSplit();
    for (uint32_t k = a.openBins[word]; k < a.openBins[word + capacity]; k++) {
        At& at = positions[uintBitsToFloat(a.workFaces[k].x)];
        const uint32_t kind = a.workFaces[k].y;
        at.begin += kind != kEndFace;
        at.end += kind != kStartFace;
        at.flat += kind == kFlatFace;
        right += kind != kStartFace;
    }
    Split best = noSplit();
    for (const auto& [x, at] : positions) {
        right -= at.end;
        best = betterOfBothSides(best, a.args.costs, node.cell, axis, x, left, right, at.flat);
        left += at.begin;
    }
    return best;
}

}  // namespace

void chooseFace(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        BuildNode& node = a.nodesIn(depth)[a.chunks[c].node];
        if (node.chunk != c) continue;
        const uint32_t capacity = faceBinCapacity(node.count);
        Split best = noSplit();
        for (uint32_t axis = 0; axis < 3; axis++)
            for (uint32_t b = 0; b < capacity; b++) {
                const Split split = bestInBin(a, node, capacity, axis, b);
                if (isBetter(split, best)) best = split;
            }
        const bool keep = isWorthwhile(a.args.costs, best, node.cell, node.count, depth, a.state.maxDepth);
        node.split = keep ? best : noSplit();
    }
}

}  // namespace cleave::twin
