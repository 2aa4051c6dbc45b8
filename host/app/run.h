// One run of a command: its options and the state that all commands share.
#pragma once

#include <string>

#include "app/device_kit.h"
#include "app/options.h"
#include "app/progress.h"
#include "base/stopwatch.h"

namespace cleave {

struct Run {
    explicit Run(const Options& asked)
        : options(asked),
          progress(asked.quiet),
          device(asked.device, asked.peers, asked.keep[static_cast<size_t>(Need::trails)]) {}

    void print(const std::string& text);  // to stdout, unless --quiet
    void warn(const std::string& text);   // to stderr, unless --quiet

    // Those that are asked for, or the device's own.
    std::vector<Traversal> traversals();
    Traversal traversal() { return traversals().front(); }

    const Options& options;
    Stopwatch total;
    Progress progress;
    DeviceKit device;
};

}  // namespace cleave
