// What a surface is made of, as the kernels of a picture get it.
#ifndef CLEAVE_SHARED_MATERIAL_H
#define CLEAVE_SHARED_MATERIAL_H
#include "language.h"

CLEAVE_BEGIN

CLEAVE_CONST uint kMaterialUnlit = 1u;  // shows its base colour as it is

struct Material {
    vec4 baseColour;  // linear RGBA, each in [0, 1]
    vec3 emission;    // radiance, linear
    float metallic;
    float roughness;
    uint flags;
};
CLEAVE_SIZE(Material, 40);

#ifndef __cplusplus
CLEAVE_ARRAY(MaterialArray, Material);
#endif

CLEAVE_END
#endif
