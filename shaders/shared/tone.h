// From the radiance that a pixel gathered to the colour that it shows.
#ifndef CLEAVE_SHARED_TONE_H
#define CLEAVE_SHARED_TONE_H
#include "shade.h"

CLEAVE_BEGIN

// Khronos PBR Neutral (Khronos Group 2024, "Khronos PBR Neutral Tone Mapper"): base colours under white light look as
// they were chosen up to 0.8; beyond, brightness is compressed towards 1 and colours towards white.
CLEAVE_FN vec3 neutralTone(vec3 colour) {
    const float startCompression = 0.8f - 0.04f;
    const float desaturation = 0.15f;
    float least = min(colour.x, min(colour.y, colour.z));
    float offset = least < 0.08f ? least - 6.25f * least * least : 0.04f;
    vec3 c = colour - vec3(offset);
    float peak = max(c.x, max(c.y, c.z));
    if (peak < startCompression) return c;
    float d = 1.0f - startCompression;
    float newPeak = 1.0f - d * d / (peak + d - startCompression);
    c = c * (newPeak / peak);
    float g = 1.0f - 1.0f / (desaturation * (peak - newPeak) + 1.0f);
    return mixed(c, vec3(newPeak), g);
}

// What a view shows of the sum of a pixel's samples. Light is exposed, that of paths follows the tone curve; both are
// encoded. Samples that show an unlit surface are colours that were chosen for a screen: neither concerns them, and
// they have their share of the pixel, `unlit`, their sum and their number. Other views are colours already.
CLEAVE_FN vec3 shownColour(uint view, vec3 sum, vec4 unlit, uint samples, float exposure) {
    float all = float(samples);
    if (view != kViewPath && view != kViewShaded) return sum / all;
    float lit = all - unlit.w;
    vec3 light = sum / max(lit, 1.0f) * exposure;
    if (view == kViewPath) light = neutralTone(light);
    if (unlit.w > 0.0f) light = (min(light, vec3(1.0f)) * lit + vec3(unlit.x, unlit.y, unlit.z)) / all;
    return encoded(light);
}

CLEAVE_END
#endif
