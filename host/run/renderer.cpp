#include "run/renderer.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/stopwatch.h"
#include "render/albedo_table.h"
#include "run/lazy_tree.h"
#include "run/ranges.h"

namespace cleave {

namespace {

template <class T>
void upload(Device& device, const std::vector<T>& items, std::optional<Buffer>& buffer, VkDeviceAddress& address) {
    buffer.reset();  // the old one need not be beside the new one
    if (!items.empty()) buffer = uploaded(device, std::span(items));
    address = buffer ? buffer->address() : 0;
}

}  // namespace

DeviceSurfaces::DeviceSurfaces(Device& device, const SurfaceData& data) {
    addresses_.parts = data.parts;
    addresses_.hasAlpha = data.hasAlpha;
    addresses_.singleSided = data.singleSided;
#define CLEAVE_UPLOAD(name, Element, Array, part) upload(device, data.name, name##_, addresses_.name);
    CLEAVE_SURFACE_ARRAYS(CLEAVE_UPLOAD)
#undef CLEAVE_UPLOAD
}

void DeviceSurfaces::move(Device& device, const SurfaceData& posed) {
    upload(device, posed.surfaceOf, surfaceOf_, addresses_.surfaceOf);
    upload(device, posed.normals, normals_, addresses_.normals);
}

void DeviceSurfaces::move(size_t first, const SurfaceData& part) {
    const auto write = [](std::optional<Buffer>& buffer, size_t at, const auto& items) {
        constexpr size_t kSize = sizeof(items[0]);
        if (!items.empty()) buffer->write(at * kSize, items.data(), items.size() * kSize);
    };
    write(surfaceOf_, first, part.surfaceOf);
    write(normals_, 3 * first, part.normals);
}

namespace {

constexpr uint32_t kMostStamps = 512;  // four for each bounce of a path

// A seed as the kernels take it, who combine it with the sample's number by exclusive or. With its bits in reverse, the
// numbers of two seeds have nothing in common as long as seeds and samples have 32 bits together; as it is, seeds 0 and
// 1 would give the same samples in another order.
uint32_t mixedSeed(uint32_t seed) {
    uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit) reversed |= (seed >> bit & 1u) << (31 - bit);
    return reversed;
}

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
    RangeBuffers scratch;                            // kept from picture to picture
    std::optional<Buffer> albedo, lights, emitters;  // of paths

    // Of the picture that was begun last.
    std::vector<VkDeviceAddress> trees;
    LazyTree* lazy = nullptr;  // that is the only one
    PictureInfo info;
    PictureTracing tracing;
    PictureLayout at;
    Picture picture;     // what is known of it so far
    uint32_t taken = 0;  // rays of the sample that is not whole yet
    PictureState lastState{};

    size_t pixels() const { return size_t{info.camera.width} * info.camera.height; }

    template <class T>
    std::vector<T> read(const Place& place, size_t count) const {
        std::vector<T> items(count);
        scratch.buffer(place.range).read(place.offset, items.data(), count * sizeof(T));
        return items;
    }

    void reserve() {
        at = pictureLayout(pictureCounts(info.camera.width, info.camera.height, static_cast<uint32_t>(info.view),
                                         info.samples, info.parts()),
                           info.largestRange);
        if (!at.ranges.fits())
            throw Error("a picture of " + std::to_string(info.camera.width) + " x " +
                        std::to_string(info.camera.height) + " is too large for this device; make a smaller one");
        std::vector<VkDeviceSize> sizes;
        for (uint32_t i = 0; i < at.ranges.rangeCount(); i++) sizes.push_back(at.ranges.size(i));
        scratch.reserve(device, sizes);
    }

    // Runs what `record` records, and adds to the picture's times.
    template <class Record>
    void run(const Record& record) {
        commands.begin();
        record();
        commands.run();
        picture.ms += commands.milliseconds();
        const auto known = commands.passTimes();
        for (const PassTime& pass : known) {
            if (pass.name == "trace") picture.traceMs += pass.ms;
            const auto same = std::ranges::find(picture.passes, pass.name, &PassTime::name);
            if (same == picture.passes.end())
                picture.passes.push_back(pass);
            else
                same->ms += pass.ms;
        }
        if (known.empty()) picture.traceMs += commands.milliseconds();
    }

