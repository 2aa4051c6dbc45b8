// Pictures: rays of a camera, traced, shaded on the device.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "device_tree.h"
#include "scene/pose.h"
#include "shared/ray.h"
#include "tracer.h"

namespace cleave {

enum class View { shaded, normals, depth, steps, leaves };

struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint32_t> pixels;  // R | G << 8 | B << 16 | A << 24, sRGB, row by row from the top
    Tracer::Result primary;        // hits of the primary rays, pixel by pixel
    double ms = 0.0;               // device time of all passes
    float scaleLow = 0.0f;  // the ends of the scale of depth, steps and leaves; what lies beyond looks like the end
    float scaleHigh = 0.0f;
};

class Renderer {
  public:
    Renderer(Context& context, Tracer& tracer);
    ~Renderer();
    // Both scenes are the tree's. `rays` holds width * height rays, row by row. Steps are counted where the view shows them.
    Picture render(const DeviceTree& tree, const Scene& scene, const PosedScene& posed, std::span<const Ray> rays, uint32_t width,
                   uint32_t height, View view, TraceMode mode = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave
