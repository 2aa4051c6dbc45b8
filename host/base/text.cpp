#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace cleave {
namespace {

// Characters of a UTF-8 text: every byte but continuation bytes begins one.
size_t widthOf(std::string_view text) {
    return static_cast<size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::string fixed(double value, int digits) {
    if (!std::isfinite(value)) return "-";
    const int length = std::snprintf(nullptr, 0, "%.*f", digits, value);
    std::string text(static_cast<size_t>(length), '\0');
    std::snprintf(text.data(), text.size() + 1, "%.*f", digits, value);
    return text;
}

std::string fixed(std::optional<double> value, int digits) { return value ? fixed(*value, digits) : "-"; }

std::string exactText(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string shellWord(std::string_view word) {
    constexpr const char* kPlain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
        "0123456789-_=+,./:@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string grouped(uint64_t count) {
    std::string text = std::to_string(count);
    for (size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
}

std::string bytesText(uint64_t bytes) {
    constexpr double kMiB = 1024.0 * 1024.0;
    return fixed(static_cast<double>(bytes) / kMiB, 1) + " MiB";
}

std::string alignedTable(const std::vector<std::vector<std::string>>& rows, std::string_view alignment) {
    std::vector<size_t> widths(alignment.size(), 0);
    for (const auto& row : rows)
        for (size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], widthOf(row.at(c)));
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (size_t c = 0; c < widths.size(); ++c) {
            const std::string padding(widths[c] - widthOf(row[c]), ' ');
            line += (c == 0 ? "" : "  ") + (alignment[c] == 'r' ? padding + row[c] : row[c] + padding);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

}  // namespace cleave