    PictureState state() const { return read<PictureState>(at.state, 1)[0]; }

    template <class T>
    std::optional<Buffer> uploadedIfAny(const std::vector<T>& items) {
        if (items.empty()) return std::nullopt;
        return uploaded(device, std::span<const T>(items));
    }

    void lightPaths(const PictureRequest& request) {
        if (!albedo) albedo = uploaded(device, std::span<const SpecularAlbedo>(albedoTable()));
        lights = uploadedIfAny(request.lighting.lights);
        emitters = uploadedIfAny(request.lighting.emitterTable);
        info.albedo = albedo->address();
        info.lights = lights ? lights->address() : 0;
        info.emitters = emitters ? emitters->address() : 0;
        info.settings.sky = request.lighting.sky;
        info.settings.lightCount = static_cast<uint32_t>(request.lighting.lights.size());
        info.settings.emitters = request.lighting.emitters;
        info.settings.bounces = request.bounces;
    }

    PictureState take(const RaySlice& slice, SampleStep step) {
        run([&] {
            cmdRenderSample(commands.handle(), kernels, tracing, info, scratch.ranges(), picture.samples, slice, step);
        });
        return state();
    }

    // Lets the rays of one kind go on until all are answered; whether there was one that had to.
    bool goOn(const RaySlice& slice, SampleStep again, TraceCounters PictureState::*counters, PictureState& told) {
        uint32_t dispatches = 1;
        for (; (told.*counters).unfinishedRays > 0 && dispatches < limits.mostDispatches; dispatches++) {
            if (lazy && lazy->expandMarked()) trees[0] = lazy->address();
            told = take(slice, again);
        }
        return dispatches > 1;
    }

    // A slice of a sample, until all of its rays are answered; what the picture's state tells then.
    PictureState take(const RaySlice& slice) {
        const bool waits = lazy != nullptr;
        PictureState told = take(slice, waits ? SampleStep::primary : SampleStep::all);
        if (info.view == View::path) return told;
        bool behind = goOn(slice, SampleStep::primaryAgain, &PictureState::primary, told) || waits;
        if (behind) told = take(slice, SampleStep::shadows);
        behind |= goOn(slice, SampleStep::shadowsAgain, &PictureState::shadow, told);
        return behind ? take(slice, SampleStep::colours) : told;
    }

    // Whole strips of tiles, so that a slice is some rows of the picture.
    RaySlice nextSlice() const {
        const RaySlice all = allRays(info);
        if (hasScale(info.view) || lazy) return all;  // what waits is built together
        const uint64_t strip = uint64_t{8} * info.camera.width;
        const uint64_t most = std::max<uint64_t>(limits.batch / strip, 1) * strip;
        return {taken, static_cast<uint32_t>(std::min<uint64_t>(most, all.count - taken))};
    }
};

Renderer::Renderer(Device& device, Tracer& tracer, TraceLimits limits) {
    const Stopwatch watch;
    state_ = std::make_unique<State>(device, tracer, limits);
    setupMs_ = watch.milliseconds();
}
Renderer::~Renderer() = default;

Picture Renderer::render(const Forest& forest, const DeviceTriangles& triangles, const DeviceSurfaces& surfaces,
                         const PictureRequest& request) {
    begin(forest, triangles, surfaces, request);
    return finish(request);
}

Picture Renderer::render(const DeviceInstances& instances, const PictureRequest& request) {
    State& s = *state_;
    s.trees = {instances.address()};
    s.lazy = nullptr;
    PictureInfo scene;
    scene.instances = true;
    scene.bounds = instances.bounds;
    scene.exponent = instances.exponent;
    begin(scene, request);
    return finish(request);
}

Picture Renderer::finish(const PictureRequest& request) {
    while (samplesTaken() < request.samples) {
        while (!takeSlice()) continue;
        if (request.goesOn && !request.goesOn(samplesTaken())) break;
    }
    return show();
}

