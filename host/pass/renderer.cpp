#include "renderer.h"

#include <algorithm>
#include <cmath>

#include "device_arrays.h"
#include "render_passes.h"

namespace cleave {

struct Renderer::Impl {
    Impl(Context& c, Tracer& t) : context(c), tracer(t), passes(c) {}
    Context& context;
    Tracer& tracer;
    RenderPasses passes;

    template <class T>
    Buffer uploaded(std::span<const T> items) {
        Buffer b(context, items.size_bytes());
        b.upload(items);
        return b;
    }
};

namespace {

// Where a ray that enters a box leaves it.
double exitOf(const Ray& ray, const glm::dvec3& lo, const glm::dvec3& hi) {
    double exit = INFINITY;
    for (int k = 0; k < 3; k++) {
        if (ray.direction[k] == 0.0f) continue;
        const double wall = ray.direction[k] > 0.0f ? hi[k] : lo[k];
        exit = std::min(exit, (wall - double(ray.origin[k])) / double(ray.direction[k]));
    }
    return exit;
}

// From the nearest hit to where the scene's box ends behind the hits. The farthest hit would not do: it lies where a
// surface turns away, and the whole scale would hang on one pixel there.
void setDepthScale(Picture& picture, const DeviceTree& tree, std::span<const Ray> rays) {
    const double unit = std::ldexp(1.0, tree.exponent);
    const glm::dvec3 lo = glm::dvec3(tree.bounds.lo) * unit;
    const glm::dvec3 hi = glm::dvec3(tree.bounds.hi) * unit;
    double low = INFINITY;
    double high = 0.0;
    for (size_t i = 0; i < rays.size(); i++) {
        const Hit& hit = picture.primary.hits[i];
        if (hit.prim == kNone) continue;
        low = std::min(low, static_cast<double>(hit.t));
        high = std::max(high, std::max(static_cast<double>(hit.t), exitOf(rays[i], lo, hi)));
    }
    if (!(low < high)) return;  // nothing was hit
    picture.scaleLow = static_cast<float>(low);
    picture.scaleHigh = static_cast<float>(high);
}

// From 0 to what all but 1 in 200 pixels stay below: a few rays along a wall would leave the rest in the dark.
void setCountScale(Picture& picture, View view) {
    std::vector<uint32_t> counts;
    for (size_t i = 0; i < picture.primary.steps.size(); i++) {
        const StepCount& s = picture.primary.steps[i];
        if (view == View::steps)
            counts.push_back(s.inner + s.leaves);
        else if (picture.primary.hits[i].prim != kNone)
            counts.push_back(s.hitLeaf);
    }
    if (counts.empty()) return;
    const auto nth = counts.begin() + static_cast<std::ptrdiff_t>((counts.size() - 1) * 199 / 200);
    std::nth_element(counts.begin(), nth, counts.end());
    picture.scaleHigh = static_cast<float>(*nth);
}

float diagonal(const DeviceTree& tree) {
    const glm::dvec3 e = glm::dvec3(tree.bounds.hi) - glm::dvec3(tree.bounds.lo);
    return static_cast<float>(std::ldexp(glm::length(e), tree.exponent));
}

}  // namespace

Renderer::Renderer(Context& context, Tracer& tracer) : impl_(std::make_unique<Impl>(context, tracer)) {}
Renderer::~Renderer() = default;

Picture Renderer::render(const DeviceTree& tree, const Scene& scene, const PosedScene& posed, std::span<const Ray> rays, uint32_t width,
                         uint32_t height, View view, TraceMode mode) {
    Impl& d = *impl_;
    Picture picture;
    picture.width = width;
    picture.height = height;
    mode.countSteps = view == View::steps || view == View::leaves;
    picture.primary = d.tracer.trace(tree, rays, Query::closest, mode);
    picture.ms = picture.primary.ms;
    if (mode.countSteps) setCountScale(picture, view);
    if (view == View::depth) setDepthScale(picture, tree, rays);

    std::vector<glm::vec4> colours;
    for (const gltf::Material& m : scene.materials) colours.push_back(m.baseColour);
    const Buffer rayBuffer = d.uploaded(rays);
    const Buffer hits = d.uploaded(std::span<const Hit>(picture.primary.hits));
    const Buffer steps = d.uploaded(std::span<const StepCount>(picture.primary.steps));
    const Buffer shadowRays(d.context, rays.size_bytes());
    Buffer shadowHits(d.context, rays.size() * sizeof(Hit));
    const Buffer materialOf = d.uploaded(std::span<const uint32_t>(posed.materialOf));
    const Buffer baseColours = d.uploaded(std::span<const glm::vec4>(colours));
    const Buffer pixels(d.context, rays.size() * sizeof(uint32_t));
    const ShadePush push{rayBuffer.address(),
                         hits.address(),
                         steps.address(),
                         shadowRays.address(),
                         shadowHits.address(),
                         tree.triangles->triangles.address(),
                         materialOf.address(),
                         baseColours.address(),
                         pixels.address(),
                         1e-4f * diagonal(tree),
                         picture.scaleLow,
                         picture.scaleHigh,
                         static_cast<uint32_t>(view),
                         static_cast<uint32_t>(rays.size())};
    if (view == View::shaded) {
        Recorder recorder(d.context);
        d.passes.shadowRays(recorder, push);
        picture.ms += recorder.submit();
        mode.countSteps = false;
        const Tracer::Result shadows = d.tracer.trace(tree, shadowRays.download<Ray>(rays.size()), Query::any, mode);
        picture.ms += shadows.ms;
        shadowHits.upload(std::span<const Hit>(shadows.hits));
    }
    Recorder recorder(d.context);
    d.passes.shade(recorder, push);
    picture.ms += recorder.submit();
    picture.pixels = pixels.download<uint32_t>(rays.size());
    return picture;
}

}  // namespace cleave
