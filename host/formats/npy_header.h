// The header of a .npy file: a Python dictionary with exactly the keys descr, fortran_order and shape.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cleave {

struct NpyHeader {
    std::string descr;
    bool fortranOrder = false;
    std::vector<uint64_t> shape;
};

// Strict in what it takes (plain strings, True and False, a tuple of decimal numbers), whatever the white space and
// the order of the keys. Nothing, and why, if the text is anything else.
std::optional<NpyHeader> parseNpyHeader(std::string_view text, std::string& why);

}  // namespace cleave
