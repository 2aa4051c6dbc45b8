// NumPy's file format (numpy.lib.format): rays, points and boxes in, answers out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <vector>

#include "shared/box.h"
#include "shared/ray.h"

namespace cleave {

// Rays of a file of little-endian float32 of shape (N, 8): origin, tMin, direction, tMax. The file is not trusted: its
// sizes are checked before memory is asked for. Throws Error.
std::vector<Ray> readRays(const std::filesystem::path& file);
// The same from a stream at its beginning, which has `size` bytes; `file` names it in messages.
std::vector<Ray> readRays(std::istream& in, uint64_t size, const std::filesystem::path& file);
// Points of shape (N, 3) and boxes of shape (N, 2, 3), the lower corner first, in the same way.
std::vector<vec3> readPoints(const std::filesystem::path& file);
std::vector<Box> readBoxes(const std::filesystem::path& file);

// The bytes of a file of structured hits, fields t '<f4', prim '<u4', u '<f4', v '<f4', shape (N,).
std::vector<std::byte> npyOf(std::span<const Hit> hits);
// The same in rows, shape (N, hitsPerRow).
std::vector<std::byte> npyOf(std::span<const Hit> hits, uint32_t hitsPerRow);
// Nearest points: hits whose t is called distance.
std::vector<std::byte> npyOfNearest(std::span<const Hit> nearest);
// '<i4', shape (N,).
std::vector<std::byte> npyOfCounts(std::span<const int32_t> counts);
// '|b1', shape (N,), of bytes that are 0 or 1.
std::vector<std::byte> npyOfBools(std::span<const uint8_t> values);
// '<u4', shape (M, 2).
std::vector<std::byte> npyOfPairs(std::span<const uvec2> pairs);

}  // namespace cleave
