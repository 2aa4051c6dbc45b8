#include "view/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <span>

#include "app/device_kit.h"
#include "app/lighting.h"
#include "app/surfaces.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "figures/legend.h"
#include "judge/oracle.h"
#include "view/give_way.h"

namespace cleave {
namespace {

constexpr size_t kRaysPerSlice = size_t{1} << 15;  // between these, the painter looks whether it is asked for more
constexpr double kMovingMs = 33.0;                 // that a picture may take while something moves
constexpr double kShowMs = 120.0;                  // between pictures that get better
constexpr std::array<double, 7> kScales = {1.0, 2.0 / 3, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 6, 1.0 / 8};
constexpr double kSmallest = 1.0 / 4;  // but of paths
constexpr uint32_t kMovingBounces = 2;
constexpr uint32_t kMostCompared = 320;  // pixels in a row of a comparison

uint32_t scaled(uint32_t length, double scale) {
    return std::max(1u, static_cast<uint32_t>(std::lround(length * scale)));
}

// The picture stretched to another size, each pixel that of the nearest.
std::vector<uint32_t> stretched(const Painted& from, uint32_t width, uint32_t height) {
    std::vector<uint32_t> pixels(size_t{width} * height);
    for (uint32_t y = 0; y < height; ++y) {
        const size_t row = size_t{y} * from.height / height * from.width;
        for (uint32_t x = 0; x < width; ++x)
            pixels[size_t{y} * width + x] = from.pixels[row + size_t{x} * from.width / width];
    }
    return pixels;
}

// How a triangle looks in a comparison: bluish, brighter where it faces the eye, and a little else than its neighbours.
// Nothing there is dark.
uint32_t colourOf(std::span<const Triangle> triangles, uint32_t prim, const Ray& ray) {
    if (prim == kNone) return 0xFF181818u;
    const Triangle& t = triangles[prim];
    const glm::dvec3 normal = glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
    const double length = glm::length(normal);
    const double facing =
        length > 0.0 ? std::abs(glm::dot(normal / length, glm::normalize(glm::dvec3(ray.direction)))) : 0.5;
    const double own = 0.06 * std::fmod(prim * 0.6180339887498949, 1.0);  // far from that of the next numbers
    const auto part = [&](double most) { return static_cast<uint32_t>(most * (0.30 + 0.60 * facing + own)); };
    return 0xFF000000u | part(190.0) | part(220.0) << 8 | part(255.0) << 16;
}
constexpr uint32_t kRed = 0xFF2020FFu;

}  // namespace

// What lives on the thread: the device, what is uploaded, the picture at work.
struct Painter::Easel {
    explicit Easel(Painter& p) : painter(p), kit(p.device_) {}

    Painter& painter;
    DeviceKit kit;
    std::unique_ptr<Renderer> renderer;
    std::shared_ptr<const Staged> there;  // what is uploaded
    std::unique_ptr<DeviceTriangles> triangles;
    std::vector<std::shared_ptr<DeviceTree>> trees;
    std::unique_ptr<DeviceSurfaces> surfaces;
    std::unique_ptr<Reference> reference;
    std::shared_ptr<const StagedPose> referenceOf;
    std::shared_ptr<const Painted> shown;
    std::array<double, 8> msPerPixel{};  // of a sample of each view, as it was last; 0: not known

    void upload(const std::shared_ptr<const Staged>& staged) {
        if (there == staged) return;
        uploadTriangles(*staged);
        uploadTrees(*staged);
        there = staged;
    }

    // Where only what moves differs from what is there, nothing else is sent.
    void uploadTriangles(const Staged& staged) {
        Device& device = kit.device();
        const StagedPose& pose = *staged.geometry;
        const bool isThere = there && there->geometry == staged.geometry;
        const bool staysPut = triangles && there && there->geometry->still == pose.still;
        if (!staysPut) {
            triangles.reset();
            triangles = std::make_unique<DeviceTriangles>(device, pose.posed.triangles);
        } else if (!isThere) {
            for (const TriangleRun& run : pose.moving) triangles->move(pose.posed.triangles, run.first, run.count);
        }
        const bool isNew = !surfaces || !there || there->surfaces != staged.surfaces;
        if (isNew) {
            surfaces.reset();
            surfaces = std::make_unique<DeviceSurfaces>(device, *staged.surfaces);
        }
        if (isNew || !staysPut) {
            surfaces->move(device, posedSurfaces(pose.posed, Needs()));
        } else if (!isThere) {
            for (const TriangleRun& run : pose.moving)
                surfaces->move(run.first, posedSurfaces(pose.posed, run, Needs()));
        }
    }

