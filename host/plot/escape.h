// Text of any origin, fit to stand in HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace cleave {

// Returns the text with the characters that mark-up is made of escaped, for content and for quoted attributes alike.
// Control characters become spaces; bytes that are no UTF-8, as file names may have them, become U+FFFD.
std::string escaped(std::string_view text);

}  // namespace cleave
