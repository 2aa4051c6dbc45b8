// NumPy's file format (numpy.lib.format): rays in, hits out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <vector>

#include "shared/ray.h"

namespace cleave {

// Rays of a file of little-endian float32 of shape (N, 8): origin, tMin, direction, tMax. The file is not trusted: its
// sizes are checked before memory is asked for. Throws Error.
std::vector<Ray> readRays(const std::filesystem::path& file);
// The same from a stream at its beginning, which has `size` bytes; `file` names it in messages.
std::vector<Ray> readRays(std::istream& in, uint64_t size, const std::filesystem::path& file);

// The bytes of a file of structured hits, fields t '<f4', prim '<u4', u '<f4', v '<f4', shape (N,).
std::vector<std::byte> npyOf(std::span<const Hit> hits);

}  // namespace cleave
