// Whole scenes: hits of the device against the reference, with trees of the GPU builder and of the exact one.
#include <gtest/gtest.h>

#include <cstring>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "run/gpu_builder.h"
#include "run/tracer.h"
#include "scene/camera.h"
#include "scene/ray_sets.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scene_files.h"

namespace cleave::test {

namespace {

constexpr uint64_t kChecked = 2048;

void expectAgreement(const Reference& reference, const std::vector<Ray>& rays, const Tracer::Result& result,
                     Query query) {
    const CheckResult checked = check(reference, rays, result.hits, query, kChecked);
    EXPECT_EQ(checked.mismatches, 0u) << checked.first;
    EXPECT_LE(checked.undecided, 1u);
    EXPECT_LE(checked.maxRelativeTError, 1e-6);
    EXPECT_EQ(result.cappedRays, 0u);
}

}  // namespace

TEST(Check, SceneFilesAgreeWithTheReference) {
    GpuBuilder& builder = sharedBuilder();
    Tracer& tracer = sharedTracer();
    for (const auto& file : sceneFiles(100000)) {
        SCOPED_TRACE(file.string());
        const PosedScene scene = pose(loadGltf(file));
        const TriangleSet set = makeTriangleSet(scene.triangles);
        const Reference reference(scene.triangles, set.included);
        const Box bounds = finiteBounds(scene.triangles);
        const DeviceTriangles triangles(device(), scene.triangles);
        const std::vector<Ray> primary = primaryRays(bounds, false, 128);
        std::vector<Hit> first;
        for (const auto& tree : {builder.build(triangles, BuildSettings{}).tree,
                                 uploadTree(device(), set, buildExact(set, BuildSettings{}))}) {
            const Tracer::Result result = tracer.trace(*tree, primary);
            expectAgreement(reference, primary, result, Query::closest);
            const auto points = surfacePoints(scene.triangles, bounds, primary, result.hits);
            if (!points.empty()) {
                const std::vector<Ray> diffuse = diffuseRays(points, 64);
                const std::vector<Ray> shadow = shadowRays(points, bounds, 64);
                expectAgreement(reference, diffuse, tracer.trace(*tree, diffuse), Query::closest);
                expectAgreement(reference, shadow, tracer.trace(*tree, shadow, {.query = Query::any}), Query::any);
            }
            // The answer is the minimum over all triangles, whatever the tree.
            if (first.empty()) first = result.hits;
            EXPECT_EQ(std::memcmp(first.data(), result.hits.data(), first.size() * sizeof(Hit)), 0);
        }
    }
}

// The reference does find fault: hits that are moved, missing or made up are mismatches.
TEST(Check, FindsWrongHits) {
    const PosedScene scene = pose(loadGltf(std::string(CLEAVE_SOURCE) + "/scenes/cornell.glb"));
    const TriangleSet set = makeTriangleSet(scene.triangles);
    const Reference reference(scene.triangles, set.included);
    Tracer& tracer = sharedTracer();
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const std::vector<Ray> rays = primaryRays(finiteBounds(scene.triangles), false, 64);
    std::vector<Hit> hits = tracer.trace(*tree, rays).hits;
    EXPECT_EQ(check(reference, rays, hits, Query::closest, rays.size()).mismatches, 0u);
    size_t hit = 0;
    while (hits[hit].prim == kNone) hit++;
    const Hit good = hits[hit];
    hits[hit].t *= 1.00001f;
    EXPECT_EQ(check(reference, rays, hits, Query::closest, rays.size()).mismatches, 1u);
    hits[hit] = missedHit();
    EXPECT_EQ(check(reference, rays, hits, Query::closest, rays.size()).mismatches, 1u);
    hits[hit] = good;
    hits[hit].prim = (good.prim + 7) % static_cast<uint32_t>(scene.triangles.size());
    EXPECT_EQ(check(reference, rays, hits, Query::closest, rays.size()).mismatches, 1u);
}

}  // namespace cleave::test
