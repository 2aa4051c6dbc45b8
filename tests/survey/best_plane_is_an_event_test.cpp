// Survey, section 4: between two faces of boxes the counts on either side are constant and the cost is affine, so that
// looking at the faces is enough. Judged by equation 4.2 as it stands there, in double, at many planes between them.
#include <gtest/gtest.h>

#include <algorithm>

#include "survey/box_scene.h"

namespace cleave {
namespace {

using Scene = test::BoxScene;
using test::sweep;

// From an exact input, ten roundings to the nearest float follow one another in splitCost(), of sums and products of
// numbers that are not negative: its relative error is at most ten times half an ulp (2^-24), and a bit.
constexpr double kCostError = 10.001 / 16777216.0;

// Boxes of all sizes in a cell that may be long or flat; some begin or end at its faces, some are flat, and in every
// second scene faces are snapped to a grid, so that many coincide.
Scene sceneOf(uint32_t seed) {
    test::Random random(seed);
    Scene scene{{random.point(-2, 2), vec3(0)}, std::vector<Box>(1 + random.below(40))};
    scene.cell.hi = scene.cell.lo + random.point(0.01f, 3);
    for (Box& box : scene.boxes)
        for (int axis = 0; axis < 3; ++axis) {
            float from = random.unit(), to = from + random.unit() * random.unit();
            if (random.below(8) == 0) to = from;
            if (seed % 2 == 0) from = std::round(from * 16.0f) / 16.0f, to = std::round(to * 16.0f) / 16.0f;
            const float lo = scene.cell.lo[axis], hi = scene.cell.hi[axis];
            box.lo[axis] = std::clamp(lo + from * (hi - lo), lo, hi);
            box.hi[axis] = std::clamp(lo + to * (hi - lo), lo, hi);
        }
    return scene;
}

struct Counts {
    uint32_t left = 0, right = 0;
    bool operator==(const Counts&) const = default;
};

// Of a plane in which no box lies flat.
Counts countsAt(const Scene& scene, int axis, double plane) {
    Counts counts;
    for (const Box& box : scene.boxes) {
        counts.left += double{box.lo[axis]} < plane;
        counts.right += double{box.hi[axis]} > plane;
    }
    return counts;
}

double surfaceArea(dvec3 lo, dvec3 hi) {
    const dvec3 e = hi - lo;
    return 2.0 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

// Equation 4.2, and Wald and Havran's bonus.
double costOf(const Scene& scene, int axis, double plane, Counts counts) {
    const dvec3 lo(scene.cell.lo), hi(scene.cell.hi);
    dvec3 leftHi = hi, rightLo = lo;
    leftHi[axis] = rightLo[axis] = plane;
    const double left = surfaceArea(lo, leftHi) * counts.left, right = surfaceArea(rightLo, hi) * counts.right;
    const double cost = 15.0 + 20.0 * (left + right) / surfaceArea(lo, hi);
    return counts.left == 0 || counts.right == 0 ? 0.8 * cost : cost;
}

// The cost of the plane that was chosen, by counting again; infinite if there is none.
double costOfChosen(const Scene& scene, int axis, const Split& split) {
    if (split.axis == kLeafAxis) return std::numeric_limits<double>::infinity();
    Counts counts = countsAt(scene, axis, split.position);
    for (const Box& box : scene.boxes)
        if (box.lo[axis] == split.position && box.hi[axis] == split.position)
            ++(split.planarLeft == 1 ? counts.left : counts.right);
    const double cost = costOf(scene, axis, split.position, counts);
    const double half = 0.5 * surfaceArea(dvec3(scene.cell.lo), dvec3(scene.cell.hi));
    EXPECT_NEAR(split.cost / half, cost, kCostError * cost);
    return cost;
}

std::vector<double> facesAlong(const Scene& scene, int axis) {
    std::vector<double> faces{scene.cell.lo[axis], scene.cell.hi[axis]};
    for (const Box& box : scene.boxes) faces.insert(faces.end(), {double{box.lo[axis]}, double{box.hi[axis]}});
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

// Planes between two neighbouring faces, against the plane that was chosen among all faces.
void expectNoneBetter(const Scene& scene, int axis, double from, double to, double chosen, uint32_t seed) {
    constexpr int kPlanes = 16;
    const Counts counts = countsAt(scene, axis, 0.5 * (from + to));
    // Affine to within the rounding of double, so that an end of the interval is at least as good.
    const double atFrom = costOf(scene, axis, from, counts), atTo = costOf(scene, axis, to, counts);
    double bound = chosen;
    // The cell's own face is no plane to choose. Beside it the cost may fall towards it.
    if (from == double{scene.cell.lo[axis]}) bound = std::min(bound, atFrom);
    if (to == double{scene.cell.hi[axis]}) bound = std::min(bound, atTo);
    for (int i = 1; i < kPlanes; ++i) {
        const double share = static_cast<double>(i) / kPlanes, plane = from + share * (to - from);
        if (plane <= from || plane >= to) continue;
        ASSERT_EQ(countsAt(scene, axis, plane), counts) << "seed " << seed;
        const double cost = costOf(scene, axis, plane, counts);
        ASSERT_NEAR(cost, atFrom + share * (atTo - atFrom), 1e-9 * cost) << "seed " << seed;
        // The chosen one was compared in float, and so was the best one: each may be off by kCostError.
        ASSERT_GE(cost * (1.0 + 2.0 * kCostError), bound) << "seed " << seed << " axis " << axis << " at " << plane;
    }
}

TEST(BestPlaneIsAnEvent, ADenseScanNeverBeatsIt) {
    uint32_t intervals = 0, chosenInside = 0;
    constexpr uint32_t kSeeds = 1500;
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
        const Scene scene = sceneOf(seed);
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = sweep(scene, axis);
            const double chosen = costOfChosen(scene, axis, split);
            const std::vector<double> faces = facesAlong(scene, axis);
            if (split.axis != kLeafAxis) {
                ++chosenInside;
                ASSERT_TRUE(std::binary_search(faces.begin(), faces.end(), double{split.position})) << "seed " << seed;
            }
            for (size_t i = 1; i < faces.size(); ++i)
                expectNoneBetter(scene, axis, faces[i - 1], faces[i], chosen, seed);
            if (HasFatalFailure()) return;
            intervals += static_cast<uint32_t>(faces.size() - 1);
        }
    }
    std::printf("seeds 0 to %u: %u intervals of 15 planes\n", kSeeds - 1, intervals);
    EXPECT_GT(chosenInside, 2 * kSeeds);
}

}  // namespace
}  // namespace cleave
