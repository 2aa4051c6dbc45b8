// The rays by which the view `shaded` finds what light reaches a hit. A picture of a single sample has one, towards the
// sun's middle; in one of several each sample looks for a point of the sun's disc and for the light from all around.
#ifndef CLEAVE_SHARED_LIGHT_RAYS_H
#define CLEAVE_SHARED_LIGHT_RAYS_H
#include "path.h"

CLEAVE_BEGIN

struct LightRays {
    Ray sun;
    Ray around;  // none, where there is a single sample
};

CLEAVE_FN vec3 directionToSun(uint samples, uint pixel, uint seeded) {
    if (samples == 1u) return towardsSun();
    vec3 u = sampleNumbers(pixel, seeded, dimensionOf(0u, kDecideLight));
    return toWorld(basisAbout(towardsSun()), coneDirection(capHeight(kSineOfSun), vec2(u.y, u.z)));
}

// As likely as its cosine to the triangle's normal is large: the share of rays that are free is that of the light.
CLEAVE_FN vec3 directionAround(vec3 facing, uint pixel, uint seeded) {
    vec3 u = sampleNumbers(pixel, seeded, dimensionOf(0u, kDecideDirection));
    return toWorld(basisAbout(facing), cosineDirection(vec2(u.x, u.y)));
}

// Of a hit on a triangle, which is given in the world and in the scaled space of the tree. `seeded` is the sample's
// number with the seed; what is farther than `reach` keeps no light from all around away.
CLEAVE_FN LightRays lightRays(Ray ray, Hit hit, Triangle world, Triangle scaled, uint samples, float reach, uint pixel,
                              uint seeded) {
    vec3 origin = leavingOrigin(world, hit, ray.direction);
    LightRays r;
    r.sun = rayFrom(origin, directionToSun(samples, pixel, seeded), infinity());
    r.around = noRay();
    if (samples > 1u)
        r.around = rayFrom(origin, directionAround(facingNormal(scaled, ray.direction), pixel, seeded), reach);
    return r;
}
CLEAVE_FN LightRays noLightRays() {
    LightRays r;
    r.sun = noRay();
    r.around = noRay();
    return r;
}

CLEAVE_END
#endif
