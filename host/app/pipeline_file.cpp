#include "app/pipeline_file.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace cleave {
namespace {

// Empty if there is no place for it.
std::filesystem::path fileOf(const std::string& key) {
    std::filesystem::path folder;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg)
        folder = xdg;
    else if (const char* home = std::getenv("HOME"); home && *home)
        folder = std::filesystem::path(home) / ".cache";
    else
        return {};
    return folder / "cleave" / ("pipelines-" + key);
}

}  // namespace

std::vector<char> loadPipelines(const std::string& key) {
    const auto file = fileOf(key);
    if (file.empty()) return {};
    std::ifstream in(file, std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(in), {});
}

void storePipelines(const std::string& key, std::span<const char> data) {
    const auto file = fileOf(key);
    std::error_code ignored;
    if (file.empty() || (std::filesystem::file_size(file, ignored) == data.size() && !ignored)) return;
    std::filesystem::create_directories(file.parent_path(), ignored);
    const std::filesystem::path beside = file.string() + "." + std::to_string(getpid());
    std::ofstream(beside, std::ios::binary).write(data.data(), static_cast<std::streamsize>(data.size()));
    std::filesystem::rename(beside, file, ignored);
}

}  // namespace cleave
