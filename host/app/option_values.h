// The values of options, strictly read: no value is guessed from a text that is only nearly one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <utility>

namespace cleave {

// A whole decimal number from `least` to `most`.
std::optional<uint64_t> parseWhole(std::string_view text, uint64_t least, uint64_t most);
// A finite number, plain or with an exponent.
std::optional<double> parseNumber(std::string_view text);
// "x,y,z", finite numbers.
std::optional<glm::dvec3> parsePoint(std::string_view text);
// "1280x720": each side at most 16384 and at most 2^26 pixels, of which a device with 8 GiB can hold rays and hits.
std::optional<glm::uvec2> parseSize(std::string_view text);
// "A:B", frame numbers of up to nine digits, A <= B.
std::optional<std::pair<uint64_t, uint64_t>> parseFrames(std::string_view text);
// "I/N", I < N.
std::optional<std::pair<uint64_t, uint64_t>> parsePart(std::string_view text);
// Bytes: "512M", "2G", "1048576"; K, M and G are powers of 1024, a following B or iB is accepted. At least 1.
std::optional<uint64_t> parseBytes(std::string_view text);

}  // namespace cleave
