// VK_KHR_ray_tracing_pipeline: the driver's structures, asked from a ray-generation shader.
#pragma once

#include <memory>

#include "gpu/device.h"
#include "peers/peer.h"
#include "peers/triangle_order.h"

namespace cleave {

// The device is open with rayTracing().pipeline; the scene has triangles that rays can hit.
std::unique_ptr<Peer> makeRayPipeline(Device& device, const PeerScene& scene, TriangleOrder order);

}  // namespace cleave
