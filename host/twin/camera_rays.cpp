#include "twin/render.h"

namespace cleave::twin {

void cameraRays(PictureArrays& a, PassNumbers numbers) {
    const uint32_t width = a.camera.width;
    for (uint32_t i = 0; i < a.rays.size(); i++) {
        const uint32_t pixel = pixelOf(i, width, a.camera.height);
        const vec2 place = placeInPixel(a.samples, a.settings.seed, pixel, numbers.path);
        a.rays[i] = imageRay(a.camera, pixel % width + double{place.x}, pixel / width + double{place.y});
    }
}

}  // namespace cleave::twin
