// What lights a scene: the sky, which is everywhere around it, and lights that are too small to be hit by chance.
#ifndef CLEAVE_SHARED_LIGHT_H
#define CLEAVE_SHARED_LIGHT_H
#include "ray.h"
#include "sampling.h"

CLEAVE_BEGIN

// Radiance, linear, of directions that no surface is met in: from the horizon to straight up.
struct Sky {
    vec3 horizon;
    vec3 zenith;
};
CLEAVE_SIZE(Sky, 24);

CLEAVE_FN vec3 skyRadiance(Sky sky, vec3 direction) {
    float length = largestComponent(direction);
    vec3 d = direction * (1.0f / max(length, kSmallestNormal));
    float up = d.y / sqrt(max(preciseDot(d, d), kSmallestNormal));
    float t = min(max(up + 0.15f, 0.0f), 1.0f);
    precise vec3 radiance = sky.horizon + (sky.zenith - sky.horizon) * t;
    return radiance;
}

// The kinds of light (KHR_lights_punctual, and a sun that is a disc in the sky).
CLEAVE_CONST uint kLightPoint = 0u;
CLEAVE_CONST uint kLightSpot = 1u;
CLEAVE_CONST uint kLightDirectional = 2u;

struct LightSource {
    vec3 position;  // of points and spots
    uint kind;
    vec3 direction;   // unit length; a directional light or a spot shines that way
    float capHeight;  // of a directional light's disc in the sky, see sampling.h; 0: a point of it
    vec3 intensity;   // per solid angle; of a directional light: irradiance across its direction
    float range;      // of points and spots, may be infinite
    float cosInner;   // of spots: full inside, nothing outside of the outer angle
    float cosOuter;
};
CLEAVE_SIZE(LightSource, 56);

#ifndef __cplusplus
CLEAVE_ARRAY(LightArray, LightSource);
#endif

// What comes from a light at a point: from where, how far it is, and how much falls on a surface across its direction.
struct Arrival {
    vec3 towards;  // unit length
    float distance;
    vec3 irradiance;  // of a surface: its radiance
    float density;    // of a surface's point, per solid angle; 0: rays do not meet the light by chance
};

// Fades to nothing at the range (KHR_lights_punctual, "range property").
CLEAVE_FN float rangeWindow(float distance, float range) {
    precise float share = distance / range;
    precise float square = share * share;
    return max(0.0f, 1.0f - square * square);
}

// Of a spot, for the cosine of the angle to its axis; squared, as the extension has it.
CLEAVE_FN float spotShare(LightSource light, float cosine) {
    precise float width = max(1.0e-4f, light.cosInner - light.cosOuter);
    float share = min(max(0.0f, (cosine - light.cosOuter) / width), 1.0f);
    return share * share;
}

CLEAVE_FN Arrival arrivalFrom(LightSource light, vec3 point, vec2 u) {
    Arrival r;
    r.density = 0.0f;
    if (light.kind == kLightDirectional) {
        vec3 towards = light.direction * -1.0f;
        r.towards = light.capHeight > 0.0f ? toWorld(basisAbout(towards), coneDirection(light.capHeight, u)) : towards;
        r.distance = infinity();
        r.irradiance = light.intensity;
        return r;
    }
    vec3 way = light.position - point;
    float size = max(largestComponent(way), kSmallestNormal);
    vec3 scaled = way * (1.0f / size);
    float length = sqrt(preciseDot(scaled, scaled));
    r.towards = scaled * (1.0f / length);
    r.distance = size * length;
    float share = rangeWindow(r.distance, light.range);
    if (light.kind == kLightSpot) share = share * spotShare(light, -preciseDot(r.towards, light.direction));
    r.irradiance = light.intensity * (share / (r.distance * r.distance));
    return r;
}

CLEAVE_END
#endif
