#include "render/cmd_render.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "core/trace_push.h"
#include "shared/dispatch.h"
#include "shared/traversal.h"
#include "shared/triangle.h"

namespace cleave {
namespace {

VkDeviceAddress addressOf(const Place& p, const Range* scratch) { return scratch[p.range].address + p.offset; }

constexpr const char* kNames[] = {
#define CLEAVE_PASS_NAME(kernel, twin) #kernel,
    CLEAVE_PICTURE_PASSES(CLEAVE_PASS_NAME)
#undef CLEAVE_PASS_NAME
};
const char* alphaKernel(const TraceMode& mode) {
    if (mode.single) return "trace_alpha_single";
    switch (mode.traversal) {
        case Traversal::stack:
            return mode.lazy ? "trace_alpha_lazy_stack" : "trace_alpha_stack";
        case Traversal::shortStack:
            return mode.lazy ? "trace_alpha_lazy_short_stack" : "trace_alpha_short_stack";
        default:
            return mode.lazy ? "trace_alpha_lazy" : "trace_alpha";
    }
}

std::vector<PictureKernels::Pass> passesOf(View view) {
    using P = PictureKernels;
    switch (view) {
        case View::path:
            return {P::camera_rays, P::path_scatter, P::path_gather, P::tone};
        case View::shaded:
            return {P::camera_rays, P::shadow_rays, P::shade, P::tone};
        case View::depth:
            return {P::camera_rays, P::depth_scale, P::shade, P::tone};
        case View::steps:
        case View::leaves:
            return {P::camera_rays, P::count_histogram, P::select_count, P::shade, P::tone};
        case View::normals:
            break;
    }
    return {P::camera_rays, P::shade, P::tone};
}

// A part that scenes may lack doubles the pipelines of a kernel, which a device may have to compile anew.
static_assert(kPartVariants <= 8u);

// The specialisation constants of lib/trace_main.glsl, which come first, do not concern the passes.
std::vector<uint32_t> constantsOf(PictureKernels::Pass pass, const PictureInfo& info) {
    const uint32_t parts = info.surfaces.parts;
    if (pass == PictureKernels::shade) return {0, 0, 0, parts};
    if (pass != PictureKernels::path_scatter) return {};
    constexpr uint32_t kOfCorners = kPartNormals | kPartColours;
    const uint32_t compiled = (parts & kOfCorners) != 0 ? parts | kOfCorners : parts;
    return {0, 0, 0, compiled, info.parts().emitters ? 1u : 0u};
}

// Kernels are told the numbers of modes.
static_assert(kRestartTraversal == static_cast<uint32_t>(Traversal::restart) &&
              kStackTraversal == static_cast<uint32_t>(Traversal::stack) &&
              kShortStackTraversal == static_cast<uint32_t>(Traversal::shortStack));
static_assert(kWatertightTest == static_cast<uint32_t>(TriangleTest::watertight) &&
              kPlainTest == static_cast<uint32_t>(TriangleTest::plain) &&
              kUnfilteredTest == static_cast<uint32_t>(TriangleTest::unfiltered));

std::vector<uint32_t> alphaConstants(const TraceMode& mode, const PictureInfo& info) {
    return {mode.query == Query::any ? 1u : 0u, mode.countSteps ? 1u : 0u, static_cast<uint32_t>(mode.test),
            info.surfaces.parts & ~kPartNormals};
}

class PictureRecording {
  public:
    PictureRecording(VkCommandBuffer commands, const PictureKernels& kernels, const PictureTracing& tracing,
                     const PictureInfo& info, const Range* scratch, uint32_t sample, const RaySlice& slice)
        : kernels_(kernels),
          recorder_(kernels.recorder(commands)),
          tracing_(tracing),
          info_(info),
          scratch_(scratch),
          sample_(sample),
          slice_(slice),
          counts_(pictureCounts(info.camera.width, info.camera.height, static_cast<uint32_t>(info.view), info.samples,
                                info.parts())),
          at_(pictureLayout(counts_, info.largestRange)) {}

    void arguments() {
        const PictureArgs a = pictureArgs(info_, at_, scratch_);
        recorder_.write(scratch_[0].buffer, scratch_[0].offset + at_.args.offset, &a, sizeof(a));
        zero(0, sizeof(PictureState));
        note("arguments");
    }

    void cameraRays() { perRay(PictureKernels::camera_rays); }

    void primaryHits(bool resumes) {
        if (bounce_ == 0) zero(offsetof(PictureState, primary), sizeof(TraceCounters));
        TraceInfo trace = traced(at_.rays, at_.hits, slice_.first, info_.primaryMode(), resumes);
        trace.counters = address(at_.state) + offsetof(PictureState, primary);
        if (counts_.counted > 0) trace.steps = from<StepCount>(at_.steps, slice_.first);
        hits(bounce_ == 0 ? PictureRays::primary : PictureRays::bounce, tracing_.primary, trace,
             {at_.trails, slice_.first, counts_.pixels});
        note(bounce_ == 0 ? "trace" : "trace bounces");
    }

