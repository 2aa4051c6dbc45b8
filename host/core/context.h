// The insides of a Context: the pipelines of the library, all made when it is created.
#pragma once

#include <vector>

#include "cleave/cleave.hpp"
#include "core/build_passes.h"
#include "record/recorder.h"

namespace cleave {

struct TraceKernel {
    TraceMode mode;
    Kernel kernel;
};

struct SearchKernel {
    Search search;
    Kernel kernel;
};

struct Context::State {
    Functions functions;
    uint32_t row = kLongestRow;
    std::vector<Kernel> buildKernels;  // each once
    Kernel compact;
    std::vector<TraceKernel> traceKernels;
    std::vector<SearchKernel> searchKernels;

    // The kernel of a pass; the context was created with `builds`.
    const Kernel& kernelOf(const BuildPass& pass) const noexcept;
    // The kernel of a mode; one of those that the context was created with.
    const Kernel& kernelOf(const TraceMode& mode) const noexcept;
    // The kernel of a search; one of those that the context was created with.
    const Kernel& kernelOf(Search search) const noexcept;

    Recorder recorder(VkCommandBuffer commands) const noexcept { return {functions, commands, row}; }
};

// The library's kernels; a table that the build generates.
std::span<const Spirv> coreKernels() noexcept;

}  // namespace cleave
