#include "run/renderer.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "gpu/commands.h"
#include "run/ranges.h"

namespace cleave {

DeviceMaterials::DeviceMaterials(Device& device, std::span<const uint32_t> perTriangle,
                                 std::span<const glm::vec4> colours)
    : materialOf(uploaded(device, perTriangle)), baseColours(uploaded(device, colours)) {}

namespace {

constexpr uint32_t kMostStamps = 32;

// Loads the functions that the kernels go on using.
Functions functionsOf(const Device& device) {
    Functions functions;
    if (const char* missing = functions.load(vkGetInstanceProcAddr, device.instance(), device.handle()))
        throw Error(std::string("the Vulkan driver has no function ") + missing);
    return functions;
}

}  // namespace

struct Renderer::State {
    State(Device& d, Tracer& t, const TraceLimits& l)
        : device(d),
          tracer(t),
          limits(l),
          functions(functionsOf(d)),
          kernels({&functions, d.handle(), d.pipelineCache(), nullptr}, d.longestRow()),
          commands(d, kMostStamps) {}

    Device& device;
    Tracer& tracer;
    TraceLimits limits;
    Functions functions;
    PictureKernels kernels;
    Commands commands;
    RangeBuffers scratch;  // kept from picture to picture
    PictureLayout at;
    uint32_t pixels = 0;

    template <class T>
    std::vector<T> read(const Place& place, size_t count) const {
        std::vector<T> items(count);
        scratch.buffer(place.range).read(place.offset, items.data(), count * sizeof(T));
        return items;
    }

    void reserve(const PictureInfo& info) {
        pixels = info.camera.width * info.camera.height;
        at = pictureLayout(pictureCounts(info.camera.width, info.camera.height, static_cast<uint32_t>(info.view)),
                           info.largestRange);
        if (!at.ranges.fits())
            throw Error("a picture of " + std::to_string(info.camera.width) + " x " +
                        std::to_string(info.camera.height) + " is too large for this device; make a smaller one");
        std::vector<VkDeviceSize> sizes;
        for (uint32_t i = 0; i < at.ranges.rangeCount(); i++) sizes.push_back(at.ranges.size(i));
        scratch.reserve(device, sizes);
    }

    // Runs what `record` records; what the picture's state tells then.
    template <class Record>
    PictureState run(Picture& picture, const Record& record) {
        commands.begin();
        record();
        commands.run();
        picture.ms += commands.milliseconds();
        const auto known = commands.passTimes();
        for (const PassTime& pass : known)
            if (pass.name == "trace") picture.traceMs += pass.ms;
        if (known.empty()) picture.traceMs += commands.milliseconds();
        return read<PictureState>(at.state, 1)[0];
    }
};

Renderer::Renderer(Device& device, Tracer& tracer, TraceLimits limits) {
    const Stopwatch watch;
    state_ = std::make_unique<State>(device, tracer, limits);
    setupMs_ = watch.milliseconds();
}
Renderer::~Renderer() = default;

Picture Renderer::render(const DeviceTree& tree, const DeviceTriangles& triangles, const DeviceMaterials& materials,
                         const PictureRequest& request) {
    State& s = *state_;
    PictureInfo info;
    info.tree = tree.address();
    info.triangles = triangles.triangles.address();
    info.materialOf = materials.materialOf.address();
    info.baseColours = materials.baseColours.address();
    info.camera = request.camera;
    info.view = request.view;
    info.traversal = request.traversal;
    info.test = request.test;
    info.largestRange = s.device.largestAllocation();
    info.stepLimit = s.limits.stepLimit;
    info.onPass = [](void* user, const char* pass) { static_cast<Commands*>(user)->stamp(pass); };
    info.user = &s.commands;
    const bool shadows = request.view == View::shaded;
    const PictureTracing tracing{&s.tracer.context(info.primaryMode()),
                                 shadows ? &s.tracer.context(info.shadowMode()) : nullptr};
    s.reserve(info);

    Picture picture;
    picture.width = request.camera.width;
    picture.height = request.camera.height;
    PictureState state =
        s.run(picture, [&] { cmdRender(s.commands.handle(), s.kernels, tracing, info, s.scratch.ranges()); });
    picture.invalidRays = state.primary.invalidRays;
    const auto resume = [&](PictureRays rays, TraceCounters PictureState::*counters) {
        for (uint32_t i = 1; (state.*counters).unfinishedRays > 0 && i < s.limits.mostDispatches; i++)
            state = s.run(picture, [&] {
                cmdResumePicture(s.commands.handle(), s.kernels, tracing, info, s.scratch.ranges(), rays);
            });
    };
    resume(PictureRays::primary, &PictureState::primary);
    resume(PictureRays::shadow, &PictureState::shadow);
    picture.cappedRays = state.primary.unfinishedRays + state.shadow.unfinishedRays;
    const ViewScale scale = viewScale(state.lowBits, state.highBits);
    picture.scaleLow = scale.low;
    picture.scaleHigh = scale.high;
    picture.pixels = s.read<uint32_t>(s.at.pixels, s.pixels);
    return picture;
}

std::vector<Ray> Renderer::readRays() const { return state_->read<Ray>(state_->at.rays, state_->pixels); }
std::vector<Hit> Renderer::readHits() const { return state_->read<Hit>(state_->at.hits, state_->pixels); }

}  // namespace cleave
