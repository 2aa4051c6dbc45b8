// A node of the tree, 8 bytes. Children lie side by side: left at childIndex, right at childIndex + 1.
//   inner: plane = position of the split, link = childIndex << 2 | axis (0, 1, 2)
//   leaf:  first = where its triangle numbers begin in the leaf list (stored in `plane` as bits), link = count << 2 | 3
#ifndef CLEAVE_SHARED_KD_NODE_H
#define CLEAVE_SHARED_KD_NODE_H
#include "language.h"

CLEAVE_BEGIN

struct KdNode {
    uint plane;  // bits of a float, or the first index of a leaf
    uint link;
};
CLEAVE_SIZE(KdNode, 8);

CLEAVE_CONST uint kLeafAxis = 3u;
CLEAVE_CONST uint kMaxLink = 0x3FFFFFFFu;  // most nodes, and most triangles of one leaf

CLEAVE_FN KdNode innerNode(uint axis, float position, uint childIndex) {
    KdNode n;
    n.plane = floatBitsToUint(position);
    n.link = childIndex << 2 | axis;
    return n;
}
CLEAVE_FN KdNode leafNode(uint first, uint count) {
    KdNode n;
    n.plane = first;
    n.link = count << 2 | kLeafAxis;
    return n;
}

CLEAVE_FN uint nodeAxis(KdNode n) { return n.link & 3u; }
CLEAVE_FN bool isLeaf(KdNode n) { return nodeAxis(n) == kLeafAxis; }
CLEAVE_FN float nodePosition(KdNode n) { return uintBitsToFloat(n.plane); }
CLEAVE_FN uint nodeChild(KdNode n) { return n.link >> 2; }
CLEAVE_FN uint leafFirst(KdNode n) { return n.plane; }
CLEAVE_FN uint leafCount(KdNode n) { return n.link >> 2; }

CLEAVE_END
#endif
