// Exact SAH as CPU devices like it: the boxes of up to eight references are held in registers and compared with eight
// others at a time. There, what a loop changes is merged under a mask in every round, a loop runs at least once, and so
// does what is in a branch. Included by kernels that define NODE, BOXES, `costs`, and refOf(NODE, uint): where in BOXES a
// reference of a node is, of the last one for numbers beyond.

// The order of floats, with -0 and +0 the same.
int orderOf(float x) {
    int bits = floatBitsToInt(x);
    return bits < 0 ? int(0x80000000u) - bits : bits;
}

// The cheaper one of planes on an axis, as betterOf(), but without branches. Those with planar references left come
// first, so that they win where nothing else decides. `counts`: of sideCounts().
Split cheaper(Split best, Box cell, uint axis, float position, uint counts, bool planarLeft) {
    float cost = splitCost(costs, cell, axis, position, counts & 0xFFFFu, counts >> 16);
    bool isInside = cell.lo[axis] < position && position < cell.hi[axis];
    bool wins = cost < best.cost || (cost == best.cost && position < best.position);
    if (isInside && wins) {
        best.cost = cost;
        best.axis = axis;
        best.position = position;
        best.planarLeft = planarLeft ? 1u : 0u;
    }
    return best;
}

#define HELD 4
#include "lib/few_boxes.glsl"
#undef HELD
#define HELD 8
#include "lib/few_boxes.glsl"
#undef HELD

Split bestOfFour(NODE node) {
    uint held[4];
    [[unroll]] for (uint u = 0u; u < 4u; u++) held[u] = refOf(node, u);
    return bestOfAll(node, held);
}

Split bestOfEight(NODE node) {
    uint held[8];
    [[unroll]] for (uint u = 0u; u < 8u; u++) held[u] = refOf(node, u);
    return bestOfAll(node, held);
}

// The best plane at a face of one of eight references of a node, from number `from` on.
Split bestOfRun(NODE node, uint from) {
    Split best = noSplit();
    uint held[8];
    [[unroll]] for (uint u = 0u; u < 8u; u++) held[u] = refOf(node, from + u);
    uint axis = 0u;
    do {
        float lo[8];
        float hi[8];
        hold(held, from, node.count, axis, lo, hi);
        Split ofAxis = noSplit();
        bool planarLeft = true;
        bool again;
        do {
            uint ofLo[8];
            uint ofHi[8];
            [[unroll]] for (uint u = 0u; u < 8u; u++) {
                ofLo[u] = 0u;
                ofHi[u] = 0u;
            }
            uint next = 0u;
            do {
                uint others[8];
                float otherLo[8];
                float otherHi[8];
                int begins[8];
                int ends[8];
                [[unroll]] for (uint u = 0u; u < 8u; u++) others[u] = refOf(node, next + u);
                hold(others, next, node.count, axis, otherLo, otherHi);
                orderSides(otherLo, otherHi, planarLeft, begins, ends);
                [[unroll]] for (uint u = 0u; u < 8u; u++) {
                    ofLo[u] += sideCounts(begins, ends, lo[u]);
                    ofHi[u] += sideCounts(begins, ends, hi[u]);
                }
                next += 8u;
            } while (next < node.count);
            [[unroll]] for (uint u = 0u; u < 8u; u++) {
                ofAxis = cheaper(ofAxis, node.cell, axis, lo[u], ofLo[u], planarLeft);
                ofAxis = cheaper(ofAxis, node.cell, axis, hi[u], ofHi[u], planarLeft);
            }
            again = planarLeft && anyFlat(lo, hi);  // only faces of flat boxes have planar references
            planarLeft = false;
        } while (again);
        if (ofAxis.cost < best.cost) best = ofAxis;
        axis++;
    } while (axis < 3u);
    return best;
}
