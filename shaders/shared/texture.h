// Textures: how a material picks from an image (glTF 2.0, section 3.8, and KHR_texture_transform).
//
// Images are sampled at full size, by the nearest texel or between four of them: pictures are antialiased by their
// samples, which cover a pixel's whole patch of a texture, and need no smaller copies of it.
#ifndef CLEAVE_SHARED_TEXTURE_H
#define CLEAVE_SHARED_TEXTURE_H
#include "language.h"

CLEAVE_BEGIN

// TextureMap.flags. How coordinates beyond the image continue: repeated where neither bit is set.
CLEAVE_CONST uint kMapClampS = 1u;
CLEAVE_CONST uint kMapMirrorS = 2u;
CLEAVE_CONST uint kMapClampT = 4u;
CLEAVE_CONST uint kMapMirrorT = 8u;
CLEAVE_CONST uint kMapNearest = 16u;    // the nearest texel; else between four
CLEAVE_CONST uint kMapSrgb = 32u;       // red, green and blue are encoded in sRGB
CLEAVE_CONST uint kMapSecondSet = 64u;  // picks by texture coordinates 1; else by 0
CLEAVE_CONST uint kMapAtOrigin = 128u;  // the scene lacks these coordinates: all are 0

struct TextureMap {
    uint first;  // of its texels, row by row from the top
    uint width;
    uint height;
    uint flags;
    // (u, v) of a triangle becomes (turn.x u + turn.y v, turn.z u + turn.w v) + offset.
    vec4 turn;
    vec2 offset;
};
CLEAVE_SIZE(TextureMap, 40);

CLEAVE_TABLE(TextureMapArray, TextureMap);
CLEAVE_TABLE(TexelArray, uint);  // R | G << 8 | B << 16 | A << 24

// Linear light of an encoded component in [0, 1] (IEC 61966-2-1).
CLEAVE_FN float decoded(float x) { return x <= 0.04045f ? x / 12.92f : pow((x + 0.055f) / 1.055f, 2.4f); }

CLEAVE_FN vec4 texelValue(uint texel, bool srgb) {
    vec4 c = vec4(float(texel & 255u), float(texel >> 8 & 255u), float(texel >> 16 & 255u), float(texel >> 24)) *
             (1.0f / 255.0f);
    return srgb ? vec4(decoded(c.x), decoded(c.y), decoded(c.z), c.w) : c;
}

// Where the place `at`, a whole number of texels from the edge, is in an image of that size.
CLEAVE_FN uint wrappedPlace(float at, uint size, bool clamps, bool mirrors) {
    float last = float(size) - 1.0f;
    if (clamps) return uint(min(max(at, 0.0f), last));
    float period = mirrors ? 2.0f * float(size) : float(size);
    // Quotients of large coordinates are rounded, which must not lead out of the image.
    precise float inPeriod = at - floor(at / period) * period;
    float place = min(max(inPeriod, 0.0f), period - 1.0f);
    return uint(place > last ? period - 1.0f - place : place);
}

CLEAVE_FN uint texelIndex(TextureMap map, float x, float y) {
    uint column = wrappedPlace(x, map.width, (map.flags & kMapClampS) != 0u, (map.flags & kMapMirrorS) != 0u);
    uint row = wrappedPlace(y, map.height, (map.flags & kMapClampT) != 0u, (map.flags & kMapMirrorT) != 0u);
    return map.first + row * map.width + column;
}

// Coordinates may be anything in a file; beyond these there are no texels to tell apart.
CLEAVE_FN float usableCoordinate(float x) { return isFinite(x) ? min(max(x, -1.0e6f), 1.0e6f) : 0.0f; }

CLEAVE_FN vec4 mixedTexels(vec4 a, vec4 b, float t) { return a + (b - a) * t; }

// RGBA in [0, 1], linear where the map says how it is encoded.
CLEAVE_FN vec4 sampledTexture(TexelArray texels, TextureMap map, vec2 coordinates) {
    precise float u = map.turn.x * coordinates.x + map.turn.y * coordinates.y + map.offset.x;
    precise float v = map.turn.z * coordinates.x + map.turn.w * coordinates.y + map.offset.y;
    precise float x = usableCoordinate(u) * float(map.width);
    precise float y = usableCoordinate(v) * float(map.height);
    bool srgb = (map.flags & kMapSrgb) != 0u;
    if ((map.flags & kMapNearest) != 0u) return texelValue(texels.at[texelIndex(map, floor(x), floor(y))], srgb);
    float left = floor(x - 0.5f);
    float top = floor(y - 0.5f);
    float across = x - 0.5f - left;
    float down = y - 0.5f - top;
    vec4 upper = mixedTexels(texelValue(texels.at[texelIndex(map, left, top)], srgb),
                             texelValue(texels.at[texelIndex(map, left + 1.0f, top)], srgb), across);
    vec4 lower = mixedTexels(texelValue(texels.at[texelIndex(map, left, top + 1.0f)], srgb),
                             texelValue(texels.at[texelIndex(map, left + 1.0f, top + 1.0f)], srgb), across);
    return mixedTexels(upper, lower, down);
}

CLEAVE_END
#endif
