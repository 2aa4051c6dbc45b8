// Arguments of the kernel that copies a tree.
#ifndef CLEAVE_SHARED_COMPACT_H
#define CLEAVE_SHARED_COMPACT_H
#include "config.h"
#include "tree_layout.h"

CLEAVE_BEGIN

struct CompactPush {
    CLEAVE_ADDRESS(Tree) from;
    CLEAVE_ADDRESS(Tree) to;
    uint invocations;   // of the dispatch: each copies every so manyth entry
    uint nodeCapacity;  // of the copy, where that is more than it takes
    uint leafRefCapacity;
};

CLEAVE_END
#endif
