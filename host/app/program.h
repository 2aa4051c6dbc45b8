// The program from its arguments to its exit status.
#pragma once

#include <functional>

#include "app/options.h"

namespace cleave {

// Runs what is parsed, or prints the text that it is instead.
// 0: done. 1: failed, with one line "error: what, where, what to do" on stderr. 2: wrong use, also told in one line.
int runRequest(const std::function<Request()>& parse, const std::function<void(const Options&)>& run);
// `cleave` itself.
int runProgram(int argc, const char* const* argv);

}  // namespace cleave
