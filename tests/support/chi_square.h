// Pearson's test of counts against what was expected of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace cleave {

// How many standard deviations the counts are from what is expected of them: about normal if each was drawn with these
// odds, far above 0 if with others, far below if they are too even to be random. Cells that expect fewer than 10 are
// taken together.
inline double chiSquareDeviation(const std::vector<double>& counts, const std::vector<double>& expected) {
    double sum = 0.0, rareCount = 0.0, rareExpected = 0.0;
    double cells = -1.0;  // the total is given
    const auto add = [&](double count, double mean) {
        sum += (count - mean) * (count - mean) / mean;
        cells += 1.0;
    };
    for (size_t i = 0; i < counts.size(); i++) {
        if (expected[i] >= 10.0) {
            add(counts[i], expected[i]);
        } else {
            rareCount += counts[i];
            rareExpected += expected[i];
        }
    }
    if (rareExpected >= 10.0)
        add(rareCount, rareExpected);
    else if (rareCount > rareExpected + 20.0)
        return INFINITY;  // where next to nothing should be
    return (sum - cells) / std::sqrt(2.0 * cells);
}

// Of cells that are all alike.
inline double chiSquareDeviation(const std::vector<double>& counts) {
    double total = 0.0;
    for (const double count : counts) total += count;
    return chiSquareDeviation(counts, std::vector<double>(counts.size(), total / static_cast<double>(counts.size())));
}

}  // namespace cleave
