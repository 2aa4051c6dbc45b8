// Costs of eight planes at once. For the source files of choosers only: what includes this is compiled with GCC's and
// Clang's vectors, and its functions are inlined into clones for several machines.
#pragma once

#include <cstring>

#include "shared/sah.h"

// One text, compiled for AVX2 and for any machine; the program picks at its start. Both give the same bits, since every
// operation is rounded by itself. (The thread sanitizer is not up yet when the program picks.)
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define CLEAVE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLEAVE_CLONES
#endif
#define CLEAVE_INLINE inline __attribute__((always_inline))

namespace cleave {
namespace {  // a clone's functions are its own, or the linker would take the first that it finds

constexpr size_t kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = int32_t __attribute__((vector_size(4 * kLanes)));  // of comparisons: -1 where they hold

CLEAVE_INLINE Floats loadFloats(const float* from) {
    Floats x;
    std::memcpy(&x, from, sizeof x);
    return x;
}

CLEAVE_INLINE Floats flushed(Floats x) {
    const Ints bits = reinterpret_cast<Ints>(x);
    return reinterpret_cast<Floats>(bits & ((bits & 0x7F800000) != 0));
}

CLEAVE_INLINE Floats lowest(Floats a, Floats b) { return b < a ? b : a; }
CLEAVE_INLINE Floats highest(Floats a, Floats b) { return a < b ? b : a; }

// Of all lanes.
CLEAVE_INLINE float lowestOf(Floats x) {
    x = lowest(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = lowest(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = lowest(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
    return x[0];
}

// splitCost of shared/sah.h, operation by operation, with what does not change along an axis kept.
struct AxisCost {
    float lo, hi, face, rim, start, intersect, leaf, emptyBonus;

    CLEAVE_INLINE AxisCost(SahCosts sah, const Box& cell, uint32_t axis)
        : lo(cell.lo[static_cast<int>(axis)]), hi(cell.hi[static_cast<int>(axis)]) {
        const vec3 e = cell.hi - cell.lo;
        const float a = axis == 0 ? e.y : e.x, b = axis == 2 ? e.y : e.z;
        face = cleave::flushed(a * b);
        rim = a + b;
        intersect = sah.intersect;
        leaf = sah.leaf;
        emptyBonus = sah.emptyBonus;
        start = sah.traverse * (cleave::flushed(rim * e[static_cast<int>(axis)]) + face);
    }

    CLEAVE_INLINE Floats at(Floats position, Ints left, Ints right) const {
        const Floats leftArea = flushed(rim * (position - lo)) + face;
        const Floats rightArea = flushed(rim * (hi - position)) + face;
        const Floats both =
            leftArea * __builtin_convertvector(left, Floats) + rightArea * __builtin_convertvector(right, Floats);
        const Floats cost = start + intersect * both + leaf * (leftArea + rightArea);
        return ((left == 0) | (right == 0)) ? emptyBonus * cost : cost;
    }

    CLEAVE_INLINE Ints isInside(Floats position) const { return (lo < position) & (position < hi); }
};

// The best plane of each lane; of equal ones the first axis, then the lowest position.
struct LaneBest {
    Floats cost = Floats{} + infinity();
    Floats position = Floats{} + infinity();
    Ints axis = Ints{} + static_cast<int32_t>(kLeafAxis);
    Ints planarLeft = Ints{} + 1;
};

// Axes come in ascending order. A plane at one position must always come with the same cost and side.
CLEAVE_INLINE void keepBetter(LaneBest& best, Floats cost, Floats position, int32_t axis, Ints planarLeft) {
    const Ints isFirst = (best.axis == axis) & (position < best.position);
    const Ints better = (cost < best.cost) | ((cost == best.cost) & isFirst);
    best.cost = better ? cost : best.cost;
    best.position = better ? position : best.position;
    best.axis = better ? Ints{} + axis : best.axis;
    best.planarLeft = better ? planarLeft : best.planarLeft;
}

// The best of all lanes; no split if its cost is infinite.
CLEAVE_INLINE Split bestOf(const LaneBest& lanes) {
    const float cost = lowestOf(lanes.cost);
    Split best = noSplit();
    if (!(cost < infinity())) return best;
    for (size_t i = 0; i < kLanes; ++i) {
        if (lanes.cost[i] != cost) continue;
        const Split split{cost, static_cast<uint32_t>(lanes.axis[i]), lanes.position[i],
                          static_cast<uint32_t>(lanes.planarLeft[i])};
        if (isBetter(split, best)) best = split;
    }
    return best;
}

}  // namespace
}  // namespace cleave
