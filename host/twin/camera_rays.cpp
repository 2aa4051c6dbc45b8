#include "twin/render.h"

namespace cleave::twin {

void cameraRays(PictureArrays& a, uint32_t) {
    const uint32_t width = a.camera.width;
    for (uint32_t i = 0; i < a.rays.size(); i++) {
        const uint32_t pixel = pixelOf(i, width, a.camera.height);
        a.rays[i] = imageRay(a.camera, pixel % width + 0.5, pixel / width + 0.5);
    }
}

}  // namespace cleave::twin