    // Those that are there stay.
    void uploadTrees(const Staged& staged) {
        const auto isThere = [&](size_t i) {
            return there && i < there->trees.size() && i < staged.trees.size() &&
                   there->trees[i].tree == staged.trees[i].tree;
        };
        for (size_t i = 0; i < trees.size(); ++i)
            if (!isThere(i)) trees[i].reset();  // the old ones need not be beside the new ones
        trees.resize(staged.trees.size());
        for (size_t i = 0; i < trees.size(); ++i) {
            if (trees[i]) continue;
            const StagedTree& tree = staged.trees[i];
            const std::span<const uint32_t> list = tree.list ? std::span(*tree.list) : std::span<const uint32_t>();
            trees[i] = uploadTree(kit.device(), *tree.set, *tree.tree, list);
        }
    }

    Forest forest() const {
        std::vector<const DeviceTree*> all;
        for (const auto& tree : trees) all.push_back(tree.get());
        return Forest(std::move(all));
    }

    double& costOf(View view) { return msPerPixel.at(static_cast<size_t>(view)); }

    // As large as can be painted at once, of pictures that were painted before.
    double scaleOf(const PaintWish& wish) {
        if (!wish.moves) return 1.0;
        const double known = costOf(wish.view);
        const double smallest = wish.view == View::path ? kScales.back() : kSmallest;
        for (const double scale : kScales) {
            const double pixels = scale * scale * wish.width * wish.height;
            if (scale <= smallest || (known > 0.0 && known * pixels <= kMovingMs)) return scale;
        }
        return smallest;
    }

    PictureRequest requestOf(const PaintWish& wish, double scale) const {
        PictureRequest request;
        request.camera = imageCamera(wish.camera, scaled(wish.width, scale), scaled(wish.height, scale), infinity());
        request.view = wish.view;
        request.samples = wish.moves ? 1 : wish.samples;
        request.bounces = wish.moves ? std::min(wish.bounces, kMovingBounces) : wish.bounces;
        request.exposure = wish.exposure;
        request.ambientReach = ambientReachOf(wish.staged->scene->restBounds);
        if (wish.view == View::path) request.lighting = wish.staged->geometry->lighting;
        request.traversal = wish.traversal;
        request.test = wish.test;
        return request;
    }

    std::shared_ptr<Painted> begun(const PaintWish& wish, const Picture& picture) const {
        auto painted = std::make_shared<Painted>();
        painted->number = wish.number;
        painted->staged = wish.staged;
        painted->camera = wish.camera;
        painted->view = wish.view;
        painted->width = picture.width;
        painted->height = picture.height;
        painted->pixels = picture.pixels;
        painted->samples = picture.samples;
        painted->scaleLow = picture.scaleLow;
        painted->scaleHigh = picture.scaleHigh;
        if (picture.traceMs > 0.0)
            painted->mraysPerSecond = picture.samples * 1e-3 * picture.width * picture.height / picture.traceMs;
        return painted;
    }

    void show(const std::shared_ptr<Painted>& painted, const Stopwatch& watch) {
        painted->ms = watch.milliseconds();
        shown = painted;
        painter.publish(painted);
    }

    // Rows that are not there yet are the picture's before.
    void showPart(const PaintWish& wish, const PictureRequest& request, const Stopwatch& watch) {
        const Picture part = renderer->show();
        auto painted = begun(wish, part);
        painted->of = request.samples;
        if (shown) {
            const std::vector<uint32_t> before = stretched(*shown, part.width, part.height);
            const auto rows = static_cast<ptrdiff_t>(size_t{renderer->rowsTaken()} * part.width);
            std::copy(before.begin() + rows, before.end(), painted->pixels.begin() + rows);
        }
        show(painted, watch);
    }

