// The options of each command.
#pragma once

#include <CLI/CLI.hpp>

#include "app/options.h"

namespace cleave {

void addRender(CLI::App& app, Options& options);
void addTrace(CLI::App& app, Options& options);
void addQuery(CLI::App& app, Options& options);
void addInfo(CLI::App& app, Options& options);
void addBench(CLI::App& app, Options& options);
void addReport(CLI::App& app, Options& options);
void addStability(CLI::App& app, Options& options);
void addView(CLI::App& app, Options& options);  // of cleave-view

}  // namespace cleave
