// The passes of a picture on the CPU. Each does to the arrays what the kernel of the same name
// (shaders/render/<name>.comp) does to the device's.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/shade.h"

namespace cleave {

// As PictureArgs, but with the arrays themselves, a ray per pixel in the order of pixelOf().
struct PictureArrays {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<StepCount> steps;
    std::vector<Ray> shadowRays;
    std::vector<Hit> shadowHits;
    std::vector<uint32_t> pixels;
    PictureState state{};
    Box bounds{};      // of the tree
    int exponent = 0;  // of the tree
    std::vector<Triangle> triangles;
    std::vector<uint32_t> materialOf;
    std::vector<glm::vec4> baseColours;
    ImageCamera camera{};
    uint32_t view = kViewShaded;
};

namespace twin {

void cameraRays(PictureArrays& a, uint32_t round);
void depthScale(PictureArrays& a, uint32_t round);
void countHistogram(PictureArrays& a, uint32_t round);
void selectCount(PictureArrays& a, uint32_t round);
void shadowRays(PictureArrays& a, uint32_t round);
void shade(PictureArrays& a, uint32_t round);

// The triangle of a hit in the scaled space of the tree.
Triangle hitTriangle(const PictureArrays& a, const Hit& hit);

}  // namespace twin
}  // namespace cleave
