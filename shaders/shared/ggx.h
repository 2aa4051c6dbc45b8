// The microfacets of a rough surface: GGX with the height-correlated Smith term and Schlick's Fresnel. Directions as in
// brdf.h.
#ifndef CLEAVE_SHARED_GGX_H
#define CLEAVE_SHARED_GGX_H
#include "sampling.h"

CLEAVE_BEGIN

// GGX's distribution of microfacet normals (Walter et al. 2007). Near the normal the tangent has digits that the cosine
// lacks.
CLEAVE_FN float ggx(float alpha, vec3 facet) {
    precise float x = facet.x / alpha;
    precise float y = facet.y / alpha;
    precise float t = x * x + y * y;
    t = t + facet.z * facet.z;
    precise float density = kInversePi / (alpha * alpha * (t * t));
    return density;
}

// What Smith's terms for GGX are made of: sqrt(alpha^2 sin^2 + cos^2).
CLEAVE_FN float smithRoot(float alpha, float cosine) {
    precise float square = alpha * alpha;
    precise float root = sqrt(square + (1.0f - square) * (cosine * cosine));
    return root;
}

// Both directions are above the horizon. The microfacet BRDF without its Fresnel factor is D * V,
// V = G / (4 cos(v) cos(l)); see the specification.
CLEAVE_FN float facetBrdf(float alpha, vec3 facet, vec3 viewer, vec3 light) {
    precise float masking = light.z * smithRoot(alpha, viewer.z) + viewer.z * smithRoot(alpha, light.z);
    precise float value = ggx(alpha, facet) * 0.5f / masking;
    return value;
}

// Density of reflections of the viewer in a visible facet (Heitz 2018), those into the surface included.
CLEAVE_FN float reflectionDensity(float alpha, vec3 facet, vec3 viewer) {
    precise float masking = viewer.z + smithRoot(alpha, viewer.z);
    precise float density = ggx(alpha, facet) * 0.5f / masking;
    return density;
}

CLEAVE_FN vec3 schlick(vec3 f0, float cosine) {
    precise float c = 1.0f - min(max(0.0f, cosine), 1.0f);
    precise float square = c * c;
    precise float fifth = square * square * c;
    precise vec3 f = f0 + (vec3(1.0f) - f0) * fifth;
    return f;
}

// The normal of a facet that the viewer sees, as likely as it is seen: a point of the hemisphere's shadow, where the
// surface is stretched until it is a hemisphere (Heitz 2018).
CLEAVE_FN vec3 visibleFacet(float alpha, vec3 viewer, vec2 u) {
    precise vec3 stretched = vec3(alpha * viewer.x, alpha * viewer.y, viewer.z);
    vec3 z = unitVector(stretched);
    precise float square = z.x * z.x + z.y * z.y;
    vec3 x = vec3(1.0f, 0.0f, 0.0f);
    if (square > 1.0e-30f) x = unitVector(vec3(-z.y, z.x, 0.0f));
    vec3 y = preciseCross(z, x);
    vec2 disc = concentricDisc(u);
    precise float share = 0.5f + 0.5f * z.z;
    precise float chord = sqrt(max(0.0f, 1.0f - disc.x * disc.x));
    precise float across = (1.0f - share) * chord + share * disc.y;
    float height = heightOver(vec2(disc.x, across));
    precise vec3 n = x * disc.x + y * across + z * height;
    precise vec3 facet = vec3(alpha * n.x, alpha * n.y, max(1.0e-6f, n.z));
    return unitVector(facet);
}

CLEAVE_END
#endif