    // False: something else is asked for.
    bool paint(const PaintWish& wish) {
        const Stopwatch watch;
        upload(wish.staged);
        if (wish.compares) return compare(wish, watch);
        if (!renderer)
            renderer = std::make_unique<Renderer>(kit.device(), kit.tracer(), TraceLimits{.batch = kRaysPerSlice});
        const double scale = scaleOf(wish);
        const PictureRequest request = requestOf(wish, scale);
        renderer->begin(forest(), *triangles, *surfaces, request);
        const Stopwatch painting;  // without what was compiled
        double shownAt = 0.0;
        while (renderer->samplesTaken() < request.samples) {
            const bool whole = renderer->takeSlice();
            const double now = painting.milliseconds();
            if (whole && renderer->samplesTaken() == 1)
                costOf(wish.view) = now / (double{1} * request.camera.width * request.camera.height);
            const bool isDone = renderer->samplesTaken() == request.samples;
            if (!wish.moves && !isDone && painter.isAskedForMore()) return false;
            if (isDone || (whole && (renderer->samplesTaken() == 1 || now - shownAt > kShowMs))) {
                Picture picture = renderer->show();
                if (countsSteps(wish.view) && !wish.moves) drawLegend(picture);
                auto painted = begun(wish, picture);
                painted->of = request.samples;
                painted->isDone = isDone && !wish.moves;
                painted->moves = wish.moves;
                show(painted, watch);
                shownAt = painting.milliseconds();
            } else if (!whole && renderer->samplesTaken() == 0 && !wish.moves && now - shownAt > kShowMs) {
                showPart(wish, request, watch);
                shownAt = painting.milliseconds();
            }
        }
        if (!wish.moves && !painter.isAskedForMore()) countWork(wish);
        return true;
    }

    // Adds to the picture what a few of its rays do on their way.
    void countWork(const PaintWish& wish) {
        constexpr uint32_t kWidth = 64, kHeight = 36;
        const ImageCamera camera = imageCamera(wish.camera, kWidth, kHeight, infinity());
        std::vector<Ray> rays;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i)
            rays.push_back(imageRay(camera, i % kWidth + 0.5, i / kWidth + 0.5));
        const Tracer::Result traced =
            kit.tracer().trace(forest(), rays, {Query::closest, wish.traversal, wish.test, true});
        auto painted = std::make_shared<Painted>(*shown);
        painted->work = workOf(traced.steps, kit.device().subgroupSize());
        shown = painted;
        painter.publish(painted);
    }

    // Left ours, right the reference's answer to the same rays; red where they differ.
    bool compare(const PaintWish& wish, const Stopwatch& watch) {
        if (!reference || referenceOf != wish.staged->geometry) {
            reference.reset();
            referenceOf = wish.staged->geometry;
            reference = std::make_unique<Reference>(referenceOf->posed.triangles,
                                                    makeTriangleSet(referenceOf->posed.triangles).included);
        }
        const uint32_t width = std::min(kMostCompared, std::max(1u, wish.width / 2));
        const uint32_t height = std::max(1u, static_cast<uint32_t>(uint64_t{width} * 2 * wish.height / wish.width));
        // Half of the window each: the middle of the view.
        const ImageCamera camera = imageCamera(wish.camera, width, height, infinity());
        std::vector<Ray> rays;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) rays.push_back(imageRay(camera, x + 0.5, y + 0.5));
        const std::vector<Hit> hits =
            kit.tracer().trace(forest(), rays, {Query::closest, wish.traversal, wish.test, false}).hits;
        Picture blank;
        blank.width = 2 * width;
        blank.height = height;
        blank.pixels.assign(size_t{2} * width * height, 0xFF404040u);
        const std::shared_ptr<Painted> painted = begun(wish, blank);
        painted->of = 1;
        Comparison told;
        const std::vector<Triangle>& world = wish.staged->geometry->posed.triangles;
        double shownAt = 0.0;
        for (uint32_t y = 0; y < height; ++y) {
            for (uint32_t x = 0; x < width; ++x) {
                const size_t i = size_t{y} * width + x;
                const Reference::Judgement j = reference->judge(rays[i], hits[i], Query::closest);
                const bool differs = j.verdict == Reference::Verdict::mismatch;
                ++told.rays;
                told.mismatches += differs ? 1 : 0;
                told.undecided += j.verdict == Reference::Verdict::undecided ? 1 : 0;
                const size_t at = size_t{y} * 2 * width + x;
                painted->pixels[at] = differs ? kRed : colourOf(world, hits[i].prim, rays[i]);
                const bool asOurs = j.fault == Reference::Fault::none;
                painted->pixels[at + width] =
                    differs ? kRed : colourOf(world, asOurs ? hits[i].prim : j.referencePrim, rays[i]);
            }
            if (painter.isAskedForMore()) return false;
            if (y + 1 < height && watch.milliseconds() - shownAt < kShowMs) continue;
            painted->comparison = told;
            painted->samples = painted->isDone = y + 1 == height;
            show(std::make_shared<Painted>(*painted), watch);
            shownAt = watch.milliseconds();
        }
        return true;
    }

    Picked shoot(uint64_t number, const Ray& ray) {
        Picked picked{number, {}, false};
        if (trees.empty()) return picked;
        const Hit hit = kit.tracer().trace(forest(), std::span(&ray, 1)).hits.front();
        picked.hits = hit.prim != kNone;
        if (picked.hits) picked.point = glm::dvec3(ray.origin) + double{hit.t} * glm::dvec3(ray.direction);
        return picked;
    }
};

