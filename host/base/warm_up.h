// Gets a device up to speed before it is timed.
#pragma once

#include "base/stopwatch.h"

namespace cleave {

// A GPU at rest runs at a fraction of its clock (an H200 at 345 of 1,980 MHz), and takes tens of milliseconds of work
// to raise it: what is shorter would be timed at whichever clock there is by chance.
inline constexpr double kWarmUpMs = 150.0;

// Does what is timed next, untimed: once, and again until kWarmUpMs have gone by. The device must be at work nearly all
// of that time, and nothing else may come before what is timed: a clock falls as fast as it rises.
template <class Work>
void warmUp(const Work& work) {
    const Stopwatch watch;
    do work();
    while (watch.milliseconds() < kWarmUpMs);
}

}  // namespace cleave
