// Options that several commands take: what is run, and what becomes of it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/options.h"

namespace cleave {

void addScene(CLI::App& app, Options& options, const std::string& text, bool needed);
CLI::Option* addTime(CLI::App& app, Options& options);
void addMachine(CLI::App& app, Options& options);
// After addBuild(): a saved tree has been built.
void addTree(CLI::App& app, Options& options);
// After addTree().
void addSplitMoving(CLI::App& app, Options& options);
void addDevicePose(CLI::App& app, Options& options);  // after --frames
void addInstances(CLI::App& app, Options& options);
void addLazy(CLI::App& app, Options& options);
void addKeepAll(CLI::App& app, Options& options);
void addTraversal(CLI::App& app, Options& options, bool several);
void addOutput(CLI::App& app, Options& options);

}  // namespace cleave
