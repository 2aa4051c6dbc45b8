#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace cleave {
namespace {

constexpr const char* kBackAndErase = "\r\x1b[K";

}  // namespace

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::phase(const std::string& what) {
    if (shown_)
        std::fprintf(stderr, "%s%s%s%s ...", kBackAndErase, whole_.c_str(), whole_.empty() ? "" : ": ", what.c_str());
}

void Progress::clear() {
    if (shown_) std::fputs(kBackAndErase, stderr);
}

}  // namespace cleave
