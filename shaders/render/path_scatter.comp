#version 460
// Takes each path one surface further: what it finds there, the ray to a light, the ray that goes on. An invocation per
// path. Rays that there are come first among those of their workgroup, so that tracing them has full lanes.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"
#include "lib/packed_place.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 4) const bool kEmitters = true;  // some surfaces shine

// Of normals and colours this kernel has both or neither, so that there are not too many of it.
uint parts() { return kParts & args.parts; }

Emitter emitterOf(TriangleChoice choice) {
    Hit point;
    point.t = 0.0;
    point.prim = triangleOf(args.emitters.at[choice.slot], choice.u);
    point.u = choice.at.x;
    point.v = choice.at.y;
    return emitterAt(surfaceArrays(), parts(), point, args.triangles.at[point.prim], hitTriangle(point));
}

ChosenLight lightFor(uint pixel) {
    ChosenLight light;
    if (lightChoices(args.settings) == 0u) return light;
    uint index = lightOf(args.settings, pixel, push.path, push.round);
    light.isSurface = kEmitters && index == args.settings.lightCount;
    if (light.isSurface)
        light.emitter = emitterOf(triangleChoice(args.settings, pixel, push.path, push.round));
    else
        light.source = args.lights.at[index];
    return light;
}

PathStep stepOf(uint path, Hit hit, Ray ray, vec3 throughput, float density) {
    if (hit.prim == kNone) return escape(args.settings, ray, throughput);
    uint pixel = pixelOf(path, args.camera.width, args.camera.height);
    HitSurface point = hitSurface(surfaceArrays(), parts(), hit, hitTriangle(hit), ray.direction);
    return scatter(args.settings, args.albedo, ray, hit, args.triangles.at[hit.prim], point, lightFor(pixel), throughput,
                   density, pixel, push.path, push.round);
}

// Adds what a path found to its pixel's sums, which begin with the first path.
void gather(uint path, PathStep s, bool begins) {
    vec3 before = begins ? vec3(0.0) : args.radiance.at[path];
    args.radiance.at[path] = s.unlit ? before : before + s.found;
    if (begins) args.unlit.at[path] = vec4(0.0);
    if (s.unlit) args.unlit.at[path] = args.unlit.at[path] + vec4(s.found, 1.0);
}

void main() {
    uint i = rayIndex();
    bool exists = i < push.end;
    bool first = push.round == 0u;
    uint path = i;
    PathStep s = endOfPath(vec3(0.0));
    if (exists) {
        if (!first) path = args.paths.at[i];
        Ray ray = args.rays.at[i];
        if (first) s = stepOf(path, args.hits.at[i], ray, vec3(1.0), 0.0);
        else if (!isNoRay(ray)) s = stepOf(path, args.hits.at[i], ray, args.throughput.at[i], args.density.at[i]);
        gather(path, s, first && push.path == 0u);
    }
    uint begin = i - gl_LocalInvocationID.x;
    uint at = begin + packedPlace(!isNoRay(s.next));
    uint shadowAt = begin + packedPlace(!isNoRay(s.shadow));
    if (!exists) return;
    args.rays.at[at] = s.next;
    args.paths.at[at] = path;
    args.throughput.at[at] = s.throughput;
    args.density.at[at] = s.density;
    args.shadowRays.at[shadowAt] = s.shadow;
    args.shadowPaths.at[shadowAt] = path;
    args.direct.at[shadowAt] = s.direct;
}
