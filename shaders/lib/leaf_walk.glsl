// The leaves along a ray, one after the other, for queries that look at more than the closest hit: the walk with a short
// stack in registers of short_stack.glsl, stopped at each leaf.
#ifndef CLEAVE_LIB_LEAF_WALK
#define CLEAVE_LIB_LEAF_WALK
#include "shared/trail.h"
#include "lib/restart.glsl"
#include "lib/short_stack.glsl"

struct LeafWalk {
    bool begun;
    Visit at;
    uint depth;
    Visit start;  // where to descend from when the stack is empty
    uint startDepth;
    Trail trail;
    uvec4 nodes;  // the far children that wait
    vec4 begins;
    vec4 ends;
    uint count;
    float forgotten;  // a lower bound of t over the cells that fell out of the stack
};

LeafWalk leafWalk(float tMin, float tMax) {
    LeafWalk w;
    w.begun = false;
    w.at.node = 0u;
    w.at.tMin = tMin;
    w.at.tMax = tMax;
    w.depth = 0u;
    w.start = w.at;
    w.startDepth = 0u;
    w.trail = emptyTrail();
    w.nodes = uvec4(0u);
    w.begins = vec4(0.0);
    w.ends = vec4(0.0);
    w.count = 0u;
    w.forgotten = infinity();
    return w;
}

// Goes from a leaf to the next cell that waits; false if none begins at most at `limit`.
bool leaveLeaf(float limit, inout LeafWalk w) {
    do {
        if (w.count == 0u && (w.forgotten == infinity() || limit < w.forgotten)) return false;
        uint open = deepestOpen(w.trail, w.depth);
        w.trail = openedAt(w.trail, open);
        if (w.count == 0u) {
            w.at = w.start;
            w.depth = w.startDepth;
            w.forgotten = infinity();
            return true;
        }
        w.at.node = w.nodes.x;
        w.at.tMin = w.begins.x;
        w.at.tMax = w.ends.x;
        w.depth = open + 1u;
        w.nodes = uvec4(w.nodes.yzw, 0u);
        w.begins = vec4(w.begins.yzw, 0.0);
        w.ends = vec4(w.ends.yzw, 0.0);
        w.count--;
    } while (w.at.tMin > limit);
    return true;
}

// The next leaf whose cell the ray may enter at most at `limit`, in the walk's parameter; false if there is none.
bool nextLeaf(TreeParts tree, Walk walk, float limit, inout LeafWalk w, out KdNode leaf) {
    while (true) {
        leaf = leafNode(0u, 0u);
        if (w.begun && !leaveLeaf(limit, w)) return false;
        w.begun = true;
        KdNode node = nodeAt(tree, w.at.node);
        while (!isLeaf(node) && w.at.tMin <= limit) {
            PlaneStep s = stepAt(node, walk, w.at.tMin, w.at.tMax);
            TrailStep t = trailStepAt(node, s, w.at, w.trail, w.depth);
            w.trail = t.trail;
            w.forgotten = t.farWaits && w.count == kShortStack ? min(w.forgotten, w.begins.w) : w.forgotten;
            w.nodes = t.farWaits ? uvec4(t.far.node, w.nodes.xyz) : w.nodes;
            w.begins = t.farWaits ? vec4(t.far.tMin, w.begins.xyz) : w.begins;
            w.ends = t.farWaits ? vec4(t.far.tMax, w.ends.xyz) : w.ends;
            w.count = t.farWaits ? min(w.count + 1u, kShortStack) : w.count;
            w.at = t.next;
            w.depth++;
            bool pushesDown = w.count == 0u && w.forgotten == infinity();  // nothing above is left to visit
            if (pushesDown) {
                w.start = w.at;
                w.startDepth = w.depth;
            }
            node = nodeAt(tree, w.at.node);
        }
        if (isLeaf(node) && w.at.tMin <= limit) {
            leaf = node;
            return true;
        }
    }
    return false;
}
#endif
