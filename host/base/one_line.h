// Text of a message, fit for one line of output.
#pragma once

#include <string>
#include <string_view>

namespace cleave {

// Returns text from a file or a driver, safe to print: control characters become spaces, and spaces at the end are
// dropped.
inline std::string oneLine(std::string_view text) {
    std::string line(text);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

}  // namespace cleave
