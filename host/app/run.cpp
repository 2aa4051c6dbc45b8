#include "app/run.h"

#include <cstdio>

#include "base/text.h"

namespace cleave {

void Run::print(const std::string& text) {
    progress.clear();
    if (!options.quiet) std::fwrite(text.data(), 1, text.size(), stdout);
}

void Run::warn(const std::string& text) {
    progress.clear();
    if (!options.quiet) std::fprintf(stderr, "warning: %s\n", oneLine(text).c_str());
}

std::vector<Traversal> Run::traversals() {
    if (!options.traversals.empty()) return options.traversals;
    return {kDefaultTraversal};
}

}  // namespace cleave
