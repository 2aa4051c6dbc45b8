#include "peers/embree.h"

#include "base/error.h"

#ifdef CLEAVE_EMBREE
#include <embree3/rtcore.h>

#include <cstring>
#include <string>

#include "base/stopwatch.h"
#include "peers/for_each_ray.h"

namespace cleave {
namespace {

constexpr uint32_t kAllRays = 0xFFFFFFFFu;

RTCRay embreeRay(const Ray& ray) {
    RTCRay r{};
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.tnear = ray.tMin;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tfar = ray.tMax;
    r.mask = kAllRays;
    return r;
}

class Embree : public Peer {
  public:
    explicit Embree(const PeerScene& scene)
        : world_(scene.world), included_(scene.set.included), threads_(scene.threads) {
        device_ = rtcNewDevice(("threads=" + std::to_string(threads_)).c_str());
        if (!device_) throw Error("Embree cannot be started here: error " + std::to_string(rtcGetDeviceError(nullptr)));
    }
    ~Embree() override {
        if (scene_) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    double build() override {
        if (scene_) rtcReleaseScene(scene_);
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        fill(geometry);
        const Stopwatch watch;
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        const double ms = watch.milliseconds();
        requireSuccess("building");
        return ms;
    }

    Traced trace(std::span<const Ray> rays, Query query) override {
        Traced traced;
        traced.hits.resize(rays.size());
        const Stopwatch watch;
        forEachRay(rays.size(), threads_, [&](size_t i) {
            if (!isValidRay(rays[i]))
                traced.hits[i] = missedHit();
            else
                traced.hits[i] = query == Query::any ? anyHit(rays[i]) : closestHit(rays[i]);
        });
        traced.ms = watch.milliseconds();
        requireSuccess("tracing");
        return traced;
    }

  private:
    std::span<const Triangle> world_;
    std::span<const uint32_t> included_;
    uint32_t threads_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;

    void requireSuccess(const std::string& what) const {
        const RTCError error = rtcGetDeviceError(device_);
        if (error != RTC_ERROR_NONE)
            throw Error(what + " with Embree: error " + std::to_string(error) + "; is there enough memory?");
    }

    // Its own buffers, which it pads as its vector loads need.
    void fill(RTCGeometry geometry) const {
        const size_t count = included_.size();
        auto* vertices = static_cast<Triangle*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), 3 * count));
        auto* indices = static_cast<uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
        if (!vertices || !indices) throw Error("Embree has no memory for the triangles; use a smaller scene");
        for (size_t i = 0; i < count; ++i) vertices[i] = world_[included_[i]];
        for (size_t i = 0; i < 3 * count; ++i) indices[i] = static_cast<uint32_t>(i);
    }

    Hit closestHit(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit asked{};
        asked.ray = embreeRay(ray);
        asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &asked);
        if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return missedHit();
        return {asked.ray.tfar, included_[asked.hit.primID], asked.hit.u, asked.hit.v};
    }

    // Embree does not tell which triangle occludes: the first stands for it.
    Hit anyHit(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay asked = embreeRay(ray);
        rtcOccluded1(scene_, &context, &asked);
        return asked.tfar < 0.0f ? Hit{ray.tMin, 0, 0.0f, 0.0f} : missedHit();
    }
};

}  // namespace

bool hasEmbree() { return true; }
std::unique_ptr<Peer> makeEmbree(const PeerScene& scene) { return std::make_unique<Embree>(scene); }

}  // namespace cleave
#else
namespace cleave {

bool hasEmbree() { return false; }
std::unique_ptr<Peer> makeEmbree(const PeerScene&) {
    throw Error("this build has no Embree; install libembree-dev and configure again");
}

}  // namespace cleave
#endif
