// Pieces of HTML for reports.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cleave {

std::string paragraph(const std::string& html);

// A cell of a table is text. What begins with kBest is the best of its column.
using HtmlRow = std::vector<std::string>;
inline constexpr const char* kBest = "\u2605 ";

// The first row is the head. `alignment` has a letter per column, l or r.
std::string htmlTable(const std::string& caption, const std::vector<HtmlRow>& rows, std::string_view alignment);

}  // namespace cleave
