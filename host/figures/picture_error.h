// How far a picture is from another one of the same view.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/language.h"

namespace cleave {

// The root of the mean squared difference over all pixels and their three colours, over the mean of the reference: 1 is
// an error as large as the picture is bright. Infinite where the reference is black. Both have the same pixels.
double relativeRmse(std::span<const vec3> picture, std::span<const vec3> reference);

// The mean of pictures that were taken independently of each other, and its standard error in the sense of
// relativeRmse(): the spread of the parts over the root of their number. At least two parts.
struct MeanPicture {
    std::vector<vec3> radiance;
    double error = 0.0;
};
MeanPicture meanOfParts(std::span<const std::vector<vec3>> parts);

// What a picture of paths shows of radiance without exposure; R | G << 8 | B << 16 | A << 24, sRGB.
std::vector<uint32_t> shownPixels(std::span<const vec3> radiance);

// The mean structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004, "Image quality assessment: from error
// visibility to structural similarity") of the luma of two pictures, with the paper's window, a Gaussian of 11 x 11
// pixels, wherever it is within the picture, and its constants. 1: they are the same. Both sides are at least 11.
double structuralSimilarity(std::span<const uint32_t> one, std::span<const uint32_t> other, uint32_t width,
                            uint32_t height);

}  // namespace cleave
