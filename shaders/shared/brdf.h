// The metallic-roughness BRDF of glTF 2.0 (appendix B of its specification): GGX with the height-correlated Smith term
// and Schlick's Fresnel. Directions are of unit length, point away from the surface, and are in a frame whose z is the
// shading normal.
//
// The specification's diffuse part, (1 - F) / pi, neither keeps energy nor knows of what microfacets scatter more than
// once. Here a surface reflects what Kulla and Conty (2017) give it: the specular lobe; a lobe of what bounces between
// facets, which has the shape loss(v) loss(l); and under both a diffuse lobe of the shape rest(v) rest(l), where rest
// is what the other two leave. White surfaces reflect all that comes in, dielectric or metal; nothing reflects more;
// and light that goes the other way is reflected alike. It rests on a table of the specular lobe's directional albedo,
// and holds as exactly as its lookup: to 0.004 at worst, near the horizon of a nearly smooth surface, and 0.0002 on
// average.
#ifndef CLEAVE_SHARED_BRDF_H
#define CLEAVE_SHARED_BRDF_H
#include "ggx.h"
#include "specular_albedo.h"

CLEAVE_BEGIN

struct Surface {
    vec3 baseColour;  // linear, each component in [0, 1]
    float metallic;   // in [0, 1]
    float roughness;  // in [0, 1]
};
CLEAVE_SIZE(Surface, 20);

// Directions closer to the horizon count as below it, where there is no light.
CLEAVE_CONST float kLeastCosine = 1.0e-6f;

// The three lobes of a surface.
struct Lobes {
    float roughness;
    float alpha;
    vec3 f0;         // of the specular lobe
    vec3 scattered;  // colour of what bounces between facets
    vec3 diffuse;    // colour of the diffuse lobe
    SpecularAlbedo mean;
};

// Light that bounces between facets is reflected by the mean Fresnel each time, and leaves with the mean albedo.
CLEAVE_FN Lobes lobesOf(Surface s, AlbedoTable table) {
    Lobes r;
    r.roughness = min(max(kLeastRoughness, s.roughness), 1.0f);
    precise float alpha = r.roughness * r.roughness;
    precise float dielectric = 1.0f - s.metallic;
    precise vec3 f0 = s.baseColour * s.metallic + vec3(0.04f) * dielectric;
    precise vec3 diffuse = s.baseColour * dielectric;
    r.mean = meanAlbedo(table, r.roughness);
    precise vec3 fresnel = (f0 * 20.0f + vec3(1.0f)) / 21.0f;
    precise vec3 scattered = fresnel * fresnel * (1.0f - r.mean.loss) / (vec3(1.0f) - fresnel * r.mean.loss);
    r.alpha = alpha;
    r.f0 = f0;
    r.scattered = scattered;
    r.diffuse = diffuse;
    return r;
}

CLEAVE_FN vec3 specularShare(Lobes l, SpecularAlbedo a) {
    precise vec3 share = l.f0 * (1.0f - a.loss) + (vec3(1.0f) - l.f0) * a.edge;
    return share;
}

// What specularShare() and the bounces between facets leave.
CLEAVE_FN vec3 restOf(Lobes l, SpecularAlbedo a) {
    precise vec3 rest = (vec3(1.0f) - l.f0) * (1.0f - a.edge) - (l.scattered - l.f0) * a.loss;
    return max(rest, vec3(0.0f));
}

// The BRDF of both broad lobes, between directions of these albedos.
CLEAVE_FN vec3 broadBrdf(Lobes l, SpecularAlbedo viewer, SpecularAlbedo light) {
    precise float bounces = viewer.loss * light.loss / l.mean.loss;
    precise vec3 under = restOf(l, viewer) * restOf(l, light) / max(restOf(l, l.mean), vec3(1.0e-6f));
    precise vec3 value = (l.scattered * bounces + l.diffuse * under) * kInversePi;
    return value;
}

// How often a sample is drawn in each way: as the share of what it suits is, on the average of the channels. Bounces
// between the facets of a smooth surface lose light near the horizon only, and a density that ignored that would give
// rare samples hundreds of times the usual weight. The facets and the cosine are never left out, since what is found in
// one way is weighted with the density of all.
struct LobeChances {
    float facet;
    float horizon;
    float cosine;
};

CLEAVE_FN float sumOf(vec3 v) {
    precise float sum = v.x + v.y + v.z;
    return sum;
}

