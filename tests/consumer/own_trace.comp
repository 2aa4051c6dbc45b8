// A user's own kernel: traces rays through a tree of cleave by including cleave.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "cleave.glsl"
layout(local_size_x = 64) in;

struct Ray {
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
};
layout(buffer_reference, scalar) readonly buffer Rays { Ray at[]; };
layout(buffer_reference, scalar) writeonly buffer Hits { CleaveHit at[]; };
layout(buffer_reference, scalar) writeonly buffer Flags { uint at[]; };
layout(buffer_reference, scalar) writeonly buffer Surfaces { ivec3 at[]; };
layout(push_constant, scalar) uniform Push {
    CleaveTree tree;  // 8 bytes: the address given to cmdBuild()
    Rays rays;
    Hits hits;
    Flags occluded;
    Surfaces surfacesOf;  // of each ray: counted one by one, counted, and signed
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    Ray r = rays.at[i];
    hits.at[i] = cleaveTrace(tree, r.origin, r.tMin, r.direction, r.tMax);
    occluded.at[i] = cleaveOccluded(tree, r.origin, r.tMin, r.direction, r.tMax) ? 1u : 0u;
    uint surfaces = 0u;
    CleaveHit hit = cleaveFirst(tree, r.origin, r.tMin, r.direction, r.tMax);
    for (; hit.prim != kCleaveNone; hit = cleaveNext(tree, r.origin, r.tMin, r.direction, r.tMax, hit)) surfaces++;
    uint counted = cleaveCount(tree, r.origin, r.tMin, r.direction, r.tMax);  // the same at once
    int leaving = cleaveWinding(tree, r.origin, r.tMin, r.direction, r.tMax);  // those that leave less those that enter
    surfacesOf.at[i] = ivec3(surfaces, counted, leaving);
}
