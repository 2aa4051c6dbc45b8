// A picture on the device: what its kernels are given, from the camera to the pixels.
#ifndef CLEAVE_SHARED_PICTURE_H
#define CLEAVE_SHARED_PICTURE_H
#include "config.h"
#include "trace.h"

CLEAVE_BEGIN

// The views of a picture; as View in host/render.
CLEAVE_CONST uint kViewShaded = 0u;
CLEAVE_CONST uint kViewNormals = 1u;
CLEAVE_CONST uint kViewDepth = 2u;   // t of the hit, near is bright
CLEAVE_CONST uint kViewSteps = 3u;   // nodes and leaves visited
CLEAVE_CONST uint kViewLeaves = 4u;  // triangles in the leaf of the hit
CLEAVE_CONST uint kViewPath = 5u;    // light, as it goes from surface to surface

// Those of light, in which surfaces may be unlit.
CLEAVE_FN bool isOfLight(uint view) { return view == kViewShaded || view == kViewPath; }

// A camera and its image plane. Square pixels; image point (0, 0) is the upper left corner.
struct ImageCamera {
    dvec3 eye;
    dvec3 forward;  // unit length
    dvec3 right;
    dvec3 up;
    double pixel;  // size of a pixel: at distance 1, or in all for an orthographic camera
    uint width;
    uint height;
    uint orthographic;
    float tMax;
};
CLEAVE_SIZE(ImageCamera, 120);

// The ray through image point (x, y), of unit direction. Double arithmetic, rounded to float once.
CLEAVE_FN Ray imageRay(ImageCamera c, double x, double y) {
    precise double across = (x - double(0.5f) * double(c.width)) * c.pixel;
    precise double along = (double(0.5f) * double(c.height) - y) * c.pixel;
    precise dvec3 offset;
    precise dvec3 way;
    for (uint k = 0u; k < 3u; k++) {
        offset[k] = across * c.right[k] + along * c.up[k];
        way[k] = c.forward[k] + offset[k];
    }
    precise double square = way.x * way.x + way.y * way.y;
    square = square + way.z * way.z;
    precise double scale = double(1.0f) / sqrt(square);
    Ray r;
    for (uint k = 0u; k < 3u; k++) {
        precise double o = c.eye[k];
        precise double d = way[k] * scale;
        if (c.orthographic != 0u) {
            o = o + offset[k];
            d = c.forward[k];
        }
        r.origin[k] = float(o);
        r.direction[k] = float(d);
    }
    r.tMin = 0.0f;
    r.tMax = c.tMax;
    return r;
}

// Which pixel, counted row by row, the ray of that number belongs to. Rays go through the picture in tiles of 8 x 8,
// and through a tile in Morton order, so that the lanes of a subgroup of any size look at a compact patch; tiles that
// the picture's edge cuts go row by row.
CLEAVE_FN uint pixelOf(uint ray, uint width, uint height) {
    uint strip = ray / (8u * width);
    uint rows = min(8u, height - 8u * strip);
    uint inStrip = ray - strip * 8u * width;
    uint tile = inStrip / (8u * rows);
    uint columns = min(8u, width - 8u * tile);
    uint k = inStrip - tile * 8u * rows;
    uint x = k % columns;
    uint y = k / columns;
    if (rows == 8u && columns == 8u) {
        x = (k & 1u) | (k >> 1 & 2u) | (k >> 2 & 4u);
        y = (k >> 1 & 1u) | (k >> 2 & 2u) | (k >> 3 & 4u);
    }
    return (8u * strip + y) * width + 8u * tile + x;
}

// Gathers what concerns the whole picture: its scale and its counters. It is zeroed before a picture is rendered.
// Larger bits are farther out.
struct PictureState {
    uint lowBits;   // ~orderedBits of the scale's lower end
    uint highBits;  // orderedBits of its upper end; 0: there is none
    uint prefix;    // of the count that is being selected: the bytes that are known
    uint rank;      // how many of the counts that begin with `prefix` are before it
    uint histogram[256];
    TraceCounters primary;
    TraceCounters shadow;
};
CLEAVE_SIZE(PictureState, 1056);

// The ends of a picture's scale; what lies beyond looks like the end.
struct ViewScale {
    float low;
    float high;
};
CLEAVE_FN ViewScale viewScale(uint lowBits, uint highBits) {
    ViewScale s;
    s.low = highBits == 0u ? 0.0f : fromOrderedBits(~lowBits);
    s.high = highBits == 0u ? 0.0f : fromOrderedBits(highBits);
    return s;
}

// The count that a pixel shows; `counts` is false where it shows none and does not matter to the scale.
CLEAVE_FN bool countsInScale(uint view, Hit hit) { return view == kViewSteps || hit.prim != kNone; }
CLEAVE_FN uint shownCount(uint view, StepCount s) { return view == kViewSteps ? s.inner + s.leaves : s.hitLeaf; }

// The scale of counts ends where all but 1 in 200 pixels stay below: a few rays along a wall would leave the rest in
// the dark. This is the place of that count among `total` in ascending order, floor((total - 1) * 199 / 200).
CLEAVE_FN uint scaleRank(uint total) {
    uint last = max(total, 1u) - 1u;
    return last / 200u * 199u + last % 200u * 199u / 200u;
}

// How far a hit stretches the scale of depths: to where its ray leaves the scene's box. The farthest hit
// would not do: it lies where a surface turns away, and the whole scale would hang on one pixel there.
CLEAVE_FN float depthReach(Ray r, Hit h, Box bounds, int exponent) {
    double unit = powerOfTwo(exponent);
    double leave = double(infinity());
    for (uint k = 0u; k < 3u; k++) {
        if (r.direction[k] == 0.0f) continue;
        precise double wall = double(r.direction[k] > 0.0f ? bounds.hi[k] : bounds.lo[k]) * unit;
        precise double t = (wall - double(r.origin[k])) / double(r.direction[k]);
        leave = t < leave ? t : leave;
    }
    return max(h.t, float(leave));
}

CLEAVE_END
#endif
