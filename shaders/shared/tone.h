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

// What a view shows of the mean of its samples: radiance is exposed and encoded, that of paths after the tone curve;
// other views are colours already.
CLEAVE_FN vec3 shownColour(uint view, vec3 mean, float exposure) {
    if (view == kViewPath) return encoded(neutralTone(mean * exposure));
    if (view == kViewShaded) return encoded(mean * exposure);
    return mean;
}

CLEAVE_END
#endif
