#include "app/option_values.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace cleave {
namespace {

// The whole text as one number of the type; from_chars takes no white space, no '+' and no locale.
template <typename Number>
std::optional<Number> parseAll(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<std::pair<uint64_t, uint64_t>> parsePair(std::string_view text, char between, uint64_t most) {
    const size_t at = text.find(between);
    if (at == std::string_view::npos) return std::nullopt;
    const auto first = parseWhole(text.substr(0, at), 0, most);
    const auto second = parseWhole(text.substr(at + 1), 0, most);
    if (!first || !second) return std::nullopt;
    return std::pair(*first, *second);
}

}  // namespace

std::optional<uint64_t> parseWhole(std::string_view text, uint64_t least, uint64_t most) {
    const auto value = parseAll<uint64_t>(text);
    return value && *value >= least && *value <= most ? value : std::nullopt;
}

std::optional<double> parseNumber(std::string_view text) {
    const auto value = parseAll<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<glm::dvec3> parsePoint(std::string_view text) {
    glm::dvec3 point(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (axis == 2)) return std::nullopt;
        const auto value = parseNumber(text.substr(0, comma));
        if (!value) return std::nullopt;
        point[axis] = *value;
        if (axis < 2) text.remove_prefix(comma + 1);
    }
    return point;
}

std::optional<glm::uvec2> parseSize(std::string_view text) {
    constexpr uint64_t kMaxSide = 16384;
    constexpr uint64_t kMaxPixels = 1u << 26;
    const size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = parseWhole(text.substr(0, cross), 1, kMaxSide);
    const auto height = parseWhole(text.substr(cross + 1), 1, kMaxSide);
    if (!width || !height || *width * *height > kMaxPixels) return std::nullopt;
    return glm::uvec2(*width, *height);
}

std::optional<std::pair<uint64_t, uint64_t>> parseFrames(std::string_view text) {
    constexpr uint64_t kLastFrame = 999'999'999;
    const auto range = parsePair(text, ':', kLastFrame);
    return range && range->first <= range->second ? range : std::nullopt;
}

std::optional<std::pair<uint64_t, uint64_t>> parsePart(std::string_view text) {
    constexpr uint64_t kMostParts = 1'000'000'000;
    const auto part = parsePair(text, '/', kMostParts);
    return part && part->first < part->second ? part : std::nullopt;
}

std::optional<uint64_t> parseBytes(std::string_view text) {
    for (const std::string_view unit : {"iB", "B"})
        if (text.ends_with(unit)) {
            text.remove_suffix(unit.size());
            break;
        }
    int shift = 0;
    if (!text.empty()) {
        const size_t prefix = std::string_view("KMG").find(text.back());
        if (prefix != std::string_view::npos) {
            shift = 10 * static_cast<int>(prefix + 1);
            text.remove_suffix(1);
        }
    }
    const auto count = parseWhole(text, 1, std::numeric_limits<uint64_t>::max() >> shift);
    return count ? std::optional(*count << shift) : std::nullopt;
}

}  // namespace cleave
