// What the tests of the program share: a folder that goes away, a small scene, runs of the built program.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace cleave::test {

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "cleave-app-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) std::abort();
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

    // The names in it, hidden ones included.
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            found.push_back(entry.path().filename().string());
        return found;
    }

  private:
    std::filesystem::path path_;
};

inline std::string contentOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void put(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

// One triangle in the plane z = 0, (-1,-1) (3,-1) (-1,3), and a camera "main" at z = 2 that looks at it.
inline std::string triangleScene() {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0},{"camera":0,"translation":[0,0,2]}],
"cameras":[{"name":"main","type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[-1,-1,0],"max":[3,3,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
           "AACAvwAAgL8AAAAAAABAQAAAgL8AAAAAAACAvwAAQEAAAAAA"
           R"("}]})";
}

struct Outcome {
    int status = -1;  // of exit; 128 + the signal for one that was killed
    std::string out;
    std::string err;

    size_t errorLines() const {
        size_t count = 0;
        for (size_t at = err.find("error: "); at != std::string::npos; at = err.find("error: ", at + 1))
            count += at == 0 || err[at - 1] == '\n';
        return count;
    }
};

inline std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// Runs a program in a folder of its own and gives what it said.
inline Outcome runProgramAt(const std::string& program, const std::vector<std::string>& arguments,
                            const std::string& before) {
    const TemporaryFolder folder;
    std::string line = before + " " + quoted(program);
    for (const std::string& argument : arguments) line += " " + quoted(argument);
    line += " >" + quoted(folder / "out") + " 2>" + quoted(folder / "err") + " </dev/null";
    const int status = std::system(line.c_str());
    Outcome outcome;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = contentOf(folder / "out");
    outcome.err = contentOf(folder / "err");
    return outcome;
}

inline Outcome runCleave(const std::vector<std::string>& arguments, const std::string& before = "") {
    return runProgramAt(CLEAVE_PROGRAM, arguments, before);
}

}  // namespace cleave::test
