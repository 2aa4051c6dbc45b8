// What the tests of a program share beside its device: pipelines are made once, which takes longer than most of what is
// done with them. Tests of limits, and of what a first use does, make their own.
#pragma once

#include "run/gpu_builder.h"
#include "run/renderer.h"
#include "run/searcher.h"
#include "run/tracer.h"

namespace cleave::test {

Tracer& sharedTracer();
GpuBuilder& sharedBuilder();
Renderer& sharedRenderer();
Searcher& sharedSearcher();  // asks in many batches

}  // namespace cleave::test
