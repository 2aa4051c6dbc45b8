// What the harnesses share. A harness aborts where a promise is broken; libFuzzer then keeps the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace cleave::fuzz {

inline void require(bool good, const char* promise, const std::string& about = "") {
    if (good) return;
    std::fprintf(stderr, "broken promise: %s: '%s'\n", promise, about.c_str());
    std::abort();
}

// A message for a person: one line of a sensible length, not empty, and nothing that a terminal would obey.
inline void requireOneLine(const std::string& message) {
    constexpr size_t kLongest = 1000;
    bool good = !message.empty() && message.size() <= kLongest;
    for (const char c : message) good = good && static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
    require(good, "a message is one line", message);
}

// Aborts if an input took too long, by processor time: a busy machine is no finding. (libFuzzer's own limit goes by the
// clock on the wall, and is for inputs that never end.)
class TimeLimit {
  public:
    TimeLimit() = default;
    ~TimeLimit() {
        constexpr double kSeconds = 5.0;
        require(double(std::clock() - start_) / CLOCKS_PER_SEC < kSeconds, "an input takes less than 5 s");
    }
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

  private:
    std::clock_t start_ = std::clock();
};

// The folder of a scene, with files in it and, outside of it, one that no URI may reach; removed at exit.
class SceneFolder {
  public:
    SceneFolder() {
        namespace fs = std::filesystem;
        std::string name = (fs::temp_directory_path() / "cleave_fuzz_XXXXXX").string();
        require(mkdtemp(name.data()) != nullptr, "a temporary folder can be made");
        root_ = name;
        fs::create_directories(folder() / "sub");
        for (const fs::path& file : {outside(), folder() / "near.bin", folder() / "sub/near.bin"})
            std::ofstream(file, std::ios::binary) << std::string(1024, '\x3f');
        fs::create_symlink("../outside.bin", folder() / "link.bin");
        fs::create_directory_symlink("..", folder() / "up");
        fs::create_symlink("near.bin", folder() / "alias.bin");
    }
    ~SceneFolder() { std::filesystem::remove_all(root_); }
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;

    std::filesystem::path folder() const { return root_ / "in"; }
    std::filesystem::path outside() const { return root_ / "outside.bin"; }

  private:
    std::filesystem::path root_;
};

}  // namespace cleave::fuzz
