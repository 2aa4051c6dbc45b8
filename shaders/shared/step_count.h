// The work of a ray, counted.
#ifndef CLEAVE_SHARED_STEP_COUNT_H
#define CLEAVE_SHARED_STEP_COUNT_H
#include "language.h"

CLEAVE_BEGIN

// Counted by kernels of their own, so that other queries do not pay for it.
struct StepCount {
    uint inner;      // inner nodes visited, again after each restart
    uint leaves;     // leaves visited
    uint triangles;  // triangle tests
    uint restarts;
    uint hitLeaf;   // triangles in the leaf of the hit
    uint resolved;  // triangle tests that were decided in double
};
CLEAVE_SIZE(StepCount, 24);

CLEAVE_FN StepCount noSteps() {
    StepCount s;
    s.inner = 0u;
    s.leaves = 0u;
    s.triangles = 0u;
    s.restarts = 0u;
    s.hitLeaf = 0u;
    s.resolved = 0u;
    return s;
}

CLEAVE_END
#endif
