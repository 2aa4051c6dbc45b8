// Answers rays by a ray query: the driver's, or cleave's under the same names.
#include "lib/group.glsl"
#include "lib/peer_trace.glsl"

layout(local_size_x = kGroup) in;

Hit answer(Ray ray) {
    rayQueryEXT query;
    uint flags = gl_RayFlagsOpaqueEXT | (kAnyHit ? gl_RayFlagsTerminateOnFirstHitEXT : 0u);
    rayQueryInitializeEXT(query, accelerationStructureEXT(push.scene), flags, kEveryInstance, ray.origin, ray.tMin,
                          ray.direction, ray.tMax);
    while (rayQueryProceedEXT(query)) {
    }
    Hit hit = missedHit();
    if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT) return hit;
    hit.t = rayQueryGetIntersectionTEXT(query, true);
    hit.prim = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true));
    vec2 weights = rayQueryGetIntersectionBarycentricsEXT(query, true);
    hit.u = weights.x;
    hit.v = weights.y;
    return hit;
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    Ray ray = push.rays.at[i];
    Hit hit = missedHit();
    if (isValidRay(ray)) hit = answer(ray);
    push.hits.at[i] = hit;
}
