// Poses vertices on the device.
#pragma once

#include <memory>
#include <span>

#include "run/device_tree.h"
#include "shared/pose.h"

namespace cleave {

// What is the same at all times; see shared/pose.h. At least one part.
struct PoseArrays {
    std::span<const PosePart> parts;
    std::span<const glm::dvec3> positions;
    std::span<const PoseMorph> morphs;
    std::span<const glm::dvec3> deltas;
    std::span<const PoseInfluence> influences;
    std::span<const uint32_t> corners;
    std::span<const uint32_t> numbers;
    uint32_t vertices = 0;  // of all parts
};

// The same on the device.
class DevicePose {
  public:
    DevicePose(Device& device, const PoseArrays& arrays);

  private:
    friend class Poser;
    Buffer parts_, positions_, morphs_, deltas_, influences_, corners_, numbers_;
    Buffer posed_;
    Buffer maps_, weights_;  // of a time; kept while they suffice
    PosePush push_{};        // without the scene's triangles
};

class Poser {
  public:
    explicit Poser(Device& device);
    ~Poser();
    double setupMilliseconds() const { return setupMs_; }

    // Brings the triangles of the parts to a time, which has these maps and weights. Returns when that is done.
    void pose(DevicePose& pose, std::span<const AffineMap> maps, std::span<const double> weights,
              const DeviceTriangles& triangles);

  private:
    struct State;
    std::unique_ptr<State> state_;
    double setupMs_ = 0.0;
};

}  // namespace cleave