    void scale() {
        zero(0, offsetof(PictureState, histogram));
        if (info_.view == View::depth) perRay(PictureKernels::depth_scale);
        for (uint32_t round = 0; round < 4 && countsSteps(info_.view); round++) {
            perRay(PictureKernels::count_histogram, round);
            pass(PictureKernels::select_count, round, 1);
        }
    }

    void shadowRays() {
        if (counts_.shadowed > 0) perRay(PictureKernels::shadow_rays);
    }

    void shadowHits(bool resumes) {
        if (counts_.shadowed == 0) return;
        if (info_.view != View::path) zero(offsetof(PictureState, shadow), sizeof(TraceCounters));
        // Where a pixel has two, the second ones come after the first ones of all.
        for (uint64_t before = 0; before < counts_.shadowed; before += counts_.pixels) {
            const auto first = static_cast<uint32_t>(before + slice_.first);
            TraceInfo trace = traced(at_.shadowRays, at_.shadowHits, first, info_.shadowMode(), resumes);
            trace.counters = address(at_.state) + offsetof(PictureState, shadow);
            hits(PictureRays::shadow, tracing_.shadow, trace, {at_.shadowTrails, first, counts_.shadowed});
        }
        note("trace shadows");
    }

    void colours() { perRay(PictureKernels::shade); }

    // The paths of the sample, whose primary hits are there.
    void paths() {
        zero(offsetof(PictureState, shadow), sizeof(TraceCounters));
        for (;;) {
            perRay(PictureKernels::path_scatter, bounce_);
            if (bounce_ == info_.settings.bounces) return;
            if (lightChoices(info_.settings) > 0) {
                shadowHits(false);
                perRay(PictureKernels::path_gather);
            }
            bounce_++;
            primaryHits(false);
        }
    }

    void pixels() { perRay(PictureKernels::tone); }

  private:
    const PictureKernels& kernels_;
    Recorder recorder_;
    const PictureTracing& tracing_;
    const PictureInfo& info_;
    const Range* scratch_;
    const uint32_t sample_;
    const RaySlice slice_;
    uint32_t bounce_ = 0;  // of paths, whose rays of all bounces are counted together
    PictureCounts counts_;
    PictureLayout at_;

