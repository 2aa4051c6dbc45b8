// Bytes as text (RFC 4648, section 4), for pictures within a page.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cleave {

std::string base64Of(std::span<const std::byte> bytes);
// What base64Of() was given. Throws Error if the text is none of its.
std::vector<std::byte> bytesOfBase64(std::string_view text);

}  // namespace cleave
