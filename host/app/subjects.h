// What a report measures: builders with their settings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.h"

namespace cleave {

// A builder with settings, and what is known of its tree.
struct Subject {
    Builder builder;
    std::string settings;  // in words
    BuildSettings build;
    bool isTraced = false;
    std::optional<size_t> tree = {}, traced = {};  // its figures in SceneErrors; nothing: it failed

    std::string name() const { return nameOf(builder) + ", " + settings; }
};

// All builders at their defaults, `exact` first, which the others are measured against, and `gpu` second; then, fewer
// of them in a quick report, what trades error for time, one setting at a time.
std::vector<Subject> subjectsOf(const Options& options);
inline constexpr size_t kOfExact = 0, kOfGpu = 1;

}  // namespace cleave
