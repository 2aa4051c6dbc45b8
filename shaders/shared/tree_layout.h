// Where the parts of a tree lie in its memory.
#ifndef CLEAVE_SHARED_TREE_LAYOUT_H
#define CLEAVE_SHARED_TREE_LAYOUT_H
#include "dispatch.h"
#include "tree.h"

CLEAVE_BEGIN

// Where the parts of a tree begin, in blocks of 16 bytes from its start.
struct TreeLayout {
    uint triangles;
    uint nodes;
    uint leafRefs;
    uint end;
};

// A triangle takes 40 bytes, a node 8, a reference 4.
CLEAVE_FN TreeLayout treeLayout(uint triangles, uint nodes, uint leafRefs) {
    TreeLayout l;
    l.triangles = 8u;
    l.nodes = l.triangles + 2u * triangles + ceilDiv(triangles, 2u);
    l.leafRefs = l.nodes + ceilDiv(nodes, 2u);
    l.end = l.leafRefs + ceilDiv(leafRefs, 4u);
    return l;
}

// The bytes of so many blocks, low and high word.
CLEAVE_FN uvec2 bytesOfBlocks(uint blocks) { return uvec2(blocks << 4, blocks >> 28); }
CLEAVE_FN uvec2 treeBytes(uint triangles, uint nodes, uint leafRefs) {
    return bytesOfBlocks(treeLayout(triangles, nodes, leafRefs).end);
}

CLEAVE_END
#endif
