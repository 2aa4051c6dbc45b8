#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

namespace {

// Square roots and quotients may differ by rounding between devices; and where a choice hangs on such a bit, a path may
// go another way.
bool isNear(const vec3& a, const vec3& b) {
    for (int k = 0; k < 3; k++)
        if (std::fabs(a[k] - b[k]) > 1e-4f * (1.0f + std::fabs(b[k]))) return false;
    return true;
}

// What a pass left for a path, wherever its rays are.
struct Goal {
    Ray ray, shadow;
    vec3 throughput, direct;
    float density;
};

std::vector<Goal> goals(const PictureArrays& a) {
    std::vector<Goal> all(a.rays.size());
    for (size_t i = 0; i < all.size(); i++) {
        Goal &path = all.at(a.paths[i]), &shadow = all.at(a.shadowPaths[i]);
        path.ray = a.rays[i];
        path.throughput = a.throughput[i];
        path.density = a.density[i];
        shadow.shadow = a.shadowRays[i];
        shadow.direct = a.direct[i];
    }
    return all;
}

// Each workgroup has its own paths, once each, those with a ray first.
void expectPacked(const std::vector<Ray>& rays, std::vector<uint32_t> paths) {
    for (size_t begin = 0; begin < rays.size(); begin += kGroup) {
        const size_t end = std::min<size_t>(begin + kGroup, rays.size());
        for (size_t i = begin + 1; i < end; i++)
            EXPECT_FALSE(isNoRay(rays[i - 1]) && !isNoRay(rays[i])) << "a ray at " << i << " after none";
        std::sort(paths.begin() + static_cast<long>(begin), paths.begin() + static_cast<long>(end));
        for (size_t i = begin; i < end; i++) EXPECT_EQ(paths[i], i);
    }
}

}  // namespace

TEST(PathScatter, EqualsTwinAtEverySizeAndBounce) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        for (const PassNumbers numbers : {PassNumbers{0, 0}, {0, 3}, {1, 0}, {3, 1}, {4, 2}}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", bounce " +
                         std::to_string(numbers.round) + ", sample " + std::to_string(numbers.path));
            PicturePair pair(size.width, size.height, View::path, seed++);
            const PictureArrays device = pair.onDevice(PictureKernels::path_scatter, numbers);
            pair.onTwin(PictureKernels::path_scatter, numbers);
            const PictureArrays& twin = pair.arrays;
            const std::vector<Goal> onDevice = goals(device), onTwin = goals(twin);
            size_t other = 0;
            for (size_t i = 0; i < device.rays.size(); i++) {
                const Goal &got = onDevice[i], &want = onTwin[i];
                const bool same =
                    isNear(device.radiance[i], twin.radiance[i]) &&
                    isNear(vec3(device.unlit[i]), vec3(twin.unlit[i])) && device.unlit[i].w == twin.unlit[i].w &&
                    isNear(got.direct, want.direct) && isNear(got.throughput, want.throughput) &&
                    isNear(vec3(got.density), vec3(want.density)) && isNear(got.ray.origin, want.ray.origin) &&
                    isNear(got.ray.direction, want.ray.direction) &&
                    isNear(got.shadow.direction, want.shadow.direction) && got.ray.tMax == want.ray.tMax;
                other += same ? 0 : 1;
            }
            expectPacked(device.rays, device.paths);
            expectPacked(device.shadowRays, device.shadowPaths);
            EXPECT_LE(other * 1000, device.rays.size()) << other << " of " << device.rays.size();
        }
    }
}

// The last bounce finds what shines and sends no more rays.
TEST(PathScatter, EndsAtTheLastBounce) {
    PicturePair pair(64, 1, View::path, 3);
    pair.arrays.settings.bounces = 2;
    pair.onTwin(PictureKernels::path_scatter, {2, 0});
    for (size_t i = 0; i < pair.arrays.rays.size(); i++) {
        EXPECT_TRUE(isNoRay(pair.arrays.rays[i]));
        EXPECT_TRUE(isNoRay(pair.arrays.shadowRays[i]));
    }
}

// A path that has ended finds nothing more, whatever its old hit says.
TEST(PathScatter, LeavesEndedPathsAlone) {
    PicturePair pair(64, 1, View::path, 3);
    const PictureArrays before = pair.arrays;
    pair.onTwin(PictureKernels::path_scatter, {1, 0});
    const std::vector<Goal> after = goals(pair.arrays);
    size_t ended = 0;
    for (size_t i = 0; i < before.rays.size(); i++) {
        if (!isNoRay(before.rays[i])) continue;
        ++ended;
        const uint32_t path = before.paths[i];
        EXPECT_EQ(pair.arrays.radiance[path], before.radiance[path]);
        EXPECT_EQ(after[path].direct, vec3(0.0f));
    }
    EXPECT_GT(ended, 0u);
}

}  // namespace cleave::test
