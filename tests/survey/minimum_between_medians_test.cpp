// Survey, section 4: the plane that minimises equation 4.1 lies between the object median and the spatial median. For
// point-like objects, R = n - L, this is so: with w the width of the cell, F half the area of its cut face and P the
// face's rim, f(b) = (F + P b) L(b) + (F + P (w - b)) (n - L(b)). Below both medians f's slope, P (2 L - n), is below
// zero, and where L grows by one, f changes by LSA - RSA < 0: it falls. Above both it rises.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "survey/box_scene.h"

namespace cleave {
namespace {

using Scene = test::BoxScene;
using test::sweep;

constexpr uint32_t kSeeds = 4000;

// All coordinates are integers, and so small that every cost is an exact integer, in float as well. Points strictly
// inside the cell, so that the object median is a plane that may be chosen: spread evenly, crowded towards a corner, or
// in two clumps.
Scene pointScene(uint32_t seed) {
    test::Random random(seed);
    Scene scene{{vec3(0), vec3(0)}, std::vector<Box>(1 + random.below(60))};
    for (int axis = 0; axis < 3; ++axis) scene.cell.hi[axis] = 2.0f * static_cast<float>(2 + random.below(19));
    for (Box& box : scene.boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            float x = random.unit();
            if (seed % 3 == 1) x = x * x * x;
            if (seed % 3 == 2) x = random.below(4) == 0 ? 0.1f * x : 0.8f + 0.2f * x;
            box.lo[axis] = 1.0f + std::floor(x * (scene.cell.hi[axis] - 1.0f));
        }
        box.hi = box.lo;
    }
    return scene;
}

// The same with boxes of up to `size` of the cell's width, cut off at the cell.
Scene boxScene(uint32_t seed, float size) {
    Scene scene = pointScene(seed);
    test::Random random(seed ^ 0x5EED5EEDu);
    for (Box& box : scene.boxes)
        for (int axis = 0; axis < 3; ++axis) {
            const float width = std::ceil(size * random.unit() * scene.cell.hi[axis]);
            box.hi[axis] = std::min(box.lo[axis] + width, scene.cell.hi[axis]);
        }
    return scene;
}

// Where the two medians are, and the sides of a plane: in twice the coordinates, so that centres are integers, too.
struct Range {
    int64_t lo, hi;
    bool holds(int64_t x) const { return lo <= x && x <= hi; }
};

// With an even number of objects all planes between the middle two halve them.
Range betweenMedians(const Scene& scene, int axis) {
    std::vector<int64_t> centres;
    for (const Box& box : scene.boxes) centres.push_back(static_cast<int64_t>(box.lo[axis] + box.hi[axis]));
    std::sort(centres.begin(), centres.end());
    const auto spatial = static_cast<int64_t>(scene.cell.hi[axis]);
    const size_t n = centres.size();
    return {std::min(centres[(n - 1) / 2], spatial), std::max(centres[n / 2], spatial)};
}

// LSA L + RSA R in half areas: equation 4.1 without its constant, 4.2 without its constants.
int64_t weightedCounts(const Scene& scene, int axis, int64_t plane, int64_t left, int64_t right) {
    const auto width = static_cast<int64_t>(scene.cell.hi[axis]);
    const auto a = static_cast<int64_t>(scene.cell.hi[(axis + 1) % 3]);
    const auto b = static_cast<int64_t>(scene.cell.hi[(axis + 2) % 3]);
    return (a * b + (a + b) * plane) * left + (a * b + (a + b) * (width - plane)) * right;
}

struct Candidate {
    int64_t plane, cost;
};

// Equation 4.1 at every integer, faces of the cell included, with the points in the plane on the one side and on the
// other. Between integers it is affine.
std::vector<Candidate> pointCosts(const Scene& scene, int axis) {
    std::vector<Candidate> costs;
    const auto n = static_cast<int64_t>(scene.boxes.size());
    for (int64_t plane = 0; plane <= static_cast<int64_t>(scene.cell.hi[axis]); ++plane) {
        int64_t before = 0, upTo = 0;
        for (const Box& box : scene.boxes) {
            before += box.lo[axis] < static_cast<float>(plane);
            upTo += box.lo[axis] <= static_cast<float>(plane);
        }
        costs.push_back({plane, weightedCounts(scene, axis, plane, before, n - before)});
        costs.push_back({plane, weightedCounts(scene, axis, plane, upTo, n - upTo)});
    }
    return costs;
}

int64_t leastOf(const std::vector<Candidate>& costs) {
    int64_t least = costs[0].cost;
    for (const Candidate& c : costs) least = std::min(least, c.cost);
    return least;
}

TEST(MinimumBetweenMedians, HoldsForPoints) {
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
        const Scene scene = pointScene(seed);
        for (int axis = 0; axis < 3; ++axis) {
            const Range medians = betweenMedians(scene, axis);
            const std::vector<Candidate> costs = pointCosts(scene, axis);
            const int64_t least = leastOf(costs);
            for (const Candidate& c : costs) {
                if (c.cost == least) {
                    ASSERT_TRUE(medians.holds(2 * c.plane)) << "seed " << seed << " axis " << axis << " at " << c.plane;
                }
            }
        }
    }
}

