// What lets one header be read by GLSL and by C++. Headers in this folder hold data and pure functions only: value
// parameters, constructor casts, no swizzles, no inout. Structs use the scalar block layout, so offsets agree.
// `precise` stops GLSL from contracting a*b+c; C++ is compiled with -ffp-contract=off: the same text, the same bits.
#ifndef CLEAVE_SHARED_LANGUAGE_H
#define CLEAVE_SHARED_LANGUAGE_H

#ifdef __cplusplus
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

#define CLEAVE_BEGIN namespace cleave {
#define CLEAVE_END }
#define CLEAVE_FN inline
#define CLEAVE_CONST constexpr
#define CLEAVE_SIZE(Type, bytes) static_assert(sizeof(Type) == bytes, #Type " must have this size in GLSL too")
// The address of a device buffer; in GLSL a buffer_reference of the named type.
#define CLEAVE_ADDRESS(Type) uint64_t
#define precise

namespace cleave {
using glm::dvec3;
using glm::uvec2;
using glm::uvec4;
using glm::vec3;
using uint = uint32_t;

inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }
inline float abs(float x) { return std::fabs(x); }
inline float sqrt(float x) { return std::sqrt(x); }
inline float pow(float x, float y) { return std::pow(x, y); }
inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline uint min(uint a, uint b) { return b < a ? b : a; }
inline uint max(uint a, uint b) { return a < b ? b : a; }
inline int min(int a, int b) { return b < a ? b : a; }
inline int max(int a, int b) { return a < b ? b : a; }
inline uint lowestBit(uint x) { return static_cast<uint>(std::countr_zero(x)); }  // x is not 0
inline uint highestBit(uint x) { return 31u - static_cast<uint>(std::countl_zero(x)); }
}  // namespace cleave
#else
#define CLEAVE_BEGIN
#define CLEAVE_END
#define CLEAVE_FN
#define CLEAVE_CONST const
#define CLEAVE_SIZE(Type, bytes)
#define CLEAVE_ADDRESS(Type) Type
#define lowestBit(x) uint(findLSB(x))
#define highestBit(x) uint(findMSB(x))
#endif

CLEAVE_BEGIN

CLEAVE_CONST uint kNone = 0xFFFFFFFFu;  // no primitive, no node
CLEAVE_CONST float kSmallestNormal = 1.17549435e-38f;
CLEAVE_CONST float kLargestFloat = 3.40282347e38f;

CLEAVE_FN float infinity() { return uintBitsToFloat(0x7F800000u); }

// By bits, since a compiler may assume that a float is never NaN or infinite.
CLEAVE_FN bool isFinite(float x) { return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u; }
CLEAVE_FN bool isNan(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u; }

// A value below the smallest normal number becomes +0: devices may flush it or keep it, we always flush.
CLEAVE_FN float flushed(float x) { return (floatBitsToUint(x) & 0x7F800000u) == 0u ? 0.0f : x; }

// Order-preserving map from finite floats to unsigned integers, for atomicMin and atomicMax. -0 sorts below +0.
CLEAVE_FN uint orderedBits(float x) {
    uint b = floatBitsToUint(x);
    return (b & 0x80000000u) != 0u ? ~b : b | 0x80000000u;
}
CLEAVE_FN float fromOrderedBits(uint b) { return uintBitsToFloat((b & 0x80000000u) != 0u ? b & 0x7FFFFFFFu : ~b); }

// The next float above x (below, if `up` is false). x is finite; +-0 steps to the smallest normal number.
CLEAVE_FN float nextFloat(float x, bool up) {
    uint b = floatBitsToUint(x);
    if ((b & 0x7FFFFFFFu) == 0u) return up ? kSmallestNormal : -kSmallestNormal;
    bool away = (b >> 31) == (up ? 0u : 1u);
    return uintBitsToFloat(away ? b + 1u : b - 1u);
}

CLEAVE_END
#endif
