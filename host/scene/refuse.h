// Failures and warnings of what reads a scene. A failure is one line that names the file.
#pragma once

#include <new>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/one_line.h"

namespace cleave {

// Returns a text fit for one line of output, cut at a sensible length: it may quote a file.
inline std::string messageOf(const std::string& text) {
    constexpr size_t kLongest = 600;
    return oneLine(text.substr(0, kLongest));
}

// Throws what is wrong with a glTF file, without its name, which `naming` adds, and general advice where none is given.
[[noreturn]] inline void refuseGltf(
    const std::string& what, const std::string& advice = "check it with the glTF validator, or export it once more") {
    throw Error(what + "; " + advice);
}

// Returns work(); every failure becomes an Error of one line that begins with `failed`.
template <typename Work>
auto naming(const std::string& failed, const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error(messageOf(failed + ": there is not enough memory; load a smaller scene"));
    } catch (const std::exception& e) {
        throw Error(messageOf(failed + ": " + e.what()));
    }
}

// Adds a sentence to a list of warnings. A list holds no more than 20 of them, however many instances repeat one: the
// last then counts the others.
class Warnings {
  public:
    void add(const std::string& sentence) {
        if (sentences_.size() < kMost)
            sentences_.push_back(messageOf(sentence));
        else
            ++surplus_;
    }
    std::vector<std::string> list() const {
        std::vector<std::string> all = sentences_;
        if (surplus_ > 0) all.push_back("and " + std::to_string(surplus_) + " more warnings like these");
        return all;
    }

  private:
    static constexpr size_t kMost = 20;
    std::vector<std::string> sentences_;
    size_t surplus_ = 0;
};

}  // namespace cleave