// What the exact builders choose is that minimum, unless the bonus for an empty side, which is not in 4.1, decides.
TEST(MinimumBetweenMedians, IsWhatTheSweepFindsForPoints) {
    uint32_t swept = 0, byBonus = 0;
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
        const Scene scene = pointScene(seed);
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = sweep(scene, axis);
            ASSERT_NE(split.axis, kLeafAxis) << "seed " << seed;
            int64_t left = 0;
            for (const Box& box : scene.boxes)
                left += box.lo[axis] < split.position || (box.lo[axis] == split.position && split.planarLeft == 1);
            ++swept;
            if (left == 0 || left == static_cast<int64_t>(scene.boxes.size())) {
                ++byBonus;
                continue;
            }
            const auto plane = static_cast<int64_t>(split.position);
            ASSERT_TRUE(betweenMedians(scene, axis).holds(2 * plane)) << "seed " << seed << " axis " << axis;
            const float constant = kCostTraverse * halfArea(scene.cell.hi - scene.cell.lo);
            ASSERT_EQ(split.cost, constant + kCostIntersect * static_cast<float>(leastOf(pointCosts(scene, axis))))
                << "seed " << seed << " axis " << axis;
        }
    }
    std::printf("points, seeds 0 to %u: %u sweeps, %u of them decided by the bonus for an empty side\n", kSeeds - 1,
                swept, byBonus);
    EXPECT_LT(byBonus, swept / 2) << "too few were looked at";
}

// Equation 4.2 counts straddling boxes twice. Ten boxes from 4 to 10 in a cell from 0 to 10: the plane at 4 cuts empty
// space off; the spatial median is 5, the object median 7.
TEST(MinimumBetweenMedians, DoesNotHoldForStraddlingBoxes) {
    Scene scene{{vec3(0), vec3(10)}, std::vector<Box>(10, Box{vec3(4, 0, 0), vec3(10, 10, 10)})};
    EXPECT_EQ(sweep(scene, 0).position, 4.0f);
    EXPECT_FALSE(betweenMedians(scene, 0).holds(2 * 4));
    // Nor is it about empty space only: with a box below that plane its sides hold 1 and 10, others 11 and 10.
    scene.boxes.push_back({vec3(0, 0, 0), vec3(2, 10, 10)});
    EXPECT_EQ(sweep(scene, 0).position, 4.0f);
    EXPECT_FALSE(betweenMedians(scene, 0).holds(2 * 4));
}

// How often it does not, in per cent of the planes, as docs/survey.md says: everything here is in exact integers. A
// plane is counted as outside if no plane of that cost lies between the medians.
TEST(MinimumBetweenMedians, IsMissedByStraddlingBoxesThisOften) {
    std::printf(
        "boxes, seeds 0 to %u: least cost (4.2) outside the medians\n  largest box  planes  outside  per cent\n",
        kSeeds - 1);
    constexpr std::array<std::pair<float, double>, 5> kShares{
        {{0.0f, 0.0}, {0.05f, 2.3}, {0.2f, 14.7}, {0.5f, 39.6}, {1.0f, 50.3}}};
    for (const auto& [size, share] : kShares) {
        uint32_t outside = 0;
        for (uint32_t seed = 0; seed < kSeeds; ++seed) {
            const Scene scene = boxScene(seed, size);
            for (int axis = 0; axis < 3; ++axis) {
                const Range medians = betweenMedians(scene, axis);
                std::optional<int64_t> inside, anywhere;
                for (int64_t plane = 0; plane <= static_cast<int64_t>(scene.cell.hi[axis]); ++plane) {
                    int64_t left = 0, right = 0, flat = 0;
                    for (const Box& box : scene.boxes) {
                        left += box.lo[axis] < static_cast<float>(plane);
                        right += box.hi[axis] > static_cast<float>(plane);
                        flat += box.lo[axis] == static_cast<float>(plane) && box.lo[axis] == box.hi[axis];
                    }
                    const int64_t cost = std::min(weightedCounts(scene, axis, plane, left + flat, right),
                                                  weightedCounts(scene, axis, plane, left, right + flat));
                    anywhere = std::min(anywhere.value_or(cost), cost);
                    if (medians.holds(2 * plane)) inside = std::min(inside.value_or(cost), cost);
                }
                outside += !inside || *inside > *anywhere;
            }
        }
        const double found = 100.0 * outside / (3 * kSeeds);
        std::printf("  %11.2f  %6u  %7u  %8.1f\n", static_cast<double>(size), 3 * kSeeds, outside, found);
        RecordProperty("outsideOf" + std::to_string(3 * kSeeds) + "AtSize" + std::to_string(size),
                       static_cast<int>(outside));
        EXPECT_NEAR(found, share, size == 0.0f ? 0.0 : 0.05) << "boxes of up to " << size;
    }
}

}  // namespace
}  // namespace cleave
