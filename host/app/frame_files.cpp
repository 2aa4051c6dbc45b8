#include "app/frame_files.h"

#include <string>

#include "app/option_values.h"

namespace cleave {

namespace fs = std::filesystem;

fs::path frameFile(const fs::path& output, uint64_t frame) {
    constexpr size_t kDigits = 4;
    std::string number = std::to_string(frame);
    if (number.size() < kDigits) number.insert(0, kDigits - number.size(), '0');
    return output.parent_path() / (output.stem().string() + "_" + number + output.extension().string());
}

bool isFrameFile(const fs::path& output, const fs::path& file) {
    const std::string stem = output.stem().string() + "_", name = file.stem().string();
    if (!name.starts_with(stem)) return false;
    const auto number = parseWhole(std::string_view(name).substr(stem.size()), 0, UINT64_MAX);
    return number && frameFile(output, *number).lexically_normal() == file.lexically_normal();
}

}  // namespace cleave
