// From hits to colours: the pure functions that the render kernels and their twins share.
#ifndef CLEAVE_SHARED_SHADE_H
#define CLEAVE_SHARED_SHADE_H
#include "geometry.h"
#include "picture.h"

CLEAVE_BEGIN

// The sun is a direction; the light that comes from everywhere else is a little blue.
CLEAVE_FN vec3 towardsSun() { return vec3(-0.39036003f, 0.78072006f, 0.48795004f); }
CLEAVE_CONST float kSunLight = 0.85f;

CLEAVE_FN vec3 scaledBy(vec3 v, float s) { return vec3(v.x * s, v.y * s, v.z * s); }
CLEAVE_FN float dotOf(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CLEAVE_FN vec3 mixed(vec3 a, vec3 b, float t) {
    return vec3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);
}

// Unit normal of a triangle, on the side that the direction comes from. Lengths are divided by the largest first, so
// that small triangles do not underflow.
CLEAVE_FN vec3 facingNormal(Triangle t, vec3 direction) {
    vec3 e1 = t.b - t.a;
    vec3 e2 = t.c - t.a;
    float size = max(max(largestComponent(e1), largestComponent(e2)), kSmallestNormal);
    vec3 n = preciseCross(scaledBy(e1, 1.0f / size), scaledBy(e2, 1.0f / size));
    float most = max(largestComponent(n), kSmallestNormal);
    n = scaledBy(n, 1.0f / most);
    n = scaledBy(n, 1.0f / sqrt(dotOf(n, n)));
    float reach = largestComponent(direction);
    return dotOf(n, scaledBy(direction, 1.0f / reach)) > 0.0f ? scaledBy(n, -1.0f) : n;
}

CLEAVE_FN vec3 hitPoint(Ray r, float t) {
    return vec3(r.origin.x + t * r.direction.x, r.origin.y + t * r.direction.y, r.origin.z + t * r.direction.z);
}

// Makes a ray from the hit towards the sun. Where there is no hit its interval is a point, so that it costs nothing.
CLEAVE_FN Ray shadowRay(Ray r, Hit h, Triangle t, float offset) {
    Ray s = r;
    s.tMin = 0.0f;
    s.tMax = 0.0f;
    if (h.prim == kNone) return s;
    vec3 n = facingNormal(t, r.direction);
    vec3 p = hitPoint(r, h.t);
    s.origin = vec3(p.x + n.x * offset, p.y + n.y * offset, p.z + n.z * offset);
    s.direction = towardsSun();
    s.tMax = infinity();
    return s;
}

// Linear light that a surface sends back.
CLEAVE_FN vec3 shadedColour(vec3 baseColour, vec3 normal, bool lit) {
    float sun = lit ? kSunLight * max(dotOf(normal, towardsSun()), 0.0f) : 0.0f;
    vec3 ambient = mixed(vec3(0.16f, 0.15f, 0.14f), vec3(0.30f, 0.33f, 0.38f), 0.5f + 0.5f * normal.y);
    return vec3(baseColour.x * (ambient.x + sun), baseColour.y * (ambient.y + sun * 0.97f),
                baseColour.z * (ambient.z + sun * 0.90f));
}

// Linear light of the sky in a direction.
CLEAVE_FN vec3 backgroundColour(vec3 direction) {
    float length = largestComponent(direction);
    vec3 d = scaledBy(direction, 1.0f / max(length, kSmallestNormal));
    float up = d.y / sqrt(max(dotOf(d, d), kSmallestNormal));
    return mixed(vec3(0.82f, 0.84f, 0.86f), vec3(0.32f, 0.48f, 0.72f), min(max(up + 0.15f, 0.0f), 1.0f));
}

// sRGB of linear light (IEC 61966-2-1).
CLEAVE_FN float encoded(float x) {
    float c = min(max(x, 0.0f), 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * pow(c, 1.0f / 2.4f) - 0.055f;
}
CLEAVE_FN vec3 encoded(vec3 c) { return vec3(encoded(c.x), encoded(c.y), encoded(c.z)); }

CLEAVE_FN uint byteOf(float x) { return uint(min(max(x, 0.0f), 1.0f) * 255.0f + 0.5f); }
// R | G << 8 | B << 16 | opaque.
CLEAVE_FN uint packedColour(vec3 c) { return byteOf(c.x) | byteOf(c.y) << 8 | byteOf(c.z) << 16 | 0xFF000000u; }

// The scale of counts, 0 to 1: dark violet, blue, green, yellow, each lighter than the one before (viridis by eye).
CLEAVE_FN vec3 scaleColour(float x) {
    float at = min(max(x, 0.0f), 1.0f) * 4.0f;
    if (at < 1.0f) return mixed(vec3(0.267f, 0.005f, 0.329f), vec3(0.229f, 0.322f, 0.546f), at);
    if (at < 2.0f) return mixed(vec3(0.229f, 0.322f, 0.546f), vec3(0.128f, 0.567f, 0.551f), at - 1.0f);
    if (at < 3.0f) return mixed(vec3(0.128f, 0.567f, 0.551f), vec3(0.369f, 0.789f, 0.383f), at - 2.0f);
    return mixed(vec3(0.369f, 0.789f, 0.383f), vec3(0.993f, 0.906f, 0.144f), at - 3.0f);
}

// Where a value lies on the picture's scale.
CLEAVE_FN float onScale(float x, float low, float high) {
    return high > low ? min(max((x - low) / (high - low), 0.0f), 1.0f) : 0.0f;
}

CLEAVE_END
#endif
