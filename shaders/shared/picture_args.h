// What the kernels of a picture are given: arrays, the scene, settings.
#ifndef CLEAVE_SHARED_PICTURE_ARGS_H
#define CLEAVE_SHARED_PICTURE_ARGS_H
#include "path.h"

CLEAVE_BEGIN

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer PictureStateRef { PictureState at; };
#endif

// The arrays of a picture: name, element, its array in GLSL, how many. `n` is PictureCounts in render/picture_layout.h.
#define CLEAVE_PICTURE_ARRAYS(ROW)                                                                  \
    ROW(rays, Ray, RayArray, n.pixels)                                                              \
    ROW(hits, Hit, HitArray, n.pixels)                                                              \
    ROW(trails, Trail, TrailArray, n.trails)                                                        \
    ROW(steps, StepCount, StepCountArray, n.counted) /* for the views of counts only */             \
    ROW(shadowRays, Ray, RayArray, n.shadowed)       /* for the views of light only */              \
    ROW(shadowHits, Hit, HitArray, n.shadowed)                                                      \
    ROW(shadowTrails, Trail, TrailArray, n.shadowTrails)                                            \
    ROW(paths, uint, NumberArray, n.walked)       /* the ray's: which, from the first bounce on */  \
    ROW(throughput, vec3, Vec3Array, n.walked)    /* of the path that the ray goes on with */       \
    ROW(density, float, FloatArray, n.walked)     /* of its direction */                            \
    ROW(shadowPaths, uint, NumberArray, n.walked) /* the shadow ray's */                            \
    ROW(direct, vec3, Vec3Array, n.walked)        /* what a path finds if its shadow ray is free */ \
    ROW(radiance, vec3, Vec3Array, n.pixels)      /* the sum of all samples, or of colours */       \
    ROW(unlit, vec4, Vec4Array, n.lit)            /* that of samples of unlit surfaces; how many */ \
    ROW(pixels, uint, UintArray, n.pixels)        /* R | G << 8 | B << 16 | A << 24, sRGB, row by row */

#define CLEAVE_PICTURE_FIELD(name, Element, Array, count) CLEAVE_ADDRESS(Array) name;
#define CLEAVE_SURFACE_FIELD(name, Element, Array, part) CLEAVE_ADDRESS(Array) name;

struct PictureArgs {
    CLEAVE_PICTURE_ARRAYS(CLEAVE_PICTURE_FIELD)
    CLEAVE_ADDRESS(PictureStateRef) state;
    CLEAVE_ADDRESS(TriangleArray) triangles;  // in world space, by number
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_FIELD)
    CLEAVE_ADDRESS(LightArray) lights;  // for paths, and so are the rest
    CLEAVE_ADDRESS(AliasArray) emitters;
    CLEAVE_ADDRESS(AlbedoTable) albedo;
    ImageCamera camera;
    Box bounds;    // of the scene, in the scaled space of its trees
    int exponent;  // scaled space to world: world = scaled * 2^exponent
    uint view;
    uint count;    // of pixels
    uint samples;  // of a pixel; a single one is at its centre
    float exposure;
    PathSettings settings;
    float ambientReach;  // of the view `shaded`: what is farther from a surface takes no light from around it
    uint parts;          // that the scene has: kPartNormals and so on
};
CLEAVE_SIZE(PictureArgs, 440);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PictureArgsRef { PictureArgs at; };
#endif

struct PicturePush {
    CLEAVE_ADDRESS(PictureArgsRef) args;
    // Of count_histogram and select_count: 0 to 3, from the highest byte of the counts to the lowest. Of path_scatter:
    // the bounce, from 0.
    uint round;
    uint path;   // the sample, from 0; of tone: how many there are
    uint first;  // the slice of the picture's rays that the pass is for: of these numbers,
    uint end;    // below this one
};
CLEAVE_SIZE(PicturePush, 24);

// Of trace_alpha; `round` is the bounce that the rays come to or, of shadow rays, leave.
struct SurfaceTracePush {
    TracePush trace;
    PicturePush picture;
};
CLEAVE_SIZE(SurfaceTracePush, 104);

CLEAVE_END
#endif
