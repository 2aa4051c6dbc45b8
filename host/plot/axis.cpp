#include "plot/axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/text.h"

namespace cleave {
namespace {

constexpr double kMargin = 0.05;        // of the axis, at both ends
constexpr double kLeastSpan = 0.3;      // on a logarithmic scale: a factor of 2
constexpr double kManyDecades = 3.0;    // with more, powers of ten have to do
constexpr double kFewDecades = 0.7;     // with less, every digit has a tick
constexpr double kTicksOfLinear = 6.0;  // about

double onScale(Scale scale, double value) {
    switch (scale) {
        case Scale::linear:
            return value;
        case Scale::log:
            return std::log10(std::max(value, 1e-12));
        case Scale::signedLog:
            return std::copysign(std::log10(1.0 + std::abs(value)), value);
    }
    return value;
}

std::string labelOf(double value) {
    const double magnitude = std::abs(value);
    std::string text;
    if (magnitude >= 1000.0) {
        text = grouped(static_cast<uint64_t>(std::llround(magnitude)));
    } else {
        std::array<char, 32> buffer{};
        std::snprintf(buffer.data(), buffer.size(), "%.6g", magnitude);
        text = buffer.data();
    }
    return value < 0.0 ? "\u2212" + text : text;
}

}  // namespace

Axis::Axis(Scale scale, double least, double most) : scale_(scale) {
    double low = onScale(scale, least), high = onScale(scale, most);
    const double span = scale == Scale::linear ? std::max(1e-3, 1e-3 * std::abs(high)) : kLeastSpan;
    if (high - low < span) {
        const double middle = 0.5 * (low + high);
        low = middle - 0.5 * span;
        high = middle + 0.5 * span;
    }
    from_ = low - kMargin * (high - low);
    to_ = high + kMargin * (high - low);
}

double Axis::at(double value) const { return std::clamp((onScale(scale_, value) - from_) / (to_ - from_), 0.0, 1.0); }

void Axis::addTick(std::vector<Tick>& ticks, double value) const {
    const double place = onScale(scale_, value);
    if (place >= from_ && place <= to_) ticks.push_back({value, at(value), labelOf(value)});
}

std::vector<Tick> Axis::ticks() const {
    std::vector<Tick> ticks;
    if (scale_ == Scale::linear) {
        const double rough = (to_ - from_) / kTicksOfLinear;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        double step = 10.0 * power;
        for (const double s : {5.0, 2.0, 1.0})
            if (s * power >= rough) step = s * power;
        for (double n = std::ceil(from_ / step); n * step <= to_; ++n) addTick(ticks, n * step);
        return ticks;
    }
    const bool onlyPowers = to_ - from_ > kManyDecades;
    const bool everyDigit = to_ - from_ < kFewDecades;
    const bool isSigned = scale_ == Scale::signedLog;
    const int first = isSigned ? 0 : static_cast<int>(std::floor(from_));
    const int last = static_cast<int>(std::ceil(isSigned ? std::max(std::abs(from_), std::abs(to_)) : to_));
    if (isSigned) addTick(ticks, 0.0);
    for (int decade = first; decade <= last; ++decade)
        for (int digit = 1; digit <= 9; ++digit) {
            const bool isTick = digit == 1 || (!onlyPowers && (everyDigit || digit == 2 || digit == 5));
            if (!isTick) continue;
            addTick(ticks, digit * std::pow(10.0, decade));
            if (isSigned) addTick(ticks, -digit * std::pow(10.0, decade));
        }
    std::sort(ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) { return a.value < b.value; });
    return ticks;
}

}  // namespace cleave
