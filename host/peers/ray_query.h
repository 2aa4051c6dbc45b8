// VK_KHR_ray_query: the driver's structures, asked from a compute kernel.
#pragma once

#include <memory>

#include "gpu/device.h"
#include "peers/peer.h"
#include "peers/triangle_order.h"

namespace cleave {

// The device is open with rayTracing().query; the scene has triangles that rays can hit.
std::unique_ptr<Peer> makeRayQuery(Device& device, const PeerScene& scene, TriangleOrder order);

}  // namespace cleave
