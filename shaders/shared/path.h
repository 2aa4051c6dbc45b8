// One step of a path: from the hit of its ray to the light that is found there and the ray that goes on (Kajiya 1986).
#ifndef CLEAVE_SHARED_PATH_H
#define CLEAVE_SHARED_PATH_H
#include "surface.h"

#include "brdf.h"
#include "emitter.h"
#include "random.h"

CLEAVE_BEGIN

// What the steps of a picture's paths have in common.
struct PathSettings {
    Sky sky;
    uint lightCount;  // of LightSource
    Emitters emitters;
    uint bounces;  // surfaces that a path may be reflected by; beyond, it sees what shines itself and no more
    uint seed;
};
CLEAVE_SIZE(PathSettings, 44);

// From this bounce on, paths that carry little are ended by chance, and the others carry what these would have.
CLEAVE_CONST uint kFirstRoulette = 3u;
CLEAVE_CONST float kMostSurvival = 0.95f;

// Decisions of a path, three numbers each (see random.h): 0 is its place in the pixel, then these for each bounce.
CLEAVE_CONST uint kDecisions = 4u;
CLEAVE_CONST uint kDecideLight = 1u;
CLEAVE_CONST uint kDecideDirection = 2u;
CLEAVE_CONST uint kDecideEnd = 3u;
CLEAVE_CONST uint kDecideTriangle = 4u;
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
    bool unlit;       // `found` is the colour of an unlit surface that the camera sees
    vec3 direct;      // and that which does if nothing is met on the shadow ray
    Ray shadow;       // none, where there is no light to look for
    vec3 throughput;  // of what the next ray finds
    float density;    // of its direction, per solid angle
    Ray next;         // none, where the path ends
};

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
    s.unlit = false;
    s.direct = vec3(0.0f);
    s.shadow = noRay();
    s.throughput = vec3(0.0f);
    s.density = 0.0f;
    s.next = noRay();
    return s;
}

CLEAVE_FN vec3 unitDirection(vec3 d) { return unitVector(d * (1.0f / max(largestComponent(d), kSmallestNormal))); }

// Lights that one is chosen of, all alike: each of the sources, and the surfaces that shine together.
CLEAVE_FN uint lightChoices(PathSettings s) { return s.lightCount + (s.emitters.slots > 0u ? 1u : 0u); }

CLEAVE_FN uint lightIndex(float u, uint count) { return min(uint(u * float(count)), count - 1u); }

// lightCount: of the surfaces.
CLEAVE_FN uint lightOf(PathSettings settings, uint pixel, uint path, uint bounce) {
    float u = sampleNumber(pixel, path ^ settings.seed, dimensionOf(bounce, kDecideLight));
    return lightIndex(u, lightChoices(settings));
}

// What an alias table is asked with, a word for the slot and a number for the choice in it; and a point on the
// triangle.
struct TriangleChoice {
    uint slot;
    float u;
    vec2 at;
};
CLEAVE_FN TriangleChoice triangleChoice(PathSettings settings, uint pixel, uint path, uint bounce) {
    uvec3 bits = pcg3d(uvec3(pixel, path ^ settings.seed, dimensionOf(bounce, kDecideTriangle)));
    vec3 u = sampleNumbers(pixel, path ^ settings.seed, dimensionOf(bounce, kDecideLight));
    TriangleChoice r;
    r.slot = slotOf(bits.x, settings.emitters.slots);
    r.u = unitFloat(bits.y);
    r.at = placeOnTriangle(vec2(u.y, u.z));
    return r;
}

// The light that a bounce looks for.
struct ChosenLight {
    bool isSurface;
    LightSource source;  // or
    Emitter emitter;
};

// Light of a surface is found in two ways, by looking for it and by the ray that goes on, and each find is weighted
// with its density over that of both (the balance heuristic of Veach and Guibas 1995). Here of the latter: the ray had
// the density `density` of its direction, and met the surface at `hit`. What a camera sees is looked for in no other
// way.
CLEAVE_FN float shareOfFinding(PathSettings settings, Ray ray, Hit hit, HitSurface point, float density, uint bounce) {
    if (bounce == 0u || settings.emitters.slots == 0u || !(point.brightness > 0.0f)) return 1.0f;
    float cosine = preciseDot(point.facing, ray.direction);
    float looked = emitterDensity(settings.emitters, point.brightness, hit.t, cosine) / float(lightChoices(settings));
    return density / (density + looked);
}

// And of looking for it: over the density that it was looked for with. Other lights are found in no other way.
CLEAVE_FN float shareOfLooking(PathSettings settings, Arrival arrival, float density) {
    float choices = float(lightChoices(settings));
    return arrival.density > 0.0f ? 1.0f / (arrival.density / choices + density) : choices;
}

// Of a path that meets nothing.
CLEAVE_FN PathStep escape(PathSettings settings, Ray ray, vec3 throughput) {
    return endOfPath(throughput * skyRadiance(settings.sky, ray.direction));
}

// Of a path that hits a triangle of the world, at `point`. `light` is that of lightOf(), `density` that of the ray's
// direction.
//
// Directions are in the hemisphere of the shading normal and count if they leave the triangle too: beneath it there is
// no light, however its corners or a map bend the normal.
CLEAVE_FN PathStep scatter(PathSettings settings, AlbedoTable table, Ray ray, Hit hit, Triangle world, HitSurface point,
                           ChosenLight light, vec3 throughput, float density, uint pixel, uint path, uint bounce) {
    vec3 baseColour = vec3(point.baseColour.x, point.baseColour.y, point.baseColour.z);
    PathStep s = endOfPath(vec3(0.0f));
    if ((point.flags & kMaterialUnlit) != 0u) {
        s.found = throughput * baseColour;
        s.unlit = bounce == 0u;
        return s;
    }
    s.found = throughput * point.emission * shareOfFinding(settings, ray, hit, point, density, bounce);
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

    if (lightChoices(settings) > 0u) {
        vec3 u = sampleNumbers(pixel, seeded, dimensionOf(bounce, kDecideLight));
        vec2 across = vec2(u.y, u.z);
        Arrival arrival;
        if (light.isSurface)
            arrival = arrivalFromEmitter(settings.emitters, light.emitter, origin);
        else
            arrival = arrivalFrom(light.source, origin, across);
        BrdfValue value = evaluateBrdf(surface, table, viewer, toLocal(frame, arrival.towards));
        if (preciseDot(arrival.towards, point.facing) > 0.0f)
            s.direct =
                throughput * value.timesCosine * arrival.irradiance * shareOfLooking(settings, arrival, value.density);
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
    s.density = way.density;
    s.next = rayFrom(origin, direction, infinity());
    return s;
}

CLEAVE_END
#endif