    VkDeviceAddress address(const Place& p) const { return addressOf(p, scratch_); }
    // Of an array's elements from `first` on.
    template <class T>
    VkDeviceAddress from(const Place& p, uint64_t first) const {
        return address(p) + first * sizeof(T);
    }
    PicturePush push(uint32_t round) const {
        return {address(at_.args), round, sample_, slice_.first, slice_.first + slice_.count};
    }
    void pass(PictureKernels::Pass kernel, uint32_t round, uint32_t groups) {
        const Kernel& made = kernels_.of(kernel, info_);
        recorder_.dispatch(made, push(round), groups);
        note(made.name().data());
    }
    void perRay(PictureKernels::Pass kernel, uint32_t round = 0) { pass(kernel, round, ceilDiv(slice_.count, kGroup)); }
    void note(const char* pass) const {
        if (info_.onPass) info_.onPass(info_.user, pass);
    }
    void zero(size_t offset, size_t bytes) {
        recorder_.fillZero(scratch_[0].buffer, scratch_[0].offset + at_.state.offset + offset, bytes);
    }
    // The trails of rays from `first` on; those of the next tree are `ofTree` further.
    struct Trails {
        Place at;
        uint32_t first;
        uint64_t ofTree;
    };
    // Tree by tree. A ray that is unfinished in one of them goes to the next with the hit that it has.
    void hits(PictureRays rays, const Context* context, TraceInfo trace, const Trails& trails) {
        trace.hitExponent = info_.exponent;
        for (size_t tree = 0; tree < info_.trees.size(); tree++) {
            trace.tree = info_.trees[tree];
            trace.fromHits = tree > 0 && !trace.resumes;
            if (info_.trees.size() > 1 && !trace.resumes)
                trace.hitScale = tree + 1 < info_.trees.size() ? HitScale::between : HitScale::last;
            if (counts_.trails > 0) trace.trails = from<Trail>(trails.at, trails.first + tree * trails.ofTree);
            hitsInTree(rays, context, trace);
        }
    }
    void hitsInTree(PictureRays rays, const Context* context, const TraceInfo& trace) {
        if (info_.looksThrough(rays)) {
            const SurfaceTracePush all{tracePush(trace), push(bounce_)};
            recorder_.dispatch(kernels_.ofAlpha(trace.mode, info_), all, ceilDiv(trace.count, kGroup));
            return;
        }
        recorder_.barrier();
        cmdTrace(recorder_.commands(), *context, trace);
    }
    TraceInfo traced(const Place& rays, const Place& hits, uint32_t first, const TraceMode& mode, bool resumes) const {
        TraceInfo trace;
        trace.rays = from<Ray>(rays, first);
        trace.hits = from<Hit>(hits, first);
        trace.count = slice_.count;
        trace.mode = mode;
        trace.stepLimit = info_.stepLimit;
        trace.open = info_.open;
        trace.resumes = resumes;
        return trace;
    }
};

}  // namespace

PictureArgs pictureArgs(const PictureInfo& info, const PictureLayout& at, const Range* scratch) noexcept {
    PictureArgs a{};
#define CLEAVE_BIND(name, Element, Array, count) a.name = addressOf(at.name, scratch);
    CLEAVE_PICTURE_ARRAYS(CLEAVE_BIND)
#undef CLEAVE_BIND
    a.state = addressOf(at.state, scratch);
    a.bounds = info.bounds;
    a.exponent = info.exponent;
    a.triangles = info.triangles;
#define CLEAVE_BIND(name, Element, Array, part) a.name = info.surfaces.name;
    CLEAVE_SURFACE_ARRAYS(CLEAVE_BIND)
#undef CLEAVE_BIND
    a.lights = info.lights;
    a.emitters = info.emitters;
    a.albedo = info.albedo;
    a.camera = info.camera;
    a.view = static_cast<uint32_t>(info.view);
    a.count = info.camera.width * info.camera.height;
    a.samples = info.samples;
    a.exposure = info.exposure;
    a.settings = info.settings;
    a.ambientReach = info.ambientReach;
    a.parts = info.surfaces.parts;
    return a;
}

PictureKernels::PictureKernels(const PipelineHome& home, uint32_t longestRow)
    : home_(home), row_(longestRow != 0 ? longestRow : kLongestRow) {}

const PictureKernels::Variant* PictureKernels::find(std::string_view name, std::span<const uint32_t> constants) const {
    const auto found = std::find_if(variants_.begin(), variants_.end(), [&](const Variant& v) {
        return v.kernel.name() == name && std::ranges::equal(v.constants, constants);
    });
    return found == variants_.end() ? nullptr : &*found;
}

void PictureKernels::make(const char* name, size_t pushBytes, std::vector<uint32_t> constants) {
    if (find(name, constants)) return;
    Variant variant;
    if (variant.kernel.create(home_, findSpirv(renderKernels(), name), static_cast<uint32_t>(pushBytes), constants) !=
        VK_SUCCESS)
        throw Error(std::string("creating the pipeline of kernel ") + name + " failed; try another device");
    variant.constants = std::move(constants);
    variants_.push_back(std::move(variant));
}

void PictureKernels::prepare(const PictureInfo& info) {
    for (const Pass pass : passesOf(info.view)) make(kNames[pass], sizeof(PicturePush), constantsOf(pass, info));
    if (info.kept.shadows) make(kNames[shadow_rays], sizeof(PicturePush), {});
    if (info.looksThrough(PictureRays::primary))
        make(alphaKernel(info.primaryMode()), sizeof(SurfaceTracePush), alphaConstants(info.primaryMode(), info));
    if (info.looksThrough(PictureRays::shadow))
        make(alphaKernel(info.shadowMode()), sizeof(SurfaceTracePush), alphaConstants(info.shadowMode(), info));
}

// What was not prepared is a mistake of the caller, for which there is no answer.
const Kernel& PictureKernels::of(Pass pass, const PictureInfo& info) const {
    const Variant* found = find(kNames[pass], constantsOf(pass, info));
    if (!found) std::abort();
    return found->kernel;
}

const Kernel& PictureKernels::ofAlpha(const TraceMode& mode, const PictureInfo& info) const {
    const Variant* found = find(alphaKernel(mode), alphaConstants(mode, info));
    if (!found) std::abort();
    return found->kernel;
}

void cmdRenderSample(VkCommandBuffer commands, const PictureKernels& kernels, const PictureTracing& tracing,
                     const PictureInfo& info, const Range* scratch, uint32_t sample, const RaySlice& slice,
                     SampleStep step) {
    PictureRecording picture(commands, kernels, tracing, info, scratch, sample, slice);
    const bool all = step == SampleStep::all;
    if (all || step == SampleStep::primary) {
        if (sample == 0 && slice.first == 0) picture.arguments();
        picture.cameraRays();
        picture.primaryHits(false);
    }
    if (info.view == View::path) return picture.paths();
    if (step == SampleStep::primaryAgain) picture.primaryHits(true);
    if (all || step == SampleStep::shadows) {
        picture.scale();
        picture.shadowRays();
        picture.shadowHits(false);
    }
    if (step == SampleStep::shadowsAgain) picture.shadowHits(true);
    if (all || step == SampleStep::colours) picture.colours();
}

void cmdShowPicture(VkCommandBuffer commands, const PictureKernels& kernels, const PictureInfo& info,
                    const Range* scratch, uint32_t samples) {
    PictureRecording(commands, kernels, {}, info, scratch, samples, allRays(info)).pixels();
}

}  // namespace cleave
