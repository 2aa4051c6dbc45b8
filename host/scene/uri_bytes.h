// Reads the bytes that a URI names or holds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave {

// Returns the bytes of a data URI, or of a file in `folder` or below it. Throws Error if there are none.
std::vector<unsigned char> bytesOfUri(const std::filesystem::path& folder, const std::string& uri);

}  // namespace cleave
