// One step of a path: from the hit of its ray to the light that is found there and the ray that goes on (Kajiya 1986).
#ifndef CLEAVE_SHARED_PATH_H
#define CLEAVE_SHARED_PATH_H
#include "surface.h"

#include "brdf.h"
#include "light.h"
#include "random.h"

CLEAVE_BEGIN

// What the steps of a picture's paths have in common.
struct PathSettings {
    Sky sky;
    uint lightCount;  // of LightSource
    uint bounces;     // surfaces that a path may be reflected by; beyond, it sees what shines itself and no more
    uint seed;
};
CLEAVE_SIZE(PathSettings, 36);

// From this bounce on, paths that carry little are ended by chance, and the others carry what these would have.
CLEAVE_CONST uint kFirstRoulette = 3u;
CLEAVE_CONST float kMostSurvival = 0.95f;

// Decisions of a path, three numbers each (see random.h): 0 is its place in the pixel, then these for each bounce.
CLEAVE_CONST uint kDecisions = 3u;
CLEAVE_CONST uint kDecideLight = 1u;
CLEAVE_CONST uint kDecideDirection = 2u;
CLEAVE_CONST uint kDecideEnd = 3u;
CLEAVE_FN uint dimensionOf(uint bounce, uint decision) { return bounce * kDecisions + decision; }
// Beside these, whether the ray that comes to a bounce, or leaves it for a light, finds a triangle that is seen
// through.
CLEAVE_FN float alphaChance(uint pixel, uint path, uint bounce, bool toLight, uint triangle) {
    uint decision = pcg3d(uvec3(triangle, bounce, toLight ? 1u : 0u)).x | 0x80000000u;
    return sampleNumber(pixel, path, decision);
}

// Where the sample of a pixel is in it; a single one is at its centre.
CLEAVE_FN vec2 placeInPixel(uint samples, uint seed, uint pixel, uint path) {
    vec3 u = sampleNumbers(pixel, path ^ seed, 0u);
    return samples > 1u ? vec2(u.x, u.y) : vec2(0.5f, 0.5f);
}

struct PathStep {
    vec3 found;       // radiance that reaches the camera from here
    vec3 direct;      // and that which does if nothing is met on the shadow ray
    Ray shadow;       // a point, where there is no light to look for
    vec3 throughput;  // of what the next ray finds
    Ray next;         // a point, where the path ends
};

// A ray that meets nothing and costs nothing.
CLEAVE_FN Ray noRay() {
    Ray r;
    r.origin = vec3(0.0f, 0.0f, 0.0f);
    r.direction = vec3(0.0f, 0.0f, 1.0f);
    r.tMin = 0.0f;
    r.tMax = 0.0f;
    return r;
}
CLEAVE_FN bool isNoRay(Ray r) { return r.tMax == 0.0f; }

CLEAVE_FN Ray rayFrom(vec3 origin, vec3 direction, float tMax) {
    Ray r;
    r.origin = origin;
    r.direction = direction;
    r.tMin = 0.0f;
    r.tMax = tMax;
    return r;
}

CLEAVE_FN PathStep endOfPath(vec3 found) {
    PathStep s;
    s.found = found;
    s.direct = vec3(0.0f);
    s.shadow = noRay();
    s.throughput = vec3(0.0f);
    s.next = noRay();
    return s;
}

CLEAVE_FN vec3 unitDirection(vec3 d) { return unitVector(d * (1.0f / max(largestComponent(d), kSmallestNormal))); }

CLEAVE_FN uint lightIndex(float u, uint count) { return min(uint(u * float(count)), count - 1u); }

CLEAVE_FN uint lightOf(PathSettings settings, uint pixel, uint path, uint bounce) {
    float u = sampleNumber(pixel, path ^ settings.seed, dimensionOf(bounce, kDecideLight));
    return lightIndex(u, settings.lightCount);
}

// Of a path that meets nothing.
CLEAVE_FN PathStep escape(PathSettings settings, Ray ray, vec3 throughput) {
    return endOfPath(throughput * skyRadiance(settings.sky, ray.direction));
}

// Of a path that hits a triangle of the world, at `point`. `light` is that of lightOf().
//
// Directions are in the hemisphere of the shading normal and count if they leave the triangle too: beneath it there is
// no light, however its corners or a map bend the normal.
CLEAVE_FN PathStep scatter(PathSettings settings, AlbedoTable table, Ray ray, Hit hit, Triangle world, HitSurface point,
                           LightSource light, vec3 throughput, uint pixel, uint path, uint bounce) {
    vec3 baseColour = vec3(point.baseColour.x, point.baseColour.y, point.baseColour.z);
    if ((point.flags & kMaterialUnlit) != 0u) return endOfPath(throughput * baseColour);
    PathStep s = endOfPath(throughput * point.emission);
    if (bounce >= settings.bounces) return s;

    Surface surface;
    surface.baseColour = baseColour;
    surface.metallic = point.metallic;
    surface.roughness = point.roughness;
    Basis frame = basisAbout(point.normal);
    vec3 viewer = toLocal(frame, unitDirection(ray.direction) * -1.0f);
    viewer.z = max(viewer.z, kLeastCosine);
    vec3 origin = leavingOrigin(world, hit, ray.direction);
    uint seeded = path ^ settings.seed;

    if (settings.lightCount > 0u) {
        vec3 u = sampleNumbers(pixel, seeded, dimensionOf(bounce, kDecideLight));
        Arrival arrival = arrivalFrom(light, origin, vec2(u.y, u.z));
        vec3 reflected = brdfTimesCosine(surface, table, viewer, toLocal(frame, arrival.towards));
        if (preciseDot(arrival.towards, point.facing) > 0.0f)
            s.direct = throughput * reflected * arrival.irradiance * float(settings.lightCount);
        if (largestComponent(s.direct) > 0.0f) s.shadow = rayFrom(origin, arrival.towards, arrival.distance);
    }

    BrdfSample way =
        sampleBrdf(surface, table, viewer, sampleNumbers(pixel, seeded, dimensionOf(bounce, kDecideDirection)));
    vec3 carried = throughput * way.weight;
    float most = largestComponent(carried);
    vec3 direction = toWorld(frame, way.direction);
    if (!(way.density > 0.0f) || !(most > 0.0f) || !(preciseDot(direction, point.facing) > 0.0f)) return s;
    if (bounce >= kFirstRoulette) {
        float survival = min(most, kMostSurvival);
        if (sampleNumber(pixel, seeded, dimensionOf(bounce, kDecideEnd)) >= survival) return s;
        carried = carried * (1.0f / survival);
    }
    s.throughput = carried;
    s.next = rayFrom(origin, direction, infinity());
    return s;
}

CLEAVE_END
#endif
