// Records a picture, sample by sample: camera rays, their hits, the view's scale, shadows or whole paths, colours.
#pragma once

#include <deque>
#include <vector>

#include "cleave/cleave.hpp"
#include "core/trace_push.h"
#include "record/recorder.h"
#include "render/picture_layout.h"
#include "render/surface_data.h"

namespace cleave {

enum class View : uint32_t {
    shaded = kViewShaded,
    normals = kViewNormals,
    depth = kViewDepth,
    steps = kViewSteps,
    leaves = kViewLeaves,
    path = kViewPath
};
inline bool countsSteps(View view) { return view == View::steps || view == View::leaves; }
// Where light is shown, rays look through what is not there: alpha, and backs that are not to be seen.
inline bool showsSurfaces(View view) { return view == View::shaded || view == View::path; }
// A pixel of the others shows one ray, so that the mean of several would mean nothing.
inline bool takesSamples(View view) { return view == View::shaded || view == View::normals || view == View::path; }

// The passes of a picture, in the order of their first use. A row: the kernel (shaders/render/<kernel>.comp), its twin.
#define CLEAVE_PICTURE_PASSES(ROW)       \
    ROW(camera_rays, cameraRays)         \
    ROW(depth_scale, depthScale)         \
    ROW(count_histogram, countHistogram) \
    ROW(select_count, selectCount)       \
    ROW(shadow_rays, shadowRays)         \
    ROW(shade, shade)                    \
    ROW(path_scatter, pathScatter)       \
    ROW(path_gather, pathGather)         \
    ROW(tone, tone)

// Where a view has a scale: its ends are found in all of the picture before anything is coloured.
inline bool hasScale(View view) { return view == View::depth || countsSteps(view); }

// From the camera; on from a surface; to a light.
enum class PictureRays { primary, bounce, shadow };

struct PictureInfo {
    // Rays visit one after the other and go on from what they hit; together the trees have all triangles.
    std::span<const VkDeviceAddress> trees;
    // The only one is a PlacedScene. For views that show nothing of triangles: depth, steps and leaves.
    bool instances = false;
    // Of the only tree: as TraceInfo::open, for rays that wait; 0: none does. Not for paths.
    VkDeviceAddress open = 0;
    // The only one is a single leaf, of few triangles (TraceMode::single).
    bool single = false;
    Box bounds = emptyBox();        // of all trees, in the scaled space of `exponent`
    int32_t exponent = 0;           // the largest of the trees'
    VkDeviceAddress triangles = 0;  // 36 bytes each: the vertices in world space, by number
    SurfaceAddresses surfaces;
    VkDeviceAddress lights = 0;    // LightSource of shared/light.h, settings.lightCount of them, for paths
    VkDeviceAddress emitters = 0;  // AliasSlot of shared/emitter.h, settings.emitters.slots of them, for paths
    VkDeviceAddress albedo = 0;    // of render/albedo_table.h, for paths
    ImageCamera camera{};
    View view = View::shaded;
    uint32_t samples = 1;  // of a pixel; a single one is at its centre
    float exposure = 1.0f;
    PathSettings settings{};    // of paths; its seed is of all samples
    float ambientReach = 0.0f;  // of the view `shaded` by several samples, as PictureArgs::ambientReach
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
    VkDeviceSize largestRange = 0;  // as BuildInfo::largestRange
    uint32_t stepLimit = 0;         // as TraceInfo::stepLimit
    PictureParts kept{};            // also what the picture does not need; it is the same
    // Called while recording, after each pass: for timestamps. The passes that trace are "trace", "trace shadows"
    // and, of paths, "trace bounces".
    void (*onPass)(void* user, const char* pass) = nullptr;
    void* user = nullptr;

