// What the two ways share to let the driver answer rays: its acceleration structures, and rays and hits on the device.
#pragma once

#include "peers/driver_scene.h"
#include "peers/peer.h"
#include "peers/triangle_order.h"
#include "record/spirv.h"
#include "shared/peer_trace.h"

namespace cleave {

// The kernels of this room.
std::span<const Spirv> peerKernels() noexcept;

class DriverPeer : public Peer {
  public:
    DriverPeer(Device& device, const PeerScene& scene, TriangleOrder order);

    double build() override { return scene_.build(); }
    // Milliseconds on the device, rays and hits being there.
    Traced trace(std::span<const Ray> rays, Query query) override;
    // After a warm-up (base/warm_up.h), with rays and hits staying on the device.
    std::vector<double> time(std::span<const Ray> rays, Query query, uint32_t runs) override;

  protected:
    Device& device() const { return device_; }
    // Makes pipelines, where that was not done before; records a query of all rays.
    virtual void prepare(Query query) = 0;
    virtual void record(VkCommandBuffer commands, const PeerTracePush& push, Query query) = 0;

  private:
    Device& device_;
    DriverScene scene_;
    Commands commands_;

    // Rays and hits of a query.
    struct Placed {
        Buffer rays, hits;
        PeerTracePush push;
    };
    Placed placed(std::span<const Ray> rays);
    double run(const PeerTracePush& push, Query query);  // milliseconds
};

}  // namespace cleave
