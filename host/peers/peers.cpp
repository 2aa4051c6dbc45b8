#include "peers/peers.h"

#include <cmath>

#include "peers/embree.h"
#include "peers/ray_pipeline.h"
#include "peers/ray_query.h"
#include "peers/stack_walk.h"

namespace cleave {
namespace {

constexpr double kRelativeT = 1e-4;

bool differs(const Hit& ours, const Hit& theirs, Query query) {
    const bool hit = ours.prim != kNone;
    if (hit != (theirs.prim != kNone)) return true;
    if (!hit || query == Query::any) return false;
    return !(std::fabs(double{theirs.t} - double{ours.t}) <= kRelativeT * double{ours.t});
}

}  // namespace

std::vector<PeerOffer> peersOn(const Device& device) {
    const RayTracing has = device.rayTracing();
    // A driver that runs on the CPU keeps the triangles' order in its structures, and those of files are poor ones.
    const bool onCpu = device.properties().deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    std::vector<PeerOffer> offers;
    for (const TriangleOrder order : {TriangleOrder::file, TriangleOrder::morton}) {
        const bool isSlow = onCpu && order == TriangleOrder::file;
        offers.push_back({"ray-query", order, has.query ? "" : "no VK_KHR_ray_query is open on this device", isSlow,
                          [order](Device& d, const PeerScene& scene) { return makeRayQuery(d, scene, order); }});
        offers.push_back({"ray-tracing-pipeline", order,
                          has.pipeline ? "" : "no VK_KHR_ray_tracing_pipeline is open on this device", isSlow,
                          [order](Device& d, const PeerScene& scene) { return makeRayPipeline(d, scene, order); }});
    }
    offers.push_back({"embree", TriangleOrder::file,
                      hasEmbree() ? "" : "this build has no Embree; install libembree-dev and configure again", false,
                      [](Device&, const PeerScene& scene) { return makeEmbree(scene); }});
    offers.push_back({"stack-walk-c++", TriangleOrder::file, "", false,
                      [](Device&, const PeerScene& scene) { return makeStackWalk(scene); }});
    return offers;
}

uint64_t disagreements(std::span<const Hit> ours, std::span<const Hit> theirs, Query query) {
    uint64_t count = 0;
    for (size_t i = 0; i < ours.size(); ++i) count += differs(ours[i], theirs[i], query);
    return count;
}

}  // namespace cleave
