// Makes pictures on the device: from a camera to pixels in one submission.
#pragma once

#include <memory>
#include <vector>

#include "render/cmd_render.h"
#include "run/tracer.h"

namespace cleave {

// The materials of a scene, as a picture needs them.
struct DeviceMaterials {
    Buffer materialOf;   // uint32 per triangle
    Buffer baseColours;  // vec4 per material, linear

    DeviceMaterials(Device& device, std::span<const uint32_t> materialOf, std::span<const glm::vec4> baseColours);
};

struct PictureRequest {
    ImageCamera camera{};
    View view = View::shaded;
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
};

struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint32_t> pixels;  // R | G << 8 | B << 16 | A << 24, sRGB, row by row from the top
    double ms = 0.0;               // device time of all passes
    double traceMs = 0.0;          // of the primary rays alone
    uint64_t invalidRays = 0;
    uint64_t cappedRays = 0;
    float scaleLow = 0.0f;  // the ends of the scale of depth, steps and leaves; what lies beyond looks like the end
    float scaleHigh = 0.0f;
};

class Renderer {
  public:
    Renderer(Device& device, Tracer& tracer, TraceLimits limits = {});
    ~Renderer();
    double setupMilliseconds() const { return setupMs_; }  // of its kernels, without those that trace
    Picture render(const DeviceTree& tree, const DeviceTriangles& triangles, const DeviceMaterials& materials,
                   const PictureRequest& request);

    // The primary rays of the last picture and their hits, tile by tile (pixelOf() in shared/picture.h). They are read
    // from the device, where they stay otherwise.
    std::vector<Ray> readRays() const;
    std::vector<Hit> readHits() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
    double setupMs_ = 0.0;
};

}  // namespace cleave
