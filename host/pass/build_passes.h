// The kernels of a build, and in which order they run.
#pragma once

#include "gpu/kernel.h"
#include "gpu/recorder.h"
#include "pass/build_buffers.h"

namespace cleave {

class BuildPasses {
  public:
    explicit BuildPasses(Context& context);

    // Each records one pass. Sizes come from the device (BuildState::level), so nothing is read back in between.
    void makeRefs(Recorder& r, const BuildBuffers& b, uint32_t includedCount) const;
    void begin(Recorder& r, const BuildBuffers& b) const;
    void bounds(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void bin(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void chooseSplit(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void nearest(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void snap(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void exactSplit(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void classify(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void scan(Recorder& r, const BuildBuffers& b, uint32_t depth, bool scanNodes) const;
    void offsets(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void countChildren(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void nextLevel(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void emitNodes(Recorder& r, const BuildBuffers& b, uint32_t depth) const;
    void partition(Recorder& r, const BuildBuffers& b, uint32_t depth) const;

    // All passes of one level.
    void level(Recorder& r, const BuildBuffers& b, uint32_t depth) const;

  private:
    Kernel makeRefs_, begin_, bounds_, bin_, chooseSplit_, nearest_, snap_, exactSplit_, classify_, scan_, offsets_,
        countChildren_, nextLevel_, emitNodes_, partition_;
};

}  // namespace cleave
