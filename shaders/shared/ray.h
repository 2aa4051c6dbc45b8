// Rays and hits as users give and get them, and the form in which a tree is traversed.
#ifndef CLEAVE_SHARED_RAY_H
#define CLEAVE_SHARED_RAY_H
#include "scale.h"

CLEAVE_BEGIN

// Points origin + t direction with tMin <= t <= tMax; world space; the direction need not be of unit length.
struct Ray {
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
};
CLEAVE_SIZE(Ray, 32);

// t is in units of the direction; u and v weigh the second and third vertex. A miss: t = +inf, prim = kNone.
struct Hit {
    float t;
    uint prim;
    float u;
    float v;
};
CLEAVE_SIZE(Hit, 16);

CLEAVE_FN Hit missedHit() {
    Hit h;
    h.t = infinity();
    h.prim = kNone;
    h.u = 0.0f;
    h.v = 0.0f;
    return h;
}

CLEAVE_FN bool isFinite3(vec3 v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }

// NUMERICS rule 6: what is not a ray is answered as a miss and counted. tMax may be +inf.
CLEAVE_FN bool isValidRay(Ray r) {
    if (!isFinite3(r.origin) || !isFinite3(r.direction)) return false;
    if ((floatBitsToUint(r.direction.x) & 0x7FFFFFFFu) == 0u && (floatBitsToUint(r.direction.y) & 0x7FFFFFFFu) == 0u &&
        (floatBitsToUint(r.direction.z) & 0x7FFFFFFFu) == 0u)
        return false;
    if (isNan(r.tMin) || isNan(r.tMax)) return false;
    return r.tMin >= 0.0f && r.tMin <= r.tMax && isFinite(r.tMin);
}

// A valid ray in the scaled space of a tree: the origin times 2^-sceneExponent, the direction times a power of two
// that brings its largest component into [1, 2), and t to match; all exact. tExponent brings t back:
// tWorld = t 2^tExponent. Zero components are +0. A ray ends where t, brought back, would be beyond the largest float:
// else an any-hit could be one that has no t.
struct ScaledRay {
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
    int tExponent;
};

CLEAVE_FN ScaledRay scaledRay(Ray r, int sceneExponent) {
    int e = max(binaryExponent(r.direction.x), max(binaryExponent(r.direction.y), binaryExponent(r.direction.z)));
    ScaledRay s;
    s.origin = timesPowerOfTwo(r.origin, -sceneExponent);
    s.direction = timesPowerOfTwo(r.direction, -e);
    s.tExponent = sceneExponent - e;
    s.tMin = timesPowerOfTwo(r.tMin, -s.tExponent);
    s.tMax = timesPowerOfTwo(min(r.tMax, kLargestFloat), -s.tExponent);
    return s;
}

CLEAVE_FN Hit worldHit(Hit h, int tExponent) {
    h.t = timesPowerOfTwo(h.t, tExponent);
    return h;
}

CLEAVE_END
#endif
