#include "app/program.h"

#include "app/commands.h"
#include "app/run_request.h"

namespace cleave {
namespace {

void runCommand(const Options& options) {
    Run run(options);
    switch (options.command) {
        case Command::render:
            return runRender(run);
        case Command::trace:
            return runTrace(run);
        case Command::query:
            return runQuery(run);
        case Command::info:
            return runInfo(run);
        case Command::bench:
            return runBench(run);
        case Command::report:
            return runReport(run);
        case Command::stability:
            return runStability(run);
        case Command::devices:
            return runDevices(run);
    }
}

}  // namespace

int runProgram(int argc, const char* const* argv) {
    return runRequest([&] { return parseCommandLine(argc, argv); }, runCommand);
}

}  // namespace cleave
