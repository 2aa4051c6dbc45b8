// What DeviceTriangles and DeviceTree are made of. For the rooms gpu and pass only.
#pragma once

#include "gpu/buffer.h"
#include "pass/device_tree.h"

namespace cleave {

class DeviceTriangles {
  public:
    Buffer triangles;  // Triangle, scaled
    Buffer included;   // uint
    uint32_t count = 0;
    uint32_t includedCount = 0;
    Box root{};
    int exponent = 0;
};

class DeviceTree {
  public:
    std::shared_ptr<DeviceTriangles> triangles;
    Buffer nodes;          // KdNode
    Buffer leafTriangles;  // uint
    uint32_t nodeCount = 0;
    uint32_t leafRefCount = 0;
    Box bounds{};
    int exponent = 0;
};

}  // namespace cleave
