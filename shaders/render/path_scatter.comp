#version 460
// Takes each path one surface further: what it finds there, the ray to a light, the ray that goes on. An invocation per
// path.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

Emitter emitterOf(TriangleChoice choice) {
    Hit point;
    point.t = 0.0;
    point.prim = triangleOf(args.emitters.at[choice.slot], choice.u);
    point.u = choice.at.x;
    point.v = choice.at.y;
    return emitterAt(surfaceArrays(), kParts, point, args.triangles.at[point.prim], hitTriangle(point));
}

ChosenLight lightFor(uint pixel) {
    ChosenLight light;
    if (lightChoices(args.settings) == 0u) return light;
    uint index = lightOf(args.settings, pixel, push.path, push.round);
    light.isSurface = index == args.settings.lightCount;
    if (light.isSurface)
        light.emitter = emitterOf(triangleChoice(args.settings, pixel, push.path, push.round));
    else
        light.source = args.lights.at[index];
    return light;
}

PathStep stepOf(uint i, Ray ray, vec3 throughput, float density) {
    Hit hit = args.hits.at[i];
    if (hit.prim == kNone) return escape(args.settings, ray, throughput);
    uint pixel = pixelOf(i, args.camera.width, args.camera.height);
    HitSurface point = hitSurface(surfaceArrays(), kParts, hit, hitTriangle(hit), ray.direction);
    return scatter(args.settings, args.albedo, ray, hit, args.triangles.at[hit.prim], point, lightFor(pixel), throughput,
                   density, pixel, push.path, push.round);
}

void main() {
    uint i = rayIndex();
    if (i >= args.count) return;
    bool first = push.round == 0u;
    Ray ray = args.rays.at[i];
    PathStep s = endOfPath(vec3(0.0));
    if (first) {
        s = stepOf(i, ray, vec3(1.0), 0.0);
    } else if (!isNoRay(ray)) {
        s = stepOf(i, ray, args.throughput.at[i], args.density.at[i]);
    }
    bool none = first && push.path == 0u;
    vec3 before = none ? vec3(0.0) : args.radiance.at[i];
    args.radiance.at[i] = s.unlit ? before : before + s.found;
    if (none) args.unlit.at[i] = vec4(0.0);
    if (s.unlit) args.unlit.at[i] = args.unlit.at[i] + vec4(s.found, 1.0);
    args.direct.at[i] = s.direct;
    args.shadowRays.at[i] = s.shadow;
    args.throughput.at[i] = s.throughput;
    args.density.at[i] = s.density;
    args.rays.at[i] = s.next;
}
