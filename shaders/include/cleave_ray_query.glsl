// cleave_ray_query.glsl: the names of GL_EXT_ray_query over cleave.glsl, for devices without ray queries.
// MIT License, Copyright (c) 2026 The cleave authors.
//
//     #ifdef USES_CLEAVE
//     #include "cleave_ray_query.glsl"   // instead of the extension, before the first declaration
//     layout(push_constant) uniform Push { accelerationStructureEXT scene; };  // the address that cmdBuild() was given
//     #else
//     #extension GL_EXT_ray_query : require
//     layout(binding = 0) uniform accelerationStructureEXT scene;
//     #endif
//
// and the rest of the shader stays as it is. All triangles are opaque and two-sided, there is one geometry and one
// instance, its number 0: a query has its answer after the first rayQueryProceedEXT(), which returns false. With
// gl_RayFlagsTerminateOnFirstHitEXT any hit is the answer, with gl_RayFlagsCullOpaqueEXT, gl_RayFlagsSkipTrianglesEXT or
// a mask of 0 there is none. Culling by facing is not to be had, nor what asks for the triangle's front or vertices.
#ifndef CLEAVE_RAY_QUERY_GLSL
#define CLEAVE_RAY_QUERY_GLSL
#include "cleave.glsl"

#define accelerationStructureEXT CleaveTree

#define gl_RayFlagsNoneEXT 0u
#define gl_RayFlagsOpaqueEXT 1u
#define gl_RayFlagsTerminateOnFirstHitEXT 4u
#define gl_RayFlagsSkipClosestHitShaderEXT 8u
#define gl_RayFlagsCullOpaqueEXT 64u
#define gl_RayFlagsCullNoOpaqueEXT 128u
#define gl_RayFlagsSkipTrianglesEXT 256u
#define gl_RayFlagsSkipAABBEXT 512u
#define gl_RayQueryCommittedIntersectionNoneEXT 0u
#define gl_RayQueryCommittedIntersectionTriangleEXT 1u
#define gl_RayQueryCommittedIntersectionGeneratedEXT 2u
#define gl_RayQueryCandidateIntersectionTriangleEXT 0u
#define gl_RayQueryCandidateIntersectionAABBEXT 1u

struct rayQueryEXT {
    CleaveTree tree;
    uint flags;
    uint mask;
    vec3 origin;
    float tMin;
    vec3 direction;
    float tMax;
    CleaveHit hit;
};

void rayQueryInitializeEXT(out rayQueryEXT query, CleaveTree tree, uint flags, uint mask, vec3 origin, float tMin,
                           vec3 direction, float tMax) {
    query.tree = tree;
    query.flags = flags;
    query.mask = mask;
    query.origin = origin;
    query.tMin = tMin;
    query.direction = direction;
    query.tMax = tMax;
    query.hit = cleaveMissedHit();
}

bool rayQueryProceedEXT(inout rayQueryEXT query) {
    uint nothing = gl_RayFlagsCullOpaqueEXT | gl_RayFlagsSkipTrianglesEXT;
    if ((query.flags & nothing) != 0u || (query.mask & 255u) == 0u) return false;
    bool anyHit = (query.flags & gl_RayFlagsTerminateOnFirstHitEXT) != 0u;
    query.hit = cleaveAnswer(query.tree, query.origin, query.tMin, query.direction, query.tMax, anyHit);
    return false;
}

void rayQueryTerminateEXT(inout rayQueryEXT query) {}
void rayQueryConfirmIntersectionEXT(inout rayQueryEXT query) {}

uint rayQueryGetIntersectionTypeEXT(rayQueryEXT query, bool committed) {
    return committed && query.hit.prim != kCleaveNone ? gl_RayQueryCommittedIntersectionTriangleEXT : 0u;
}
float rayQueryGetIntersectionTEXT(rayQueryEXT query, bool committed) { return query.hit.t; }
int rayQueryGetIntersectionPrimitiveIndexEXT(rayQueryEXT query, bool committed) { return int(query.hit.prim); }
vec2 rayQueryGetIntersectionBarycentricsEXT(rayQueryEXT query, bool committed) { return vec2(query.hit.u, query.hit.v); }
int rayQueryGetIntersectionInstanceIdEXT(rayQueryEXT query, bool committed) { return 0; }
int rayQueryGetIntersectionInstanceCustomIndexEXT(rayQueryEXT query, bool committed) { return 0; }
int rayQueryGetIntersectionGeometryIndexEXT(rayQueryEXT query, bool committed) { return 0; }
vec3 rayQueryGetIntersectionObjectRayOriginEXT(rayQueryEXT query, bool committed) { return query.origin; }
vec3 rayQueryGetIntersectionObjectRayDirectionEXT(rayQueryEXT query, bool committed) { return query.direction; }
vec3 rayQueryGetWorldRayOriginEXT(rayQueryEXT query) { return query.origin; }
vec3 rayQueryGetWorldRayDirectionEXT(rayQueryEXT query) { return query.direction; }
float rayQueryGetRayTMinEXT(rayQueryEXT query) { return query.tMin; }
uint rayQueryGetRayFlagsEXT(rayQueryEXT query) { return query.flags; }
#endif
