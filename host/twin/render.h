// The passes of a picture on the CPU. Each does to the arrays what the kernel of the same name
// (shaders/render/<name>.comp) does to the device's.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/surface_data.h"
#include "shared/picture_args.h"
#include "shared/tone.h"

namespace cleave {

// As PictureArgs, but with the arrays themselves, a ray per pixel in the order of pixelOf(); of shadow rays perhaps a
// second one after all of these.
struct PictureArrays {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<StepCount> steps;
    std::vector<Ray> shadowRays;
    std::vector<Hit> shadowHits;
    std::vector<vec3> throughput, direct, radiance;
    std::vector<float> density;
    std::vector<uint32_t> paths, shadowPaths;
    std::vector<vec4> unlit;
    std::vector<uint32_t> pixels;
    PictureState state{};
    Box bounds{};      // of the tree
    int exponent = 0;  // of the tree
    std::vector<Triangle> triangles;
    SurfaceData surfaces;
    std::vector<LightSource> lights;
    std::vector<AliasSlot> emitters;
    std::vector<SpecularAlbedo> albedo;
    ImageCamera camera{};
    uint32_t view = kViewShaded;
    uint32_t samples = 1;
    float exposure = 1.0f;
    PathSettings settings{};
    float ambientReach = 0.0f;
};

// As PicturePush.
struct PassNumbers {
    uint32_t round = 0;
    uint32_t path = 0;
};

namespace twin {

void cameraRays(PictureArrays& a, PassNumbers numbers);
void depthScale(PictureArrays& a, PassNumbers numbers);
void countHistogram(PictureArrays& a, PassNumbers numbers);
void selectCount(PictureArrays& a, PassNumbers numbers);
void shadowRays(PictureArrays& a, PassNumbers numbers);
void shade(PictureArrays& a, PassNumbers numbers);
void pathScatter(PictureArrays& a, PassNumbers numbers);
void pathGather(PictureArrays& a, PassNumbers numbers);
void tone(PictureArrays& a, PassNumbers numbers);

// The triangle of a hit in the scaled space of the tree.
Triangle hitTriangle(const PictureArrays& a, const Hit& hit);

}  // namespace twin
}  // namespace cleave
