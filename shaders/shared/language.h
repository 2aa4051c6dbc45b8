// Lets GLSL and C++ include the same headers. Those in this folder hold data and pure functions only: parameters are
// passed by value, casts are constructor calls, and there are no swizzles and no inout. Structs have the scalar block
// layout, so that their offsets agree. `precise` stops GLSL from contracting a*b+c, as -ffp-contract=off stops C++: the
// same text gives the same bits.
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
// An array that functions of both languages read: in GLSL by its address, in C++ by a pointer.
#define CLEAVE_TABLE(Name, Element) \
    struct Name {                   \
        const Element* at;          \
    }

namespace cleave {
using glm::dvec3;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;

inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }
inline float abs(float x) { return std::fabs(x); }
inline double abs(double x) { return std::fabs(x); }
inline float sqrt(float x) { return std::sqrt(x); }
inline double sqrt(double x) { return std::sqrt(x); }
inline double powerOfTwo(int e) { return std::bit_cast<double>(static_cast<uint64_t>(e + 1023) << 52); }
inline float pow(float x, float y) { return std::pow(x, y); }
inline float floor(float x) { return std::floor(x); }
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
#define CLEAVE_TABLE(Name, Element) \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Name { Element at[]; }
uint lowestBit(uint x) { return uint(findLSB(x)); }
uint highestBit(uint x) { return uint(findMSB(x)); }
// e from -1022 to 1023.
double powerOfTwo(int e) { return packDouble2x32(uvec2(0u, uint(e + 1023) << 20)); }
#endif

CLEAVE_BEGIN

CLEAVE_CONST uint kNone = 0xFFFFFFFFu;  // no primitive, no node
CLEAVE_CONST float kSmallestNormal = 1.17549435e-38f;
CLEAVE_CONST float kLargestFloat = 3.40282347e38f;

CLEAVE_FN float infinity() { return uintBitsToFloat(0x7F800000u); }

// Looks at the bits, since a compiler may assume that a float is never NaN or infinite.
CLEAVE_FN bool isFinite(float x) { return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u; }
CLEAVE_FN bool isNan(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u; }

// Replaces what is below the smallest normal number by +0. Devices may flush denormals or keep them; this always does.
CLEAVE_FN float flushed(float x) { return (floatBitsToUint(x) & 0x7F800000u) == 0u ? 0.0f : x; }

// Maps finite floats to unsigned integers of the same order, for atomicMin and atomicMax. -0 comes before +0.
CLEAVE_FN uint orderedBits(float x) {
    uint b = floatBitsToUint(x);
    return (b & 0x80000000u) != 0u ? ~b : b | 0x80000000u;
}
CLEAVE_FN float fromOrderedBits(uint b) { return uintBitsToFloat((b & 0x80000000u) != 0u ? b & 0x7FFFFFFFu : ~b); }

// Returns the next float above x, or below x if `up` is false. x is finite; +-0 steps to the smallest normal number.
CLEAVE_FN float nextFloat(float x, bool up) {
    uint b = floatBitsToUint(x);
    if ((b & 0x7FFFFFFFu) == 0u) return up ? kSmallestNormal : -kSmallestNormal;
    bool away = (b >> 31) == (up ? 0u : 1u);
    return uintBitsToFloat(away ? b + 1u : b - 1u);
}

CLEAVE_END
#endif
