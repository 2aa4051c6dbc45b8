// Who builds a tree, and how.
#pragma once

#include <CLI/CLI.hpp>

#include "app/options.h"

namespace cleave {

// With those of addMachine(); `several` builders, one by one.
void addBuild(CLI::App& app, Options& options, bool several);

}  // namespace cleave
