// The metallic-roughness BRDF of glTF 2.0 (appendix B of its specification): GGX with the height-correlated Smith term
// and Schlick's Fresnel. Directions are of unit length, point away from the surface, and are in a frame whose z is the
// shading normal.
//
// The specification's diffuse part, (1 - F) / pi, neither keeps energy nor knows of what microfacets scatter more than
// once. Here a surface reflects what Kulla and Conty (2017) give it: the specular lobe; a lobe of what bounces between
// facets, which has the shape loss(v) loss(l); and under both a diffuse lobe of the shape rest(v) rest(l), where rest
// is what the other two leave. White surfaces reflect all that comes in, dielectric or metal; nothing reflects more;
// and light that goes the other way is reflected alike. It rests on a table of the specular lobe's directional albedo,
// and holds as exactly as its lookup: to 0.006 at worst, near the horizon of a nearly smooth surface, and 0.0003 on
// average.
#ifndef CLEAVE_SHARED_BRDF_H
#define CLEAVE_SHARED_BRDF_H
#include "sampling.h"

CLEAVE_BEGIN

struct Surface {
    vec3 baseColour;  // linear, each component in [0, 1]
    float metallic;   // in [0, 1]
    float roughness;  // in [0, 1]
};
CLEAVE_SIZE(Surface, 20);

// Smoother surfaces look like this one: alpha, the square of the roughness, is 0.0016, and a reflection is spread over
// about 0.1 degrees. Float could not hold the lobe of a mirror.
CLEAVE_CONST float kLeastRoughness = 0.04f;
// Directions closer to the horizon count as below it, where there is no light.
CLEAVE_CONST float kLeastCosine = 1.0e-6f;

// What a specular lobe reflects of light from one direction in all: f0 (1 - loss) + (1 - f0) edge. That is f0 A + B of
// Karis (2013), with A = 1 - loss - edge and B = edge, but keeps the digits of a small loss.
struct SpecularAlbedo {
    float edge;  // by the part (1 - v.h)^5 of Schlick's Fresnel
    float loss;  // what would be lost if F were 1, since light that hits a second facet is left out
};
CLEAVE_SIZE(SpecularAlbedo, 8);

// A row per roughness, in equal steps of its square root from that of kLeastRoughness to 1. An entry per cosine, in
// equal steps of its fourth root from 0 to 1, and one more: the mean over the hemisphere, weighted by the cosine.
CLEAVE_CONST uint kAlbedoRows = 48u;
CLEAVE_CONST uint kAlbedoColumns = 48u;
CLEAVE_CONST uint kAlbedoStride = kAlbedoColumns + 1u;
CLEAVE_CONST float kLeastAlbedoRoot = 0.2f;  // of kLeastRoughness

#ifdef __cplusplus
struct AlbedoTable {
    const SpecularAlbedo* at;
};
#else
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer AlbedoTable { SpecularAlbedo at[]; };
#endif

CLEAVE_FN SpecularAlbedo mixedAlbedo(SpecularAlbedo a, SpecularAlbedo b, float t) {
    precise float edge = a.edge + (b.edge - a.edge) * t;
    precise float loss = a.loss + (b.loss - a.loss) * t;
    SpecularAlbedo r;
    r.edge = edge;
    r.loss = loss;
    return r;
}

// The row that a roughness lies at, or after.
CLEAVE_FN float albedoRow(float roughness) {
    precise float step = (1.0f - kLeastAlbedoRoot) / float(kAlbedoRows - 1u);
    precise float row = (sqrt(min(max(kLeastRoughness, roughness), 1.0f)) - kLeastAlbedoRoot) / step;
    return max(0.0f, row);
}

CLEAVE_FN SpecularAlbedo lookedUpAlbedo(AlbedoTable table, float roughness, float cosine) {
    float row = albedoRow(roughness);
    precise float column = float(kAlbedoColumns - 1u) * sqrt(sqrt(min(max(0.0f, cosine), 1.0f)));
    uint i = min(uint(row), kAlbedoRows - 2u);
    uint j = min(uint(column), kAlbedoColumns - 2u);
    uint k = i * kAlbedoStride + j;
    uint above = k + kAlbedoStride;
    precise float down = row - float(i);
    precise float along = column - float(j);
    return mixedAlbedo(mixedAlbedo(table.at[k], table.at[k + 1u], along),
                       mixedAlbedo(table.at[above], table.at[above + 1u], along), down);
}

CLEAVE_FN SpecularAlbedo meanAlbedo(AlbedoTable table, float roughness) {
    float row = albedoRow(roughness);
    uint i = min(uint(row), kAlbedoRows - 2u);
    uint k = i * kAlbedoStride + kAlbedoColumns;
    precise float down = row - float(i);
    return mixedAlbedo(table.at[k], table.at[k + kAlbedoStride], down);
}

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

CLEAVE_FN vec3 unitVector(vec3 v) {
    float scale = 1.0f / sqrt(preciseDot(v, v));
    precise vec3 unit = v * scale;
    return unit;
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
