// A scene with places against its copy: every triangle is there once, and is the same to the last bit.
#include "instances/instances.h"

#include <gtest/gtest.h>

#include <cstring>

#include "instances/mesh_shape.h"
#include "instances/place_mesh.h"
#include "support/instanced_scene.h"
#include "support/scenes.h"

namespace cleave::test {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

bool sameBits(const Triangle& a, const Triangle& b) { return std::memcmp(&a, &b, sizeof(Triangle)) == 0; }

TreeTriangle placedTriangle(const PlacedMesh& place, const TreeTriangle& t) {
    return {placedVertex(place, t.a), placedVertex(place, t.b), placedVertex(place, t.c), place.first + t.number};
}

Triangle withoutMinusZero(Triangle t) { return scaledTriangle(t, 0); }

uint32_t indexOfNumber(const Instances& made, uint32_t number) {
    const auto at = std::lower_bound(made.restNumbers.begin(), made.restNumbers.end(), number);
    return at != made.restNumbers.end() && *at == number ? uint32_t(at - made.restNumbers.begin()) : kNone;
}

// Every triangle of the copied scene is in the rest or in a place, which makes the same of it as the copied scene's
// tree; returns how many are in places.
size_t expectCopied(const Scene& scene) {
    const PosedScene copied = pose(scene);
    SharedPose shared = poseShared(scene, {}, sharingOf(scene, 64));
    EXPECT_EQ(shared.triangles, copied.triangles.size());
    EXPECT_EQ(shared.posed.warnings.size() + (nonFiniteWarning(copied.triangles) ? 1 : 0), copied.warnings.size());
    EXPECT_EQ(shared.posed.meshes.size(), copied.meshes.size());
    for (size_t i = 0; i < std::min(shared.posed.meshes.size(), copied.meshes.size()); ++i)
        EXPECT_EQ(shared.posed.meshes[i].triangles, copied.meshes[i].triangles);
    const Instances made = instancesOf(shared);
    EXPECT_EQ(made.triangles, copied.triangles.size());
    const TriangleSet set = makeTriangleSet(copied.triangles);
    EXPECT_EQ(made.exponent, set.exponent);
    for (size_t i = 0; i < made.rest.size(); ++i) {
        if (i > 0) {
            EXPECT_LT(made.restNumbers[i - 1], made.restNumbers[i]);
        }
        const Triangle& want = copied.triangles[made.restNumbers[i]];
        const bool isSame = sameBits(withoutMinusZero(made.rest[i]), withoutMinusZero(want));
        EXPECT_TRUE(isSame || !(isFiniteTriangle(made.rest[i]) || isFiniteTriangle(want)))
            << "number " << made.restNumbers[i];
    }
    std::vector<int> seen(copied.triangles.size(), 0);
    for (const uint32_t number : made.restNumbers) seen[number]++;
    size_t placed = 0;
    for (size_t p = 0; p < made.places.size(); ++p) {
        const PlacedMesh& place = made.places[p];
        if (place.isWorld != 0) continue;
        const TriangleSet tree = makeTriangleSet(made.meshes[made.treeOf[p]]);
        for (const uint32_t i : tree.included) {
            const TreeTriangle t = placedTriangle(place, treeTriangle(tree.triangles[i], i));
            seen[t.number]++;
            placed++;
            const Triangle want = scaledTriangle(copied.triangles[t.number], -set.exponent);
            EXPECT_TRUE(sameBits(withoutNumber(t), want)) << "place " << p << ", triangle " << i;
            EXPECT_EQ(indexOfNumber(made, t.number), kNone);
        }
    }
    for (const uint32_t number : set.included) EXPECT_EQ(seen[number], 1) << "number " << number;
    return placed;
}

TEST(Instances, MakeTheTrianglesOfTheCopiedScene) {
    for (uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        InstancedScene made;
        const uint32_t rock = made.mesh(mixedTriangles(100, seed)), tree = made.mesh(mixedTriangles(64, seed + 10));
        const uint32_t alone = made.mesh(mixedTriangles(70, seed + 20)), tiny = made.mesh(mixedTriangles(3, seed));
        made.node(alone, glm::dmat4(1.0));
        for (int i = 0; i < 12; ++i) {
            const double size = std::pow(10.0, double(i % 6) - 4.0);
            const uint32_t at =
                made.node(i % 2 == 0 ? rock : tree, placeAt(anyPoint(random, 10.0), anyAxes(random, size)));
            made.node(i % 3 == 0 ? tree : tiny, placeAt(anyPoint(random, 1.0), anyAxes(random, 1.0)), at);
        }
        EXPECT_GT(expectCopied(made.scene), 500u);
    }
}

TEST(Instances, HoldAtEveryScale) {
    for (const double size : {1e-30, 1e-7, 1e7, 1e30}) {
        SCOPED_TRACE("size " + std::to_string(size));
        std::mt19937 random(7);
        InstancedScene made;
        const uint32_t rock = made.mesh(mixedTriangles(80, 3));
        for (int i = 0; i < 5; ++i) made.node(rock, placeAt(anyPoint(random, 10.0 * size), anyAxes(random, size)));
        EXPECT_GT(expectCopied(made.scene), 300u);
    }
}

// Flat, not finite, too large for a float, far out and tiny: all of that is copied, with what else it concerns.
TEST(Instances, CopyWhatCannotBePlaced) {
    std::mt19937 random(5);
    InstancedScene made;
    const uint32_t rock = made.mesh(mixedTriangles(80, 3));
    const glm::dmat3 axes = anyAxes(random, 1.0);
    glm::dmat3 flat = axes;
    flat[2] = flat[0] + flat[1];
    std::vector<glm::dmat4> bad{placeAt({0, 0, 0}, flat), placeAt({0, 0, 0}, axes * 0.0), placeAt({kNaN, 0, 0}, axes),
                                placeAt({0, 0, 0}, axes * 1e39), placeAt({50, 0, 0}, axes * 1e-5)};
    for (size_t i = 0; i < bad.size(); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        InstancedScene one = made;
        one.node(rock, placeAt({1, 2, 3}, axes));
        one.node(rock, bad[i]);
        one.node(rock, placeAt({-1, 2, 3}, axes));
        EXPECT_EQ(expectCopied(one.scene) > 0, i != 3);
        SharedPose shared = poseShared(one.scene, {}, sharingOf(one.scene, 64));
        const Instances instances = instancesOf(shared);
        const size_t copied = i == 3 ? 3 : 1;  // beside the largest of all floats the others are points
        const size_t slivers = shapeOf(mixedTriangles(80, 3)).slivers.size();
        EXPECT_EQ(instances.copiedPlaces, copied);
        EXPECT_EQ(instances.rest.size(), 80 * copied + slivers * (3 - copied));
    }
}

TEST(Instances, CopyAllBesideASpeck) {
    std::mt19937 random(5);
    InstancedScene made;
    std::vector<Triangle> triangles = mixedTriangles(80, 3);
    for (const uint32_t sliver : shapeOf(triangles).slivers) triangles[sliver] = triangles[0];
    const uint32_t rock = made.mesh(triangles), speck = made.mesh(mixedTriangles(80, 4));
    made.node(speck, placeAt({0, 0, 0}, glm::dmat3(1e-12)));
    for (int i = 0; i < 3; ++i) made.node(rock, placeAt(anyPoint(random, 4.0), anyAxes(random, 1.0)));
    EXPECT_EQ(expectCopied(made.scene), 0u);
}

// A mesh with a coordinate that its tree's scale would round away, and one with a vertex that is not finite.
TEST(Instances, CopyMeshesThatTheirTreesWouldChange) {
    for (const float odd : {1e-40f, infinity(), std::nanf("")}) {
        std::vector<Triangle> triangles = mixedTriangles(80, 3);
        triangles[40].b.y = odd;
        InstancedScene made;
        std::mt19937 random(9);
        const uint32_t rock = made.mesh(triangles);
        for (int i = 0; i < 3; ++i) made.node(rock, placeAt(anyPoint(random, 4.0), anyAxes(random, 100.0)));
        EXPECT_EQ(expectCopied(made.scene), 0u);
    }
}

// Three vertices in a line, in the mesh: placed and rounded, they span a triangle now and then.
TEST(Instances, CopySlivers) {
    std::vector<Triangle> triangles = mixedTriangles(80, 3);
    triangles[10] = {{0, 0, 0}, {0.25f, 0.5f, 0.75f}, {0.5f, 1.0f, 1.5f}};
    triangles[20] = {{0.3f, 0.1f, 0.2f}, {0.3f, 0.1f, 0.2f}, {0.5f, 1.0f, 1.5f}};  // never spans anything
    InstancedScene made;
    std::mt19937 random(9);
    const uint32_t rock = made.mesh(triangles);
    for (int i = 0; i < 8; ++i) made.node(rock, placeAt(anyPoint(random, 4.0), anyAxes(random, 1.0)));
    EXPECT_GT(expectCopied(made.scene), 500u);
    const PosedScene copied = pose(made.scene);
    const TriangleSet set = makeTriangleSet(copied.triangles);
    EXPECT_LT(set.noArea, 16u);  // so that there was something to lose
    SharedPose shared = poseShared(made.scene, {}, sharingOf(made.scene, 64));
    const std::vector<uint32_t> slivers = shapeOf(triangles).slivers;
    EXPECT_TRUE(std::binary_search(slivers.begin(), slivers.end(), 10u));
    EXPECT_FALSE(std::binary_search(slivers.begin(), slivers.end(), 20u));
    EXPECT_EQ(instancesOf(shared).rest.size(), 8 * slivers.size());
}

TEST(Instances, ShareWhatKeepsItsShape) {
    InstancedScene made;
    const uint32_t moving = made.mesh(mixedTriangles(80, 1)), quotients = made.mesh(mixedTriangles(80, 2)),
                   whole = made.mesh(mixedTriangles(80, 3)), small = made.mesh(mixedTriangles(10, 4)),
                   once = made.mesh(mixedTriangles(80, 5));
    made.scene.meshes[moving].primitives[0].targets.resize(1);
    for (const uint32_t mesh : {quotients, whole})
        made.scene.accessors[mesh].componentType = gltf::ComponentType::int16;
    made.scene.accessors[quotients].normalized = true;
    for (const uint32_t mesh : {moving, quotients, whole, small})
        for (int i = 0; i < 3; ++i) made.node(mesh, glm::dmat4(1.0));
    made.node(once, glm::dmat4(1.0));
    const Sharing sharing = sharingOf(made.scene, 64);
    EXPECT_EQ(sharing.meshes, (std::vector<bool>{false, false, true, false, false}));
    EXPECT_EQ(sharing.copies, 160u);
    EXPECT_EQ(sharing.triangles, 3u * 250 + 80);
}

// A few bytes ask for millions of places.
TEST(Instances, AreNotMoreThanAMillion) {
    for (const uint64_t count : {uint64_t{1} << 20, (uint64_t{1} << 20) + 1}) {
        InstancedScene made;
        made.node(made.mesh(mixedTriangles(2, 1)), glm::dmat4(1.0));
        made.node(made.mesh(mixedTriangles(2, 2)), glm::dmat4(1.0));
        made.scene.nodes[0].instancing = gltf::Instancing{count, {}, {}, {}};
        made.scene.nodes[1].instancing = gltf::Instancing{2, {}, {}, {}};
        const bool fits = count == uint64_t{1} << 20;
        EXPECT_EQ(sharingOf(made.scene, 1).meshes, (std::vector<bool>{fits, !fits}));
    }
}

// The bound of a place, against points of its triangles in 80 bits.
TEST(Instances, BoundTheErrorOfTheWayBack) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double closest = 0.0;
    for (int k = 0; k < 300; ++k) {
        const std::vector<Triangle> triangles = mixedTriangles(20, uint32_t(k));
        const TriangleSet tree = makeTriangleSet(triangles);
        const double size = std::pow(10.0, -3.0 * unit(random));
        const glm::dmat4 toWorld = placeAt(anyPoint(random, k % 2 == 0 ? 0.0 : 1.0), anyAxes(random, size));
        const PlacedExtent extent = extentOf(shapeOf(triangles), toWorld);
        const int exponent = 1;
        const auto placed =
            placeMesh(toWorld, tree.exponent, exponent,
                      {timesPowerOfTwo(extent.box.lo, -exponent), timesPowerOfTwo(extent.box.hi, -exponent)});
        ASSERT_TRUE(placed) << "place " << k;
        for (const uint32_t i : tree.included) {
            const TreeTriangle t = tree.triangles.empty() ? TreeTriangle{} : treeTriangle(tree.triangles[i], i);
            PlacedMesh place = *placed;
            const TreeTriangle w = placedTriangle(place, t);
            const long double u = unit(random), v = unit(random) * (1.0 - double(u));
            long double from[3];
            for (int axis = 0; axis < 3; ++axis)
                from[axis] = (1 - u - v) * w.a[axis] + u * w.b[axis] + v * w.c[axis] -
                             std::ldexp((long double)(place.origin[axis]), -exponent);
            for (int axis = 0; axis < 3; ++axis) {
                const long double back =
                    place.inverseX[axis] * from[0] + place.inverseY[axis] * from[1] + place.inverseZ[axis] * from[2];
                const long double want = (1 - u - v) * t.a[axis] + u * t.b[axis] + v * t.c[axis];
                const double error = double(std::fabs(back - want));
                ASSERT_LE(error, double(place.error)) << "place " << k << ", triangle " << i;
                closest = std::max(closest, error / double(place.error));
            }
        }
    }
    EXPECT_GT(closest, 0.1);  // the bound is not far away
}

}  // namespace
}  // namespace cleave::test
