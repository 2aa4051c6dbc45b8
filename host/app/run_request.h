// From a command line to an exit status.
#pragma once

#include <functional>

#include "app/options.h"

namespace cleave {

// Runs what is parsed, or prints the text that it is instead. Returns the exit status: see program.h.
int runRequest(const std::function<Request()>& parse, const std::function<void(const Options&)>& run);

}  // namespace cleave
