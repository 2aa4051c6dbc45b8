// Runs a build on the twin up to a pass, hands its arrays to the device, runs that pass on both, compares everything.
#pragma once

#include <functional>
#include <string>

#include "pass/build_passes.h"
#include "twin/passes.h"

namespace cleave::test {

// The arrays of a build on both sides, and what differs.
class BuildPair {
  public:
    BuildPair(const TriangleSet& set, const BuildSettings& settings);

    BuildArrays arrays;  // the twin's
    BuildBuffers buffers;
    const BuildPasses& passes;

    void upload();
    // Runs a pass on both sides; the name of the first array that differs and where, or "" if none does.
    std::string differenceAfter(const std::function<void(Recorder&)>& onDevice, const std::function<void()>& onTwin);

  private:
    std::shared_ptr<DeviceTriangles> triangles_;
};

// The device's passes, compiled once.
const BuildPasses& buildPasses();

// Builds over kSizes and with several settings, and checks the pass called `name` (the stem of its files) on the first
// levels, on some in the middle and on the last. Uses EXPECT.
void expectPassEqualsTwin(const std::string& name, uint32_t triangleCount, uint32_t seed);

}  // namespace cleave::test
