// Runs a build on the twin up to a pass, hands its arrays to the device, runs that pass on both, compares everything.
#pragma once

#include <string>

#include "run/ranges.h"
#include "twin/passes.h"

namespace cleave::test {

// The arrays of a build on both sides, and what differs.
class BuildPair {
  public:
    // Over the triangles of `list`, or all if that is empty.
    BuildPair(const std::vector<Triangle>& world, const std::vector<uint32_t>& list, BuildInfo info);

    BuildArrays arrays;  // the twin's
    PassChoice choice(bool expands = false) const { return choiceOf(info_, expands); }

    // Begins to build these nodes of the tree further, once the twin's is done.
    void expand(std::vector<OpenNode> open);

    // Runs a pass on both sides; the name of the first array that differs and where, or "" if none does.
    std::string differenceAfter(const twin::Pass& pass, uint32_t depth, bool largeGroups);

  private:
    BuildInfo info_;
    Geometry geometry_;
    Buffer world_, list_, open_;
    RangeBuffers scratch_;
    Buffer tree_;
    ScratchLayout at_;
    BuildArgs args_;  // the device's, with its addresses

    void upload();
    std::string difference() const;
};

// Builds with several settings, and checks the pass called `name` (the stem of its files) where it runs: once, or on
// the first levels, on some in the middle and on the last. Among the triangles are some that stay out of the tree.
// EXPECTs.
void expectPassEqualsTwin(const std::string& name, uint32_t triangleCount, uint32_t seed);

// Builds trees that are left open, and every other open node further: checks the passes of that where they run, as
// above. Returns how many nodes were built further. EXPECTs.
uint32_t expectExpansionEqualsTwin(uint32_t triangleCount, uint32_t seed);

}  // namespace cleave::test
