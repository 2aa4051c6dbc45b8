#include "peers/driver_peer.h"

#include "base/warm_up.h"

namespace cleave {

DriverPeer::DriverPeer(Device& device, const PeerScene& scene, TriangleOrder order)
    : device_(device), scene_(device, scene.world, numbersInOrder(scene.set, order)), commands_(device) {}

DriverPeer::Placed DriverPeer::placed(std::span<const Ray> rays) {
    Placed p{uploaded(device_, rays), Buffer(device_, rays.size() * sizeof(Hit)), {}};
    p.push.scene = scene_.address();
    p.push.rays = p.rays.address();
    p.push.hits = p.hits.address();
    p.push.rayCount = static_cast<uint32_t>(rays.size());
    return p;
}

double DriverPeer::run(const PeerTracePush& push, Query query) {
    commands_.begin();
    waitForAll(commands_.handle());
    record(commands_.handle(), push, query);
    waitForAll(commands_.handle());
    commands_.run();
    return commands_.milliseconds();
}

Peer::Traced DriverPeer::trace(std::span<const Ray> rays, Query query) {
    prepare(query);
    const Placed at = placed(rays);
    Traced traced;
    traced.ms = run(at.push, query);
    traced.hits = at.hits.download<Hit>(rays.size());
    for (Hit& hit : traced.hits)
        if (hit.prim != kNone) hit.prim = scene_.number(hit.prim);
    return traced;
}

std::vector<double> DriverPeer::time(std::span<const Ray> rays, Query query, uint32_t runs) {
    prepare(query);
    const Placed at = placed(rays);
    warmUp([&] { run(at.push, query); });
    std::vector<double> ms;
    for (uint32_t i = 0; i < runs; ++i) ms.push_back(run(at.push, query));
    return ms;
}

}  // namespace cleave
