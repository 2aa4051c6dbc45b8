#include "pass/build_passes.h"

#include <cstddef>

namespace cleave {

namespace {

size_t sizeOffset(uint32_t depth, size_t member) {
    return offsetof(BuildState, level) + depth * sizeof(Level) + member;
}

BuildPush push(const BuildBuffers& b, uint32_t depth, bool scanNodes = false) {
    return BuildPush{b.args.address(), depth, scanNodes ? 1u : 0u};
}

}  // namespace

BuildPasses::BuildPasses(Context& c)
    : makeRefs_(c, "make_refs", sizeof(BuildPush)),
      begin_(c, "begin", sizeof(BuildPush)),
      bounds_(c, "bounds", sizeof(BuildPush), {c.blockGroup()}),
      bin_(c, "bin", sizeof(BuildPush), {c.blockGroup()}),
      chooseSplit_(c, "choose_split", sizeof(BuildPush)),
      nearest_(c, "nearest", sizeof(BuildPush), {c.blockGroup()}),
      snap_(c, "snap", sizeof(BuildPush)),
      exactSplit_(c, "exact_split", sizeof(BuildPush), {c.smallGroup()}),
      classify_(c, "classify", sizeof(BuildPush), {c.blockGroup()}),
      scan_(c, "scan", sizeof(BuildPush)),
      offsets_(c, "offsets", sizeof(BuildPush), {c.blockGroup()}),
      countChildren_(c, "count_children", sizeof(BuildPush), {c.blockGroup()}),
      nextLevel_(c, "next_level", sizeof(BuildPush)),
      emitNodes_(c, "emit_nodes", sizeof(BuildPush), {c.blockGroup()}),
      partition_(c, "partition", sizeof(BuildPush)) {}

void BuildPasses::makeRefs(Recorder& r, const BuildBuffers& b, uint32_t includedCount) const {
    r.dispatch(makeRefs_, push(b, 0), ceilDiv(includedCount, kGroup));
}
void BuildPasses::begin(Recorder& r, const BuildBuffers& b) const { r.dispatch(begin_, push(b, 0), 1); }
void BuildPasses::bounds(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(bounds_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perChunk)));
}
void BuildPasses::bin(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(bin_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perChunk)));
}
void BuildPasses::chooseSplit(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(chooseSplit_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perChunkGroup)));
}
void BuildPasses::nearest(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(nearest_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perChunk)));
}
void BuildPasses::snap(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(snap_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perChunkGroup)));
}
void BuildPasses::exactSplit(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(exactSplit_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perSmall)));
}
void BuildPasses::classify(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(classify_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perRefBlock)));
}
void BuildPasses::scan(Recorder& r, const BuildBuffers& b, uint32_t d, bool scanNodes) const {
    r.dispatchIndirect(scan_, push(b, d, scanNodes), b.state, sizeOffset(d, offsetof(Level, once)));
}
void BuildPasses::offsets(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(offsets_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perRefBlock)));
}
void BuildPasses::countChildren(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(countChildren_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perNodeBlock)));
}
void BuildPasses::nextLevel(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(nextLevel_, push(b, d), b.state, sizeOffset(d, offsetof(Level, once)));
}
void BuildPasses::emitNodes(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(emitNodes_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perNodeBlock)));
}
void BuildPasses::partition(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    r.dispatchIndirect(partition_, push(b, d), b.state, sizeOffset(d, offsetof(Level, perRefGroup)));
}

void BuildPasses::level(Recorder& r, const BuildBuffers& b, uint32_t d) const {
    bounds(r, b, d);
    bin(r, b, d);
    chooseSplit(r, b, d);
    nearest(r, b, d);
    snap(r, b, d);
    exactSplit(r, b, d);
    classify(r, b, d);
    scan(r, b, d, false);
    offsets(r, b, d);
    countChildren(r, b, d);
    scan(r, b, d, true);
    nextLevel(r, b, d);
    emitNodes(r, b, d);
    partition(r, b, d);
}

}  // namespace cleave
