// Atomic file output.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace cleave {

// Writes beside the file and renames, so that a reader sees the old file or the new one and never a part; what was
// begun is removed on failure and on Ctrl-C. A device or a pipe is written straight. Throws Error.
void writeFile(const std::filesystem::path& file, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& file, std::string_view text);

// Throws Error if it is already clear that the file cannot be written. Called before long work starts.
void requireWritable(const std::filesystem::path& file);

}  // namespace cleave
