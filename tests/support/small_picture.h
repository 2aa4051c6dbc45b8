// Mixed triangles of one material, and a picture to make of them.
#pragma once

#include "run/renderer.h"
#include "support/scenes.h"

namespace cleave::test {

struct SmallPicture {
    std::vector<Triangle> world;
    SurfaceData data;
    PictureRequest request;
};

inline SmallPicture smallPicture(uint32_t triangles, uint32_t seed) {
    SmallPicture small{mixedTriangles(triangles, seed), {}, {}};
    small.data.surfaceOf.assign(small.world.size(), 0);
    small.data.materials = {plainMaterial({0.8f, 0.5f, 0.2f, 1.0f}, vec3(0.0f), 0.0f, 1.0f, 0)};
    ImageCamera& camera = small.request.camera;
    camera.eye = {0.5, 0.5, 4.0};
    camera.forward = {0, 0, -1};
    camera.right = {1, 0, 0};
    camera.up = {0, 1, 0};
    camera.pixel = 0.6 / 60;
    camera.width = 77;
    camera.height = 60;
    camera.tMax = infinity();
    return small;
}

// The same surfaces, half of which rays look through.
inline SurfaceData blended(SurfaceData data) {
    data.materials[0].baseColour.w = 0.5f;
    data.materials[0].flags = kMaterialBlend;
    data.hasAlpha = true;
    return data;
}

}  // namespace cleave::test
