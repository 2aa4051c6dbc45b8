// The tree in device memory: what it begins with, and where its parts are. As TreeHeader in cleave/cleave.hpp.
#ifndef CLEAVE_SHARED_TREE_H
#define CLEAVE_SHARED_TREE_H
#include "kd_node.h"
#include "triangle.h"

CLEAVE_BEGIN

CLEAVE_CONST uint kTreeMagic = 0x56454C43u;  // "CLEV"
CLEAVE_CONST uint kTreeFormatNumber = 2u;    // raised whenever the bytes of a tree change
CLEAVE_CONST uint kShortOfCapacity = 1u;     // status: the last levels were finished as leaves

// A triangle of the tree, scaled, with its number in the scene. Those that are left out are zeroed.
struct TreeTriangle {
    vec3 a;
    vec3 b;
    vec3 c;
    uint number;
};
CLEAVE_SIZE(TreeTriangle, 40);

CLEAVE_FN TreeTriangle treeTriangle(Triangle t, uint number) {
    TreeTriangle n;
    n.a = t.a;
    n.b = t.b;
    n.c = t.c;
    n.number = number;
    return n;
}
CLEAVE_FN Triangle withoutNumber(TreeTriangle n) {
    Triangle t;
    t.a = n.a;
    t.b = n.b;
    t.c = n.c;
    return t;
}

#ifndef __cplusplus
#include "lib/arrays.glsl"
#endif

struct TreeData {
    uint magic;
    uint format;
    uint status;
    uint levels;
    uint triangleCount;
    uint nodeCount;
    uint leafRefCount;
    uint nonFinite;   // triangles that were left out: a vertex is not finite
    uint noArea;      // the vertices lie on a line
    int exponent;     // world = scaled * 2^exponent
    Box bounds;       // of the root cell
    uint wantedRefs;  // capacities that the build would have needed; 0 where they sufficed
    uint wantedLevelNodes;
    uint wantedNodes;
    uint wantedLeafRefs;
    uvec2 bytes;  // low and high word
    uvec2 wantedBytes;
    uvec2 reserved;
    CLEAVE_ADDRESS(TreeTriangleArray) triangles;
    CLEAVE_ADDRESS(KdNodeArray) nodes;
    CLEAVE_ADDRESS(UintArray) leafRefs;  // indices of triangles, leaf by leaf
};
CLEAVE_SIZE(TreeData, 128);

#ifndef __cplusplus
// A tree, by its address.
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer Tree { TreeData at; };
#endif

CLEAVE_END
#endif
