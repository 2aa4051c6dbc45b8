// Makes the table that shaders/shared/specular_albedo.h looks the specular lobe's directional albedo up in.
#pragma once

#include <vector>

#include "shared/specular_albedo.h"

namespace cleave {

// What the lobe reflects of light at this cosine, to within 5e-4: by a quadrature in double of a fixed number of steps.
struct ExactAlbedo {
    double edge;
    double loss;
};
ExactAlbedo exactAlbedo(double roughness, double cosine);

// kAlbedoRows rows of kAlbedoStride entries, the same in every run. It takes about a tenth of a second.
std::vector<SpecularAlbedo> albedoTable();

}  // namespace cleave
