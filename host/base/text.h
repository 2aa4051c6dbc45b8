// Numbers, lines and tables of text for a person at a terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/one_line.h"

namespace cleave {

std::string fixed(double value, int digits);                 // "12.30"; what is not finite is "-"
std::string fixed(std::optional<double> value, int digits);  // nothing is "-"
std::string grouped(uint64_t count);                         // "69,451"
std::string bytesText(uint64_t bytes);                       // "12.3 MiB"

// The shortest text that reads back as the same number.
std::string exactText(double value);
// A word as a shell takes it: in quotes where it has to be.
std::string shellWord(std::string_view word);

// Formats rows of equal length as a table: columns are padded to their widest cell, two spaces apart. `alignment` has a
// letter per column, l or r.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows, std::string_view alignment);

}  // namespace cleave
