// Input for the render kernels, made from a seed, on both sides.
#pragma once

#include "pass/render_passes.h"
#include "support/device.h"
#include "support/scenes.h"
#include "twin/render.h"

namespace cleave::test {

class PictureInput {
  public:
    PictureInput(uint32_t pixels, uint32_t seed);

    float offset = 1e-3f;
    float low = 0.5f;
    float high = 40.0f;

    twin::ShadeArrays arrays() const;
    std::vector<Ray> shadowRaysOnDevice();
    std::vector<uint32_t> pixelsOnDevice(uint32_t view);

  private:
    std::vector<Ray> rays_;
    std::vector<Hit> hits_, shadowHits_;
    std::vector<StepCount> steps_;
    std::vector<Triangle> triangles_;
    std::vector<uint32_t> materialOf_;
    std::vector<glm::vec4> baseColours_;
    Buffer b_[9];
    ShadePush push(uint32_t view) const;
};

}  // namespace cleave::test
