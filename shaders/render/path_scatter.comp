#version 460
// Takes each path one surface further: what it finds there, the ray to a light, the ray that goes on. An invocation per
// path.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

PathStep stepOf(uint i, Ray ray, vec3 throughput) {
    Hit hit = args.hits.at[i];
    if (hit.prim == kNone) return escape(args.settings, ray, throughput);
    uint pixel = pixelOf(i, args.camera.width, args.camera.height);
    LightSource light;
    if (args.settings.lightCount > 0u) light = args.lights.at[lightOf(args.settings, pixel, push.path, push.round)];
    HitSurface point = hitSurface(surfaceArrays(), kParts, hit, hitTriangle(hit), ray.direction);
    return scatter(args.settings, args.albedo, ray, hit, args.triangles.at[hit.prim], point, light, throughput, pixel,
                   push.path, push.round);
}

void main() {
    uint i = rayIndex();
    if (i >= args.count) return;
    bool first = push.round == 0u;
    Ray ray = args.rays.at[i];
    PathStep s = endOfPath(vec3(0.0));
    if (first || !isNoRay(ray)) s = stepOf(i, ray, first ? vec3(1.0) : args.throughput.at[i]);
    vec3 before = first && push.path == 0u ? vec3(0.0) : args.radiance.at[i];
    args.radiance.at[i] = before + s.found;
    args.direct.at[i] = s.direct;
    args.shadowRays.at[i] = s.shadow;
    args.throughput.at[i] = s.throughput;
    args.rays.at[i] = s.next;
}