Painter::Painter(std::string device, std::function<void()> wake)
    : device_(std::move(device)), wake_(std::move(wake)), thread_([this] { run(); }) {}

Painter::~Painter() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void Painter::ask(const PaintWish& wish) {
    {
        const std::scoped_lock lock(mutex_);
        wish_ = wish;
    }
    asked_.notify_one();
}

void Painter::pick(uint64_t number, const Ray& ray) {
    {
        const std::scoped_lock lock(mutex_);
        pick_ = {number, ray};
    }
    asked_.notify_one();
}

std::shared_ptr<const Painted> Painter::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(painted_, nullptr);
}

std::optional<Picked> Painter::takePicked() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(picked_, std::nullopt);
}

std::optional<std::string> Painter::takeError() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(error_, std::nullopt);
}

uint64_t Painter::deviceBytes() const {
    const std::scoped_lock lock(mutex_);
    return deviceBytes_;
}

bool Painter::isAskedForMore() const {
    const std::scoped_lock lock(mutex_);
    return wish_.has_value() || pick_.has_value() || ends_;
}

void Painter::publish(std::shared_ptr<const Painted> painted) {
    {
        const std::scoped_lock lock(mutex_);
        painted_ = std::move(painted);
    }
    wake_();
}

// A device that was lost, or is out of memory, is opened anew with the next wish.
void Painter::run() {
    giveWay(5);
    std::unique_ptr<Easel> easel;
    std::optional<PaintWish> unfinished;
    for (;;) {
        std::optional<PaintWish> wish;
        std::optional<std::pair<uint64_t, Ray>> pick;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [&] { return wish_ || pick_ || unfinished || ends_; });
            if (ends_) break;
            wish.swap(wish_);
            pick.swap(pick_);
        }
        if (!wish) wish = unfinished;  // a pick came between
        unfinished.reset();
        std::optional<std::string> error;
        try {
            if (!easel) easel = std::make_unique<Easel>(*this);
            if (pick) {
                const Picked picked = easel->shoot(pick->first, pick->second);
                const std::scoped_lock lock(mutex_);
                picked_ = picked;
            }
            if (wish && !easel->paint(*wish)) unfinished = wish;
        } catch (const std::bad_alloc&) {
            error = "out of memory, on this machine, for this picture";
        } catch (const std::exception& thrown) {
            error = thrown.what();
        }
        if (error) easel.reset();
        {
            const std::scoped_lock lock(mutex_);
            if (error) error_ = error;
            if (error && pick) picked_ = Picked{pick->first, {}, false};
            deviceBytes_ = easel && easel->kit.isOpen() ? easel->kit.device().memoryInUse() : 0;
        }
        wake_();
    }
}

}  // namespace cleave
