#include "twin/render.h"

namespace cleave::twin {

void tone(PictureArrays& a, PassNumbers numbers) {
    for (uint32_t i = 0; i < a.rays.size(); i++)
        a.pixels[pixelOf(i, a.camera.width, a.camera.height)] =
            packedColour(shownColour(a.view, a.radiance[i] / static_cast<float>(numbers.path), a.exposure));
}

}  // namespace cleave::twin
