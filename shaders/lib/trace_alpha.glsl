// The body of the kernels that trace rays of a picture which looks through something: hits where there is no surface do
// not count. An invocation per ray.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/picture_args.h"

bool isOpaqueTriangle(uint number);
bool findsSurface(uint number, float u, float v);

#define CLEAVE_LOOKS_THROUGH true
#define CLEAVE_IS_OPAQUE isOpaqueTriangle
#define CLEAVE_ACCEPTS findsSurface
#define CLEAVE_MORE_PUSH PicturePush picture;
#ifdef TRACES_SINGLE
#include "lib/trace_single.glsl"
#else
#include "lib/trace_main.glsl"
#endif

#define args picture.args.at
#include "lib/surface.glsl"

// Only the rays of the camera look through backs.
bool seesBothSides() { return kAnyHit || picture.round > 0u; }

bool isOpaqueTriangle(uint number) {
    uint flags = materialOf(surfaceArrays(), number).flags;
    if (seesBothSides()) flags &= ~kMaterialSingleSided;
    return (flags & (kMaterialMask | kMaterialBlend | kMaterialSingleSided)) == 0u;
}

bool findsSurface(uint number, float u, float v) {
    uint ray = picture.first + groupIndex() * kGroup + gl_LocalInvocationID.x;
    SurfaceArrays surfaces = surfaceArrays();
    Material material = materialOf(surfaces, number);
    bool backCounts = seesBothSides() || (material.flags & kMaterialSingleSided) == 0u;
    if (!backCounts && !comesToFront(surfaces, number, args.triangles.at[number], args.rays.at[ray].direction))
        return false;
    uint path = ray;
    if (args.view == kViewPath && seesBothSides()) path = kAnyHit ? args.shadowPaths.at[ray] : args.paths.at[ray];
    uint pixel = pixelOf(path, args.camera.width, args.camera.height);
    Hit hit;
    hit.t = 0.0;
    hit.prim = number;
    hit.u = u;
    hit.v = v;
    float chance = alphaChance(pixel, picture.path ^ args.settings.seed, picture.round, kAnyHit, number);
    return isThere(surfaces, kParts, material, hit, chance);
}
