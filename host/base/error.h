// Errors are exceptions whose text says what failed, where, and what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace cleave {

// Ends the program with exit status 1 and the line "error: <text>".
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace cleave
