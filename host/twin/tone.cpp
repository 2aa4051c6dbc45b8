#include "twin/render.h"

namespace cleave::twin {

void tone(PictureArrays& a, PassNumbers numbers) {
    for (uint32_t i = 0; i < a.rays.size(); i++) {
        const vec4 unlit = isOfLight(a.view) ? a.unlit[i] : vec4(0.0f);
        a.pixels[pixelOf(i, a.camera.width, a.camera.height)] =
            packedColour(shownColour(a.view, a.radiance[i], unlit, numbers.path, a.exposure));
    }
}

}  // namespace cleave::twin
