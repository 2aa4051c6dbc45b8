// Makes pictures on the device: from a camera to pixels in one submission.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/commands.h"
#include "render/cmd_render.h"
#include "run/tracer.h"

namespace cleave {

// What surfaces are made of, in device memory.
class DeviceSurfaces {
  public:
    DeviceSurfaces(Device& device, const SurfaceData& data);
    const SurfaceAddresses& addresses() const { return addresses_; }
    // Takes what another pose of the same scene changes: the sides of triangles, and normals.
    void move(Device& device, const SurfaceData& posed);
    // The same of triangles from number `first` on.
    void move(size_t first, const SurfaceData& part);

  private:
#define CLEAVE_SURFACE_BUFFER(name, Element, Array, part) std::optional<Buffer> name##_;
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_BUFFER)
#undef CLEAVE_SURFACE_BUFFER
    SurfaceAddresses addresses_;
};

// What lights paths.
struct Lighting {
    Sky sky{};
    std::vector<LightSource> lights;
    Emitters emitters{};
    std::vector<AliasSlot> emitterTable;
};

struct PictureRequest {
    ImageCamera camera{};
    View view = View::shaded;
    uint32_t samples = 1;  // of a pixel, in the views of takesSamples(); 1: through its centre
    uint32_t bounces = 8;  // of paths
    uint32_t seed = 0;     // of samples and paths
    float exposure = 1.0f;
    Lighting lighting;  // of paths
    // Of shaded, if there are several samples: what is farther from a surface takes no light from all around it.
    float ambientReach = infinity();
    // Asked after each sample with how many there are: false ends the picture with these.
    std::function<bool(uint32_t samples)> goesOn;
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
    PictureParts kept{};  // see PictureInfo
};

struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t samples = 0;          // that each pixel has
    std::vector<uint32_t> pixels;  // R | G << 8 | B << 16 | A << 24, sRGB, row by row from the top
    double ms = 0.0;               // device time of all passes
    double traceMs = 0.0;          // of the primary rays alone, all samples
    std::vector<PassTime> passes;  // device time by pass, all samples; empty on a queue without a clock
    uint64_t invalidRays = 0;
    uint64_t cappedRays = 0;
    float scaleLow = 0.0f;  // the ends of the scale of depth, steps and leaves; what lies beyond looks like the end
    float scaleHigh = 0.0f;
};

class Renderer {
  public:
    Renderer(Device& device, Tracer& tracer, TraceLimits limits = {});
    ~Renderer();
    double setupMilliseconds() const { return setupMs_; }  // of the kernels so far, without those that trace
    Picture render(const Forest& forest, const DeviceTriangles& triangles, const DeviceSurfaces& surfaces,
                   const PictureRequest& request);

    // Through meshes in places, in a view that shows nothing of triangles.
    Picture render(const DeviceInstances& instances, const PictureRequest& request);

    // The same in parts, for those who look at it on the way. What begin() is given outlives the picture; one that was
    // not finished is forgotten.
    void begin(const Forest& forest, const DeviceTriangles& triangles, const DeviceSurfaces& surfaces,
               const PictureRequest& request);
    // Takes the next slice of a sample, at most TraceLimits::batch rays or, in the views that have a scale, all. True
    // if the sample is whole now.
    bool takeSlice();
    // Whole samples so far, and the rows of the picture, from the top, that have one more.
    uint32_t samplesTaken() const;
    uint32_t rowsTaken() const;
    // The picture of the whole samples; before there is one, the rows that were taken, and nothing below them. Not
    // between the slices of a later sample.
    Picture show();

    // The primary rays of the last picture's last sample and their hits, tile by tile (pixelOf() in shared/picture.h).
    // They are read from the device, where they stay otherwise. Paths overwrite theirs.
    std::vector<Ray> readRays() const;
    std::vector<Hit> readHits() const;
    // The mean radiance of each pixel, linear, row by row.
    std::vector<vec3> readRadiance() const;

  private:
    void begin(const PictureInfo& scene, const PictureRequest& request);
    Picture finish(const PictureRequest& request);

    struct State;
    std::unique_ptr<State> state_;
    double setupMs_ = 0.0;
};

}  // namespace cleave
