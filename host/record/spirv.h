// Compiled kernels, as the build embeds them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace cleave {

struct Spirv {
    std::string_view name;  // the stem of the .comp file
    std::span<const uint32_t> words;
};

// The kernel of that name; without words if there is none.
inline Spirv findSpirv(std::span<const Spirv> kernels, std::string_view name) {
    for (const Spirv& s : kernels)
        if (s.name == name) return s;
    return {name, {}};
}

}  // namespace cleave