void Renderer::begin(const Forest& forest, const DeviceTriangles& triangles, const DeviceSurfaces& surfaces,
                     const PictureRequest& request) {
    state_->trees.clear();
    for (const DeviceTree* tree : forest.trees) state_->trees.push_back(tree->address());
    state_->lazy = forest.lazy;
    PictureInfo scene;
    scene.bounds = forest.bounds();
    scene.exponent = forest.exponent();
    scene.triangles = triangles.triangles.address();
    scene.single = forest.isSingle();
    if (forest.lazy) scene.open = forest.lazy->open();
    scene.surfaces = surfaces.addresses();
    begin(scene, request);
}

void Renderer::begin(const PictureInfo& scene, const PictureRequest& request) {
    State& s = *state_;
    PictureInfo& info = s.info = scene;
    info.trees = s.trees;
    info.camera = request.camera;
    info.view = request.view;
    info.samples = request.samples;
    info.exposure = request.exposure;
    info.settings.seed = mixedSeed(request.seed);
    info.ambientReach = request.ambientReach;
    if (request.view == View::path) s.lightPaths(request);
    info.traversal = request.traversal;
    info.test = request.test;
    info.kept = request.kept;
    info.largestRange = s.device.largestAllocation();
    info.stepLimit = s.limits.stepLimit;
    info.onPass = [](void* user, const char* pass) { static_cast<Commands*>(user)->stamp(pass); };
    info.user = &s.commands;
    const bool shadows = request.view == View::path ? lightChoices(info.settings) > 0 : info.parts().shadows;
    s.tracing = {};
    if (!info.looksThrough(PictureRays::primary) ||
        (info.view == View::path && !info.looksThrough(PictureRays::bounce)))
        s.tracing.primary = &s.tracer.context(info.primaryMode());
    if (shadows && !info.looksThrough(PictureRays::shadow)) s.tracing.shadow = &s.tracer.context(info.shadowMode());
    const Stopwatch setup;
    s.kernels.prepare(info);
    setupMs_ += setup.milliseconds();
    s.reserve();
    s.picture = {};
    s.picture.width = request.camera.width;
    s.picture.height = request.camera.height;
    s.taken = 0;
    s.lastState = {};
}

bool Renderer::takeSlice() {
    State& s = *state_;
    const RaySlice slice = s.nextSlice();
    s.lastState = s.take(slice);
    s.picture.invalidRays += s.lastState.primary.invalidRays;
    s.picture.cappedRays += s.lastState.primary.unfinishedRays + s.lastState.shadow.unfinishedRays;
    s.taken += slice.count;
    if (s.taken < s.pixels()) return false;
    s.taken = 0;
    s.picture.samples++;
    return true;
}

uint32_t Renderer::samplesTaken() const { return state_->picture.samples; }
uint32_t Renderer::rowsTaken() const { return state_->taken / state_->info.camera.width; }

Picture Renderer::show() {
    State& s = *state_;
    const uint32_t samples = std::max(s.picture.samples, 1u);
    s.run([&] { cmdShowPicture(s.commands.handle(), s.kernels, s.info, s.scratch.ranges(), samples); });
    Picture picture = s.picture;
    const ViewScale scale = viewScale(s.lastState.lowBits, s.lastState.highBits);
    picture.scaleLow = scale.low;
    picture.scaleHigh = scale.high;
    picture.pixels = s.read<uint32_t>(s.at.pixels, s.pixels());
    return picture;
}

std::vector<Ray> Renderer::readRays() const { return state_->read<Ray>(state_->at.rays, state_->pixels()); }
std::vector<Hit> Renderer::readHits() const { return state_->read<Hit>(state_->at.hits, state_->pixels()); }

std::vector<vec3> Renderer::readRadiance() const {
    const ImageCamera& camera = state_->info.camera;
    const bool ofLight = isOfLight(static_cast<uint32_t>(state_->info.view));
    const std::vector<vec3> sums = state_->read<vec3>(state_->at.radiance, state_->pixels());
    const std::vector<vec4> unlit = state_->read<vec4>(state_->at.unlit, ofLight ? sums.size() : 0);
    std::vector<vec3> means(sums.size());
    for (uint32_t i = 0; i < sums.size(); i++) {
        const vec3 sum = unlit.empty() ? sums[i] : sums[i] + vec3(unlit[i]);
        means[pixelOf(i, camera.width, camera.height)] = sum / static_cast<float>(state_->picture.samples);
    }
    return means;
}

}  // namespace cleave
