// From hits to colours: the pure functions that the render kernels and their twins share.
#ifndef CLEAVE_SHARED_SHADE_H
#define CLEAVE_SHARED_SHADE_H
#include "geometry.h"
#include "picture.h"

#include "light.h"

CLEAVE_BEGIN

// The sun is a disc about a direction; the light that comes from everywhere else is a little blue.
CLEAVE_FN vec3 towardsSun() { return vec3(-0.39036003f, 0.78072006f, 0.48795004f); }
// Half of what the disc measures in the sky, as its sine; about twice the real one, so that shadows are seen to be
// soft.
CLEAVE_CONST float kSineOfSun = 0.01f;
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

// Where a ray starts that leaves a surface on the side that `direction` came from: off the hit's point by no more than
// what that is in doubt by, so that it neither meets its own triangle again nor passes a gap beside it, whatever the
// scale. The point is a sum of the vertices in double, within 2^-50 of the largest of their coordinates; its own
// coordinates are rounded to float, by 2^-24 of the largest each, and 2^-21 along the normal is more than all three
// together. Hits of rays are decided on the coordinates as they are (shared/triangle.h), so that no more is needed.
CLEAVE_FN vec3 leavingOrigin(Triangle world, Hit h, vec3 direction) {
    dvec3 a = dvec3(world.a);
    dvec3 e1 = dvec3(world.b) - a;
    dvec3 e2 = dvec3(world.c) - a;
    dvec3 n = preciseCross(e1, e2);
    precise double square = n.x * n.x + n.y * n.y;
    square = square + n.z * n.z;
    precise double along = n.x * double(direction.x) + n.y * double(direction.y);
    along = along + n.z * double(direction.z);
    dvec3 point;
    double largest = double(0.0f);
    double reach = double(0.0f);
    for (uint k = 0u; k < 3u; k++) {
        precise double p = a[k] + double(h.u) * e1[k];
        p = p + double(h.v) * e2[k];
        point[k] = p;
        largest = abs(p) > largest ? abs(p) : largest;
        double vertex = double(max(abs(world.a[k]), max(abs(world.b[k]), abs(world.c[k]))));
        reach = vertex > reach ? vertex : reach;
    }
    precise double offset = largest * double(4.76837158203125e-7f) + reach * double(3.5527136788005009e-15f);
    precise double scale = offset / sqrt(square);
    if (along > double(0.0f)) scale = -scale;
    vec3 origin;
    for (uint k = 0u; k < 3u; k++) {
        precise double p = point[k] + scale * n[k];
        origin[k] = float(p);
    }
    return origin;
}

// A ray in the place of none. It begins beyond any scene, so that its walk ends where it would enter the root: a ray
// that ends where it begins, in the scene, would still descend to a leaf.
CLEAVE_FN Ray noRay() {
    Ray r;
    r.origin = vec3(0.0f, 0.0f, 0.0f);
    r.direction = vec3(0.0f, 0.0f, 1.0f);
    r.tMin = 1.0e30f;
    r.tMax = 1.0e30f;
    return r;
}
// Rays from surfaces begin at 0.
CLEAVE_FN bool isNoRay(Ray r) { return r.tMin > 0.0f; }

// Linear light of the sky in a direction.
CLEAVE_FN vec3 backgroundColour(vec3 direction) {
    Sky sky;
    sky.horizon = vec3(0.82f, 0.84f, 0.86f);
    sky.zenith = vec3(0.32f, 0.48f, 0.72f);
    return skyRadiance(sky, direction);
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
