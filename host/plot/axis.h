// An axis of a plot: from values to places, and the values that are written beside it.
#pragma once

#include <string>
#include <vector>

namespace cleave {

// signedLog: for values of either sign that span decades; nearly linear below 1 in magnitude, logarithmic above:
// sign(v) log10(1 + |v|).
enum class Scale { linear, log, signedLog };

struct Tick {
    double value = 0.0;
    double at = 0.0;  // 0 to 1 along the axis
    std::string label;
};

class Axis {
  public:
    // Shows the values from `least` to `most` with a margin at both ends. On a logarithmic axis both are above 0.
    Axis(Scale scale, double least, double most);

    // Where a value is, 0 to 1; values outside of the axis are put at its ends.
    double at(double value) const;
    // Round values, ascending.
    std::vector<Tick> ticks() const;

  private:
    Scale scale_;
    double from_ = 0.0, to_ = 1.0;  // on the scale

    void addTick(std::vector<Tick>& ticks, double value) const;
};

}  // namespace cleave