    bool looksThrough(PictureRays rays) const {
        const bool backs = surfaces.singleSided && rays == PictureRays::primary;
        return showsSurfaces(view) && (surfaces.hasAlpha || backs);
    }
    PictureParts parts() const {
        PictureParts p = partsOf(static_cast<uint32_t>(view));
        p.trails = kept.trails || mayGoOn(modeOf(Query::closest, false));
        p.steps = p.steps || kept.steps;
        p.shadows = p.shadows || kept.shadows;
        p.emitters = kept.emitters || settings.emitters.slots > 0;
        p.trees = static_cast<uint32_t>(trees.size());
        return p;
    }
    TraceMode primaryMode() const { return modeOf(Query::closest, parts().steps); }
    TraceMode shadowMode() const { return modeOf(Query::any, false); }

  private:
    TraceMode modeOf(Query query, bool countSteps) const {
        TraceMode mode{query, traversal, test, countSteps, instances};
        mode.single = single && mayBeSingle(mode);
        mode.lazy = open != 0;
        return mode;
    }
};

// The arguments of a picture's kernels, which lie in `scratch` as `at` says.
PictureArgs pictureArgs(const PictureInfo& info, const PictureLayout& at, const Range* scratch) noexcept;

// The pipelines of pictures, beside those that trace through what is opaque. A pipeline is made when a picture first
// needs it, without the code for parts that its scene does not have.
class PictureKernels {
  public:
    explicit PictureKernels(const PipelineHome& home, uint32_t longestRow = 0);

    enum Pass : size_t {
#define CLEAVE_PASS_NUMBER(kernel, twin) kernel,
        CLEAVE_PICTURE_PASSES(CLEAVE_PASS_NUMBER)
#undef CLEAVE_PASS_NUMBER
            count
    };
    // Makes what the picture needs and is not there yet. Throws Error.
    void prepare(const PictureInfo& info);
    // Of a picture that they are prepared for.
    const Kernel& of(Pass pass, const PictureInfo& info) const;
    const Kernel& ofAlpha(const TraceMode& mode, const PictureInfo& info) const;
    Recorder recorder(VkCommandBuffer commands) const { return {*home_.functions, commands, row_}; }

  private:
    struct Variant {
        std::vector<uint32_t> constants;
        Kernel kernel;
    };
    const Variant* find(std::string_view name, std::span<const uint32_t> constants) const;
    void make(const char* name, size_t pushBytes, std::vector<uint32_t> constants);

    PipelineHome home_;
    uint32_t row_;
    std::deque<Variant> variants_;  // few
};

// The contexts that trace a picture's rays; they may be the same one. Not used for rays that look through something.
struct PictureTracing {
    const Context* primary = nullptr;  // has info.primaryMode()
    const Context* shadow = nullptr;   // has info.shadowMode(), for the views of light
};

// Rays that go through the picture together, by their numbers (pixelOf() in shared/picture.h).
struct RaySlice {
    uint32_t first = 0;
    uint32_t count = 0;
};
inline RaySlice allRays(const PictureInfo& info) { return {0, info.camera.width * info.camera.height}; }

// What of a slice is recorded. Where PictureState tells of rays that are unfinished, those of the camera go on by
// `primaryAgain`, as often as it takes, then follow `shadows`; shadow rays go on by `shadowsAgain`, then follow
// `colours`. Rays that wait take the steps one by one. Paths are all at once.
enum class SampleStep { all, primary, primaryAgain, shadows, shadowsAgain, colours };

// Records sample `sample` of a picture, from 0 on in ascending order, with the ranges of `scratch`, sized as
// pictureLayout() says: its light, or its colours, are added to those of the samples before. A sample is taken slice by
// slice, the one with ray 0 first; as a whole in the views that have a scale. Colours may be made anew before the next
// slice.
void cmdRenderSample(VkCommandBuffer commands, const PictureKernels& kernels, const PictureTracing& tracing,
                     const PictureInfo& info, const Range* scratch, uint32_t sample, const RaySlice& slice,
                     SampleStep step = SampleStep::all);

// Makes pixels of what `samples` samples have gathered. The pixels, the radiance and the PictureState are then where
// the layout has them.
void cmdShowPicture(VkCommandBuffer commands, const PictureKernels& kernels, const PictureInfo& info,
                    const Range* scratch, uint32_t samples);

std::span<const Spirv> renderKernels() noexcept;

}  // namespace cleave
