// A node of the tree takes 8 bytes. Siblings are adjacent: the left child is at childIndex, the right at childIndex
// + 1.
//   inner node: plane = bits of the split position, link = childIndex << 2 | axis (0, 1, 2)
//   leaf:       plane = index of its first entry in the leaf list, link = count << 2 | 3
#ifndef CLEAVE_SHARED_KD_NODE_H
#define CLEAVE_SHARED_KD_NODE_H
#include "language.h"

CLEAVE_BEGIN

struct KdNode {
    uint plane;  // of a leaf: its first entry in the leaf list
    uint link;
};
CLEAVE_SIZE(KdNode, 8);

CLEAVE_CONST uint kLeafAxis = 3u;
CLEAVE_CONST uint kMaxLink = 0x3FFFFFFFu;  // bounds the nodes of a tree and the triangles of a leaf

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
