#include "figures/log_slope.h"

#include <cmath>

namespace cleave {

LogPoint centreOf(const LogPoints& points) {
    double x = 0.0, y = 0.0;
    for (const LogPoint& p : points) {
        x += std::log(p.x);
        y += std::log(p.y);
    }
    const auto count = static_cast<double>(points.size());
    return {std::exp(x / count), std::exp(y / count)};
}

std::optional<double> logSlope(std::span<const LogPoints> groups) {
    double products = 0.0, squares = 0.0;
    for (const LogPoints& points : groups) {
        if (points.empty()) continue;
        const LogPoint centre = centreOf(points);
        for (const LogPoint& p : points) {
            const double across = std::log(p.x / centre.x);
            products += across * std::log(p.y / centre.y);
            squares += across * across;
        }
    }
    constexpr double kLeastSpread = 1e-12;  // below, equal values differ by rounding alone
    if (!(squares > kLeastSpread)) return std::nullopt;
    return products / squares;
}

}  // namespace cleave
