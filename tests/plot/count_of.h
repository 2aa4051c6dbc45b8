// How often a part occurs in a text, without overlaps.
#pragma once

#include <string>

namespace cleave::test {

inline size_t countOf(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

}  // namespace cleave::test
