// Surfaces that shine, as lights to look for: which of their triangles, where on it, and how likely that was. The
// chance of a triangle is its share of the power of all, so that its points have a density that hangs on its emission
// alone.
#ifndef CLEAVE_SHARED_EMITTER_H
#define CLEAVE_SHARED_EMITTER_H
#include "surface.h"

CLEAVE_BEGIN

// A slot of an alias table (Walker 1977; made as Vose 1991 has it). Slots are as likely as each other; one gives its
// first triangle with that chance and its second otherwise.
struct AliasSlot {
    uint first;
    uint second;
    float chance;
};
CLEAVE_SIZE(AliasSlot, 12);

#ifndef __cplusplus
CLEAVE_ARRAY(AliasArray, AliasSlot);
#endif

// A slot of `count` from a random word: the upper word of their product, put together from halves.
CLEAVE_FN uint slotOf(uint word, uint count) {
    uint low = (word & 0xFFFFu) * (count & 0xFFFFu);
    uint middle = (word >> 16) * (count & 0xFFFFu) + (low >> 16);
    uint other = (word & 0xFFFFu) * (count >> 16) + (middle & 0xFFFFu);
    return (word >> 16) * (count >> 16) + (middle >> 16) + (other >> 16);
}
CLEAVE_FN uint triangleOf(AliasSlot slot, float u) { return u < slot.chance ? slot.first : slot.second; }

// What the triangles that shine have in common.
struct Emitters {
    uint slots;   // of their alias table; 0: there are none to look for
    float scale;  // 1 / sqrt(sum of brightness times area)
};
CLEAVE_SIZE(Emitters, 8);

// Of a point on one of them, per solid angle, where it is seen from at that distance. Scaled before it is squared, so
// that neither small nor large scenes leave the range of floats.
CLEAVE_FN float emitterDensity(Emitters e, float brightness, float distance, float cosine) {
    precise float scaled = distance * e.scale;
    precise float density = brightness * scaled * scaled / max(abs(cosine), 1.0e-6f);
    return density;
}

// Where on a triangle: the weights of its second and third vertex, all points alike.
CLEAVE_FN vec2 placeOnTriangle(vec2 u) {
    precise float sum = u.x + u.y;
    precise vec2 folded = vec2(1.0f, 1.0f) - u;
    return sum > 1.0f ? folded : u;
}

// One that was chosen, and a point on it.
struct Emitter {
    Triangle world;
    vec2 at;      // the weights of the second and third vertex
    vec3 normal;  // unit length
    vec3 emission;
    float brightness;  // that its chance is of
};

// At the point of a hit, whose triangle is given in the world and in the scaled space of the tree. A surface that is
// not opaque shines by the share of rays that find it there.
CLEAVE_FN Emitter emitterAt(SurfaceArrays s, uint parts, Hit point, Triangle world, Triangle scaled) {
    Material m = materialOf(s, point.prim);
    Emitter e;
    e.world = world;
    e.at = vec2(point.u, point.v);
    e.normal = facingNormal(scaled, vec3(0.0f, 0.0f, 1.0f));
    e.emission = emissionAt(s, parts, m, point) * presenceAt(s, parts, m, point);
    e.brightness = m.brightness;
    return e;
}

// From the point of an emitter. The ray towards it ends before it, by more than rounding may move the point
// where they meet: the nearer to its plane the ray is, the farther.
CLEAVE_FN Arrival arrivalFromEmitter(Emitters e, Emitter emitter, vec3 point) {
    precise vec3 there = emitter.world.a + (emitter.world.b - emitter.world.a) * emitter.at.x +
                         (emitter.world.c - emitter.world.a) * emitter.at.y;
    vec3 way = there - point;
    float size = max(largestComponent(way), kSmallestNormal);
    vec3 scaled = way * (1.0f / size);
    float length = sqrt(preciseDot(scaled, scaled));
    Arrival r;
    r.towards = scaled * (1.0f / length);
    float distance = size * length;
    float cosine = abs(preciseDot(emitter.normal, r.towards));
    float reach = max(largestComponent(emitter.world.a),
                      max(largestComponent(emitter.world.b), largestComponent(emitter.world.c)));
    precise float doubt = (distance + reach) * 4.76837158e-7f / max(cosine, 1.0e-6f);
    precise float end = distance - doubt;
    r.distance = max(end, 0.5f * distance);
    r.irradiance = emitter.emission;
    r.density = emitterDensity(e, emitter.brightness, distance, cosine);
    return r;
}

CLEAVE_END
#endif
