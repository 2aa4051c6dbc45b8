// The metallic-roughness BRDF of glTF 2.0 (appendix B of its specification): GGX with the height-correlated Smith term
// and Schlick's Fresnel. Directions are of unit length, point away from the surface, and are in a frame whose z is the
// shading normal.
//
// The specification's diffuse part, (1 - F) / pi, neither keeps energy nor knows of what microfacets scatter more than
// once. Here a surface reflects what Kulla and Conty (2017) give it: the specular lobe; a lobe of what bounces between
// facets, which has the shape loss(v) loss(l); and, of dielectrics, under both a diffuse lobe of the shape under(v)
// under(l), where under is what the base colour has beyond the other two. So a dielectric reflects its base colour in
// all, whatever the direction, unless its facets alone reflect more (and 4 per cent more than that where they do so
// near the horizon); white surfaces reflect all that comes in, dielectric or metal; nothing reflects more; and light
// that goes the other way is reflected alike. It rests on a table of the specular lobe's directional albedo, and holds
// as exactly as its lookup: to 0.004 at worst, near the horizon of a nearly smooth surface, and 0.0002 on average.
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
    vec3 f0;          // of the specular lobe
    vec3 scattered;   // colour of what bounces between facets
    vec3 baseColour;  // of the diffuse lobe
    float dielectric;
    float scatteredUnder;  // colour of what bounces between the facets of a dielectric
    SpecularAlbedo mean;
};

CLEAVE_CONST float kDielectricF0 = 0.04f;

// The colour of bounces between facets whose Fresnel reflection is f0: light is reflected by its mean each time, and
// leaves with the mean albedo.
CLEAVE_FN float scatteredBy(float f0, SpecularAlbedo mean) {
    precise float fresnel = (f0 * 20.0f + 1.0f) / 21.0f;
    precise float scattered = fresnel * fresnel * (1.0f - mean.loss) / (1.0f - fresnel * mean.loss);
    return scattered;
}

CLEAVE_FN Lobes lobesOf(Surface s, AlbedoTable table) {
    Lobes r;
    r.roughness = min(max(kLeastRoughness, s.roughness), 1.0f);
    precise float alpha = r.roughness * r.roughness;
    precise float dielectric = 1.0f - s.metallic;
    precise vec3 f0 = s.baseColour * s.metallic + vec3(kDielectricF0) * dielectric;
    r.alpha = alpha;
    r.f0 = f0;
    r.mean = meanAlbedo(table, r.roughness);
    r.scattered = vec3(scatteredBy(f0.x, r.mean), scatteredBy(f0.y, r.mean), scatteredBy(f0.z, r.mean));
    r.baseColour = s.baseColour;
    r.dielectric = dielectric;
    r.scatteredUnder = scatteredBy(kDielectricF0, r.mean);
    return r;
}

CLEAVE_FN vec3 specularShare(Lobes l, SpecularAlbedo a) {
    precise vec3 share = l.f0 * (1.0f - a.loss) + (vec3(1.0f) - l.f0) * a.edge;
    return share;
}

// What a dielectric's base colour has beyond what its facets reflect of light from a direction of this albedo.
CLEAVE_FN vec3 underOf(Lobes l, SpecularAlbedo a) {
    precise float facets =
        kDielectricF0 * (1.0f - a.loss) + (1.0f - kDielectricF0) * a.edge + l.scatteredUnder * a.loss;
    precise vec3 under = l.baseColour - vec3(facets);
    return max(under, vec3(0.0f));
}

// The BRDF of both broad lobes, between directions of these albedos. Where facets outshine the base colour in most
// directions, the mean of what is under them is not that of the mean albedo: then it is twice the lesser of both at
// most.
CLEAVE_FN vec3 broadBrdf(Lobes l, SpecularAlbedo viewer, SpecularAlbedo light) {
    precise float bounces = viewer.loss * light.loss / l.mean.loss;
    vec3 from = underOf(l, viewer);
    vec3 to = underOf(l, light);
    precise vec3 under = from * to / max(underOf(l, l.mean), vec3(1.0e-6f));
    precise vec3 most = min(from, to) * 2.0f;
    precise vec3 value = (l.scattered * bounces + min(under, most) * l.dielectric) * kInversePi;
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
    precise vec3 broad = bounces + underOf(l, viewer) * l.dielectric;
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
