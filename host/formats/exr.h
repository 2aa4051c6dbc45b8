// Pictures as OpenEXR.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace cleave {

// Pixels are linear radiance, row by row from the top; written as 32-bit floats R, G, B, compressed without loss.
// Throws Error.
std::vector<std::byte> exrOf(uint32_t width, uint32_t height, std::span<const glm::vec3> pixels);

}  // namespace cleave
