// Rays and hits: as the user sees them, and in the scaled space of a tree, where they are traced.
#ifndef CLEAVE_SHARED_RAY_H
#define CLEAVE_SHARED_RAY_H
#include "scale.h"

CLEAVE_BEGIN

// The points origin + t direction with tMin <= t <= tMax in world space. The direction need not be of unit length.
struct Ray {
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
};
CLEAVE_SIZE(Ray, 32);

// t counts lengths of the direction; u and v are the weights of the second and third vertex. A miss has t = +inf and
// prim = kNone.
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

// Says whether a ray can be traced; one that cannot be is answered as a miss and counted. tMax may be +inf.
CLEAVE_FN bool isValidRay(Ray r) {
    if (!isFinite3(r.origin) || !isFinite3(r.direction)) return false;
    if ((floatBitsToUint(r.direction.x) & 0x7FFFFFFFu) == 0u && (floatBitsToUint(r.direction.y) & 0x7FFFFFFFu) == 0u &&
        (floatBitsToUint(r.direction.z) & 0x7FFFFFFFu) == 0u)
        return false;
    if (isNan(r.tMin) || isNan(r.tMax)) return false;
    return r.tMin >= 0.0f && r.tMin <= r.tMax && isFinite(r.tMin);
}

// A valid ray in the scaled space of a tree: the origin times 2^-sceneExponent, the direction times the power of two
// that brings its largest component into [1, 2), and t to match, so that tWorld = t 2^tExponent. All of it is exact.
// Zero components are +0. The ray ends where tWorld would exceed the largest float; beyond, an any-hit query could find
// a hit that has no t.
struct ScaledRay {
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
    int tExponent;
};

// Of the largest component.
CLEAVE_FN int directionExponent(Ray r) {
    return max(binaryExponent(r.direction.x), max(binaryExponent(r.direction.y), binaryExponent(r.direction.z)));
}

CLEAVE_FN ScaledRay scaledRay(Ray r, int sceneExponent) {
    int e = directionExponent(r);
    ScaledRay s;
    s.origin = timesPowerOfTwo(r.origin, -sceneExponent);
    s.direction = timesPowerOfTwo(r.direction, -e);
    s.tExponent = sceneExponent - e;
    s.tMin = timesPowerOfTwo(r.tMin, -s.tExponent);
    s.tMax = timesPowerOfTwo(min(r.tMax, kLargestFloat), -s.tExponent);
    return s;
}

// A hit in scaled space, in world space. Exact, unless t falls below the smallest normal number.
CLEAVE_FN Hit worldHit(Hit h, int tExponent) {
    h.t = timesPowerOfTwo(h.t, tExponent);
    return h;
}

// And back.
CLEAVE_FN Hit scaledHit(Hit h, int tExponent) {
    h.t = timesPowerOfTwo(h.t, -tExponent);
    return h;
}

CLEAVE_END
#endif
