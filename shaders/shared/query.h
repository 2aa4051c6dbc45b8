// Arguments of the kernels that answer points and boxes.
#ifndef CLEAVE_SHARED_QUERY_H
#define CLEAVE_SHARED_QUERY_H
#include "trace.h"

CLEAVE_BEGIN

// The direction in which containment counts. Any will do; this one is along no axis and no diagonal.
CLEAVE_FN vec3 containmentDirection() { return vec3(0.73908513f, 0.2618034f, 0.57721566f); }

struct QueryPush {
    CLEAVE_ADDRESS(Tree) tree;
    CLEAVE_ADDRESS(FloatArray) items;     // points, or boxes
    CLEAVE_ADDRESS(HitArray) nearest;     // one per point
    CLEAVE_ADDRESS(UintArray) answers;    // one per point: whether it is inside; per box: how many triangles it meets
    CLEAVE_ADDRESS(UintArray) first;      // per box: where its triangles begin
    CLEAVE_ADDRESS(UintArray) triangles;  // numbers, those of several leaves more than once
    uint count;
    float within;  // the farthest that a nearest point may be
};
CLEAVE_SIZE(QueryPush, 56);

CLEAVE_END
#endif
