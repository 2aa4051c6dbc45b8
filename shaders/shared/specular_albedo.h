// What the specular lobe of brdf.h reflects in all, in a table that host/render/albedo_table makes.
#ifndef CLEAVE_SHARED_SPECULAR_ALBEDO_H
#define CLEAVE_SHARED_SPECULAR_ALBEDO_H
#include "language.h"

CLEAVE_BEGIN

// Smoother surfaces look like this one: alpha, the square of the roughness, is 0.0016, and a reflection is spread over
// about 0.1 degrees. Float could not hold the lobe of a mirror.
CLEAVE_CONST float kLeastRoughness = 0.04f;

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

CLEAVE_TABLE(AlbedoTable, SpecularAlbedo);

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

CLEAVE_END
#endif
