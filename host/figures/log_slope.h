// Power laws in measured figures: the slope of straight lines in double logarithmic axes.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace cleave {

struct LogPoint {
    double x = 0.0, y = 0.0;
};
using LogPoints = std::vector<LogPoint>;  // all above 0

// By least squares of log y over log x: one slope for all groups, whose lines lie where they will. Nothing where no
// group has two values of x.
std::optional<double> logSlope(std::span<const LogPoints> groups);

// Geometric means, which the line of least squares goes through. At least one point.
LogPoint centreOf(const LogPoints& points);

}  // namespace cleave
