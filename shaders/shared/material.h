// What a surface is made of, as the kernels of a picture get it (glTF 2.0, section 3.9).
#ifndef CLEAVE_SHARED_MATERIAL_H
#define CLEAVE_SHARED_MATERIAL_H
#include "texture.h"

CLEAVE_BEGIN

// Material.flags.
CLEAVE_CONST uint kMaterialUnlit = 1u;  // shows its base colour as it is
CLEAVE_CONST uint kMaterialMask = 2u;   // where alpha is below the cutoff there is no surface
CLEAVE_CONST uint kMaterialBlend = 4u;  // alpha is how often a ray finds the surface
// Cameras do not see it from behind. Light is stopped by it from both sides: else it would shine through walls.
CLEAVE_CONST uint kMaterialSingleSided = 8u;

// Factors, and maps that they are multiplied by: numbers of TextureMap; kNone: there is none.
struct Material {
    vec4 baseColour;  // linear RGBA, each in [0, 1]
    vec3 emission;    // radiance, linear
    float metallic;
    float roughness;
    float normalScale;
    float occlusionStrength;
    float alphaCutoff;
    uint flags;
    uint baseColourMap;
    uint metallicRoughnessMap;  // roughness in G, metallic in B
    uint normalMap;             // a unit vector in tangent space, from [-1, 1]^3
    uint occlusionMap;          // in R
    uint emissionMap;
    float brightness;  // by which surfaces are looked for as lights; 0: they are found by chance alone
};
CLEAVE_SIZE(Material, 76);

CLEAVE_TABLE(MaterialArray, Material);

// How bright an emission is, for the choice among what shines: above 0 where it is in any colour.
CLEAVE_FN float brightnessOf(vec3 emission) {
    precise float sum = emission.x + emission.y + emission.z;
    return sum;
}

// Without maps.
CLEAVE_FN Material plainMaterial(vec4 baseColour, vec3 emission, float metallic, float roughness, uint flags) {
    Material m;
    m.baseColour = baseColour;
    m.emission = emission;
    m.metallic = metallic;
    m.roughness = roughness;
    m.normalScale = 1.0f;
    m.occlusionStrength = 1.0f;
    m.alphaCutoff = 0.5f;
    m.flags = flags;
    m.baseColourMap = kNone;
    m.metallicRoughnessMap = kNone;
    m.normalMap = kNone;
    m.occlusionMap = kNone;
    m.emissionMap = kNone;
    m.brightness = brightnessOf(emission);
    return m;
}

// The surface of a triangle: the number of its material and, perhaps, bits.
CLEAVE_CONST uint kMirrored = 0x80000000u;  // its front is the side from which its vertices go clockwise
CLEAVE_CONST uint kNoBack = 0x40000000u;    // its corners' normals point to its back: which side is which is not known
CLEAVE_FN uint materialNumber(uint surface) { return surface & ~(kMirrored | kNoBack); }

CLEAVE_FN bool isOpaque(Material m) { return (m.flags & (kMaterialMask | kMaterialBlend)) == 0u; }

CLEAVE_END
#endif
