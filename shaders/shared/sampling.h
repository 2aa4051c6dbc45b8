// Directions from uniform numbers, and their densities per solid angle. Local frames have the axis of interest as z.
#ifndef CLEAVE_SHARED_SAMPLING_H
#define CLEAVE_SHARED_SAMPLING_H
#include "triangle.h"

CLEAVE_BEGIN

CLEAVE_CONST float kTurn = 6.28318531f;  // 2 pi
CLEAVE_CONST float kInversePi = 0.318309886f;

struct SineCosine {
    float sine;
    float cosine;
};

// Of a fraction of a turn from -1/8 to 1/8, by Taylor's polynomials to x^9 and x^10, whose next terms are below 2e-9.
// Own polynomials, since sin() and cos() differ between devices.
CLEAVE_FN SineCosine sineCosineNearZero(float turn) {
    precise float x = kTurn * turn;
    precise float q = x * x;
    precise float s = q * 2.75573192e-6f - 1.98412698e-4f;
    s = q * s + 8.33333333e-3f;
    s = q * s - 1.66666667e-1f;
    s = x + x * (q * s);
    precise float c = q * -2.75573192e-7f + 2.48015873e-5f;
    c = q * c - 1.38888889e-3f;
    c = q * c + 4.16666667e-2f;
    c = q * (q * c - 0.5f) + 1.0f;
    SineCosine r;
    r.sine = s;
    r.cosine = c;
    return r;
}

// Of a fraction of a turn in [0, 1), each to within 1e-7.
CLEAVE_FN SineCosine sineCosine(float turn) {
    uint quarter = (min(uint(8.0f * turn), 7u) + 1u) >> 1;  // the nearest
    precise float rest = turn - 0.25f * float(quarter);
    SineCosine near = sineCosineNearZero(rest);
    SineCosine r = near;
    if ((quarter & 1u) != 0u) {
        r.sine = near.cosine;
        r.cosine = -near.sine;
    }
    if ((quarter & 2u) != 0u) {
        r.sine = -r.sine;
        r.cosine = -r.cosine;
    }
    return r;
}

// Maps the unit square to the unit disc, area to area and squares to circles (Shirley and Chiu 1997), so that numbers
// that are close give points that are.
CLEAVE_FN vec2 concentricDisc(vec2 u) {
    precise float a = 2.0f * u.x - 1.0f;
    precise float b = 2.0f * u.y - 1.0f;
    bool wide = abs(a) > abs(b);
    float radius = wide ? a : b;
    if (radius == 0.0f) return vec2(0.0f, 0.0f);
    precise float turn = 0.125f * ((wide ? b : a) / radius);
    SineCosine angle = sineCosineNearZero(turn);
    precise float along = radius * angle.cosine;
    precise float across = radius * angle.sine;
    return wide ? vec2(along, across) : vec2(across, along);
}

// The height of a hemisphere of radius 1 over a point of the disc.
CLEAVE_FN float heightOver(vec2 disc) {
    precise float square = disc.x * disc.x + disc.y * disc.y;
    precise float left = 1.0f - square;
    return sqrt(max(0.0f, left));
}

// A direction above the horizon, as likely as its cosine is large.
CLEAVE_FN vec3 cosineDirection(vec2 u) {
    vec2 disc = concentricDisc(u);
    return vec3(disc.x, disc.y, heightOver(disc));
}
CLEAVE_FN float cosineDensity(vec3 direction) {
    precise float density = max(0.0f, direction.z) * kInversePi;
    return density;
}

// A direction above the horizon, more likely close to it: its height is the square of a uniform number.
CLEAVE_FN vec3 horizonDirection(vec2 u) {
    vec2 disc = concentricDisc(u);
    precise float root = 1.0f - (disc.x * disc.x + disc.y * disc.y);
    precise float z = max(0.0f, root) * root;
    precise float stretch = sqrt((1.0f + root) * (1.0f + z));
    precise vec3 direction = vec3(disc.x * stretch, disc.y * stretch, z);
    return direction;
}
CLEAVE_FN float horizonDensity(vec3 direction) {  // its z is above 0
    precise float density = 0.25f * kInversePi / sqrt(direction.z);
    return density;
}

// Cones about z are given by the height 1 - cos of the cap that they cut out of the unit sphere, since a cosine of the
// sun's 0.27 degrees is 1 to five digits. Of a half angle below 90 degrees:
CLEAVE_FN float capHeight(float sineOfHalfAngle) {
    precise float square = sineOfHalfAngle * sineOfHalfAngle;
    precise float cosine = sqrt(max(0.0f, 1.0f - square));
    precise float height = square / (1.0f + cosine);
    return height;
}

// A direction of the cone, all alike. By Archimedes a cap's area is in its height.
CLEAVE_FN vec3 coneDirection(float height, vec2 u) {
    vec2 disc = concentricDisc(u);
    precise float down = height * (disc.x * disc.x + disc.y * disc.y);
    precise float stretch = sqrt(height * (2.0f - down));
    precise vec3 direction = vec3(disc.x * stretch, disc.y * stretch, 1.0f - down);
    return direction;
}
CLEAVE_FN float coneDensity(float height, vec3 direction) {
    precise float square = direction.x * direction.x + direction.y * direction.y;
    precise float most = height * (2.0f - height);
    precise float density = 1.0f / (kTurn * height);
    return direction.z > 0.0f && square <= most ? density : 0.0f;
}

// A right-handed frame of unit vectors, in the world.
CLEAVE_FN vec3 unitVector(vec3 v) {
    float scale = 1.0f / sqrt(preciseDot(v, v));
    precise vec3 unit = v * scale;
    return unit;
}

struct Basis {
    vec3 x;
    vec3 y;
    vec3 z;
};
CLEAVE_SIZE(Basis, 36);

// The frame about a unit normal, without a special case near its poles (Duff et al. 2017).
CLEAVE_FN Basis basisAbout(vec3 normal) {
    float side = normal.z < 0.0f ? -1.0f : 1.0f;
    precise float a = -1.0f / (side + normal.z);
    precise float b = normal.x * normal.y * a;
    precise float xx = 1.0f + side * (normal.x * normal.x * a);
    precise float yy = side + normal.y * normal.y * a;
    Basis r;
    r.x = vec3(xx, side * b, -side * normal.x);
    r.y = vec3(b, yy, -normal.y);
    r.z = normal;
    return r;
}
CLEAVE_FN vec3 toLocal(Basis b, vec3 v) { return vec3(preciseDot(b.x, v), preciseDot(b.y, v), preciseDot(b.z, v)); }
CLEAVE_FN vec3 toWorld(Basis b, vec3 v) {
    precise vec3 r = b.x * v.x + b.y * v.y + b.z * v.z;
    return r;
}

CLEAVE_END
#endif
