#include "peers/ray_query.h"

#include <array>

#include "gpu/check.h"
#include "peers/driver_peer.h"
#include "record/recorder.h"

namespace cleave {
namespace {

class RayQuery : public DriverPeer {
  public:
    RayQuery(Device& device, const PeerScene& scene, TriangleOrder order) : DriverPeer(device, scene, order) {
        functions_.load(vkGetInstanceProcAddr, device.instance(), device.handle());
    }

  private:
    Functions functions_;
    std::array<Kernel, 2> kernels_;  // closest hits, any hits

    Kernel& kernelOf(Query query) { return kernels_[query == Query::any ? 1 : 0]; }

    void prepare(Query query) override {
        if (kernelOf(query).pipeline()) return;
        const uint32_t anyHit = query == Query::any ? 1 : 0;
        const PipelineHome home{&functions_, device().handle(), device().pipelineCache(), nullptr};
        check(kernelOf(query).create(home, findSpirv(peerKernels(), "ray_query"), sizeof(PeerTracePush), {&anyHit, 1}),
              "creating the pipeline of kernel ray_query");
    }

    void record(VkCommandBuffer commands, const PeerTracePush& push, Query query) override {
        Recorder(functions_, commands).dispatch(kernelOf(query), push, ceilDiv(push.rayCount, kGroup));
    }
};

}  // namespace

std::unique_ptr<Peer> makeRayQuery(Device& device, const PeerScene& scene, TriangleOrder order) {
    return std::make_unique<RayQuery>(device, scene, order);
}

}  // namespace cleave