CLEAVE_FN LobeChances lobeChances(Lobes l, SpecularAlbedo viewer) {
    precise vec3 bounces = l.scattered * viewer.loss;
    precise vec3 broad = bounces + l.diffuse * restOf(l, viewer);
    precise float facet = sumOf(specularShare(l, viewer)) + 1.0e-3f;
    precise float horizon = sumOf(bounces) * max(0.0f, 1.0f - 2.0f * l.roughness);
    precise float cosine = sumOf(broad) - horizon + 1.0e-3f;
    precise float all = facet + horizon + cosine;
    LobeChances r;
    r.facet = facet / all;
    r.horizon = horizon / all;
    r.cosine = cosine / all;
    return r;
}

struct BrdfValue {
    vec3 timesCosine;  // the BRDF times the light's cosine
    float density;     // of sampleBrdf(), per solid angle
};

CLEAVE_FN BrdfValue lobesTowards(Lobes l, AlbedoTable table, SpecularAlbedo viewerAlbedo, vec3 viewer, vec3 light) {
    BrdfValue r;
    r.timesCosine = vec3(0.0f);
    r.density = 0.0f;
    if (!(viewer.z >= kLeastCosine && light.z >= kLeastCosine)) return r;
    precise vec3 between = viewer + light;
    vec3 facet = unitVector(between);
    SpecularAlbedo lightAlbedo = lookedUpAlbedo(table, l.roughness, light.z);
    LobeChances chances = lobeChances(l, viewerAlbedo);
    precise vec3 specular = schlick(l.f0, preciseDot(viewer, facet)) * facetBrdf(l.alpha, facet, viewer, light);
    precise vec3 timesCosine = (specular + broadBrdf(l, viewerAlbedo, lightAlbedo)) * light.z;
    precise float density = chances.facet * reflectionDensity(l.alpha, facet, viewer) +
                            chances.horizon * horizonDensity(light) + chances.cosine * cosineDensity(light);
    r.timesCosine = timesCosine;
    r.density = density;
    return r;
}

// Both at once, for the price of one.
CLEAVE_FN BrdfValue evaluateBrdf(Surface s, AlbedoTable table, vec3 towardsViewer, vec3 towardsLight) {
    Lobes l = lobesOf(s, table);
    return lobesTowards(l, table, lookedUpAlbedo(table, l.roughness, towardsViewer.z), towardsViewer, towardsLight);
}
CLEAVE_FN vec3 brdfTimesCosine(Surface s, AlbedoTable table, vec3 towardsViewer, vec3 towardsLight) {
    return evaluateBrdf(s, table, towardsViewer, towardsLight).timesCosine;
}
CLEAVE_FN float brdfDensity(Surface s, AlbedoTable table, vec3 towardsViewer, vec3 towardsLight) {
    return evaluateBrdf(s, table, towardsViewer, towardsLight).density;
}

// A direction to look for light in. Density 0: none, since the facet sends the viewer's ray into the surface.
struct BrdfSample {
    vec3 direction;
    vec3 weight;  // the BRDF times the cosine, divided by the density
    float density;
};
CLEAVE_SIZE(BrdfSample, 28);

CLEAVE_FN BrdfSample sampleBrdf(Surface s, AlbedoTable table, vec3 towardsViewer, vec3 u) {
    BrdfSample r;
    r.direction = vec3(0.0f, 0.0f, 1.0f);
    r.weight = vec3(0.0f);
    r.density = 0.0f;
    Lobes l = lobesOf(s, table);
    SpecularAlbedo viewerAlbedo = lookedUpAlbedo(table, l.roughness, towardsViewer.z);
    vec2 across = vec2(u.y, u.z);
    LobeChances chances = lobeChances(l, viewerAlbedo);
    precise float facetOrHorizon = chances.facet + chances.horizon;
    precise vec3 direction;
    if (u.x < chances.facet) {
        vec3 facet = visibleFacet(l.alpha, towardsViewer, across);
        direction = facet * (2.0f * preciseDot(towardsViewer, facet)) - towardsViewer;
    } else if (u.x < facetOrHorizon) {
        direction = horizonDirection(across);
    } else {
        direction = cosineDirection(across);
    }
    BrdfValue value = lobesTowards(l, table, viewerAlbedo, towardsViewer, direction);
    if (!(value.density > 0.0f)) return r;
    precise vec3 weight = value.timesCosine / value.density;
    r.direction = direction;
    r.weight = weight;
    r.density = value.density;
    return r;
}

CLEAVE_END
#endif
