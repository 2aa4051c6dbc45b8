// One of each struct that both languages read; layout.comp fills it, layout_test.cpp looks for what it wrote.
#ifndef CLEAVE_TESTS_LAYOUT_H
#define CLEAVE_TESTS_LAYOUT_H
#include "shared/build.h"
#include "shared/trace.h"

CLEAVE_BEGIN

struct LayoutRecord {
    Box box;
    KdNode node;
    Split split;
    Ray ray;
    Hit hit;
    Triangle triangle;
    PrimRef ref;
    BuildNode buildNode;
    Chunk chunk;
    StepCount steps;
    TraceCounters counters;
    BuildState state;
};

CLEAVE_END
#endif
