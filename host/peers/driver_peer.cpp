#include "peers/driver_peer.h"

namespace cleave {

DriverPeer::DriverPeer(Device& device, const PeerScene& scene, TriangleOrder order)
    : device_(device), scene_(device, scene.world, numbersInOrder(scene.set, order)), commands_(device) {}

Peer::Traced DriverPeer::trace(std::span<const Ray> rays, Query query) {
    prepare(query);
    const Buffer rayBuffer = uploaded(device_, rays);
    const Buffer hitBuffer(device_, rays.size() * sizeof(Hit));
    PeerTracePush push{};
    push.scene = scene_.address();
    push.rays = rayBuffer.address();
    push.hits = hitBuffer.address();
    push.rayCount = static_cast<uint32_t>(rays.size());
    commands_.begin();
    waitForAll(commands_.handle());
    record(commands_.handle(), push, query);
    waitForAll(commands_.handle());
    commands_.run();
    Traced traced{hitBuffer.download<Hit>(rays.size()), commands_.milliseconds()};
    for (Hit& hit : traced.hits)
        if (hit.prim != kNone) hit.prim = scene_.number(hit.prim);
    return traced;
}

}  // namespace cleave
