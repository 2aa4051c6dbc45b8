// What the surfaces of a scene are made of, in the arrays that kernels take (shared/surface.h).
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <vector>

#include "shared/surface.h"

namespace cleave {

struct SurfaceData {
#define CLEAVE_SURFACE_VECTOR(name, Element, Array, part) std::vector<Element> name;
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_VECTOR)
#undef CLEAVE_SURFACE_VECTOR
    uint32_t parts = 0;        // which of the arrays are there: kPartNormals and so on
    bool hasAlpha = false;     // some materials are not opaque
    bool singleSided = false;  // some are not seen from behind

    SurfaceArrays arrays() const {
        SurfaceArrays s;
#define CLEAVE_SURFACE_POINTER(name, Element, Array, part) s.name.at = name.data();
        CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_POINTER)
#undef CLEAVE_SURFACE_POINTER
        return s;
    }
};

// The same in device memory.
struct SurfaceAddresses {
#define CLEAVE_SURFACE_ADDRESS(name, Element, Array, part) VkDeviceAddress name = 0;
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_ADDRESS)
#undef CLEAVE_SURFACE_ADDRESS
    uint32_t parts = 0;
    bool hasAlpha = false;
    bool singleSided = false;
};

}  // namespace cleave
