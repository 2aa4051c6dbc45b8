#include "builders/adaptive_samples.h"

#include <algorithm>
#include <array>

#include "shared/sah.h"

namespace cleave {
namespace {

// Number of positions counted in one pass over the boxes: few enough that all counters stay in registers.
constexpr size_t kLanes = 8;

double difference(const CostSample& s) { return static_cast<double>(s.left) - static_cast<double>(s.right); }

// The i-th of `parts` places between a and b. It never lies outside of [a, b], whatever the rounding.
float between(float a, float b, uint32_t i, uint32_t parts) {
    const float step = (b - a) * (static_cast<float>(i) / static_cast<float>(parts));
    return std::clamp(a + step, a, b);
}

// Number of the q marks, spread uniformly over [-n, n], that are at most `value`.
uint64_t marksUpTo(double value, double n, uint32_t q) {
    const double place = (value + n) / (2.0 * n) * (q + 1.0);
    return static_cast<uint64_t>(std::clamp(place, 0.0, static_cast<double>(q)));
}

}  // namespace

void countSides(const BoxExtents& boxes, std::span<CostSample> samples) {
    for (size_t first = 0; first < samples.size(); first += kLanes) {
        const auto block = samples.subspan(first, std::min(kLanes, samples.size() - first));
        std::array<float, kLanes> x{};
        for (size_t k = 0; k < block.size(); ++k) x[k] = block[k].position;
        std::array<uint32_t, kLanes> left{}, right{};
        for (size_t i = 0; i < boxes.lo.size(); ++i) {
            const float lo = boxes.lo[i], hi = boxes.hi[i];
            for (size_t k = 0; k < kLanes; ++k) {
                left[k] += lo < x[k] ? 1u : 0u;
                right[k] += hi > x[k] ? 1u : 0u;
            }
        }
        for (size_t k = 0; k < block.size(); ++k) block[k] = {x[k], left[k], right[k]};
    }
}

// The bound (the paper's appendix A): the uniform samples are W / (q + 1) apart, for W = to - from. left - right never
// falls, and grows from -n to n in all; q marks, 2n / (q + 1) apart, are laid over its values. An interval between
// uniform samples with m marks grows by less than (m + 1) 2n / (q + 1), and m samples are spread in it, so that its
// pieces are W / ((q + 1) (m + 1)) long. A piece grows by no more than its interval does, and m + 1 cancels:
// length x growth <= W 2n / (q + 1)^2.
void takeAdaptiveSamples(const BoxExtents& boxes, float from, float to, uint32_t q, std::vector<CostSample>& samples) {
    const auto n = static_cast<uint32_t>(boxes.lo.size());
    samples.clear();
    samples.push_back({from, 0, n});  // planar boxes at the ends are tried on the side where the others are
    for (uint32_t i = 1; i <= q; ++i) samples.push_back({between(from, to, i, q + 1), 0, 0});
    countSides(boxes, std::span(samples).subspan(1));
    samples.push_back({to, n, 0});

    for (uint32_t i = 0; i <= q; ++i) {
        const CostSample a = samples[i], b = samples[i + 1];
        const auto marks = static_cast<uint32_t>(marksUpTo(difference(b), n, q) - marksUpTo(difference(a), n, q));
        for (uint32_t k = 1; k <= marks; ++k) samples.push_back({between(a.position, b.position, k, marks + 1), 0, 0});
    }
    countSides(boxes, std::span(samples).subspan(q + 2));
    std::inplace_merge(samples.begin(), samples.begin() + q + 2, samples.end(),
                       [](const CostSample& a, const CostSample& b) { return a.position < b.position; });
}

// With p in [0, 1] from a to b, the cost (A + p dA)(L + p dL) + (B - p dA)(R + p dR) is a parabola, open upwards since
// L never falls and R never grows.
Valley valleyBetween(const CostSample& a, const CostSample& b, const Box& cell, uint32_t axis) {
    const auto areaLeft = [&](float x) { return halfArea(leftOf(cell, axis, x).hi - cell.lo); };
    const auto areaRight = [&](float x) { return halfArea(cell.hi - rightOf(cell, axis, x).lo); };
    const float leftA = areaLeft(a.position), rightA = areaRight(a.position);
    const float growLeft = areaLeft(b.position) - leftA, growRight = areaRight(b.position) - rightA;
    const auto countLeft = static_cast<float>(a.left), countRight = static_cast<float>(a.right);
    const float moreLeft = static_cast<float>(b.left) - countLeft, moreRight = static_cast<float>(b.right) - countRight;

    const float square = growLeft * moreLeft + growRight * moreRight;
    const float slope = leftA * moreLeft + growLeft * countLeft + rightA * moreRight + growRight * countRight;
    float p = slope < 0.0f ? 1.0f : 0.0f;
    if (square > 0.0f) p = std::clamp(-slope / (2.0f * square), 0.0f, 1.0f);
    const float position = std::clamp(a.position + p * (b.position - a.position), a.position, b.position);
    return {position, leftA * countLeft + rightA * countRight + p * (slope + p * square)};
}

}  // namespace cleave
