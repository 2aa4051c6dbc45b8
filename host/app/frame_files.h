// What the pictures of frames are called.
#pragma once

#include <cstdint>
#include <filesystem>

namespace cleave {

// f.png becomes f_0001.png; the number has four digits or more.
std::filesystem::path frameFile(const std::filesystem::path& output, uint64_t frame);

// Whether frameFile() gives this file for some frame.
bool isFrameFile(const std::filesystem::path& output, const std::filesystem::path& file);

}  // namespace cleave
