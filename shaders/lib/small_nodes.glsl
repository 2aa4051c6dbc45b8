// The cheapest face of up to HELD boxes that are held in registers: loops over them are unrolled. Included once for each
// HELD; functions differ by the size of their arrays.

// The boxes of references on an axis. What is not there begins nowhere and ends nowhere.
void hold(WorkNode node, uint refs[HELD], uint from, uint axis, out float lo[HELD], out float hi[HELD]) {
    [[unroll]] for (uint u = 0u; u < HELD; u++) {
        float begin = workRefs.at[refs[u]].lo[axis];
        float end = workRefs.at[refs[u]].hi[axis];
        bool isThere = from + u < node.count;
        lo[u] = isThere ? begin : infinity();
        hi[u] = isThere ? end : -infinity();
    }
}

// Where they begin and end, in the order of floats. A flat box lies on one side of a plane through it.
void orderSides(float lo[HELD], float hi[HELD], bool planarLeft, out int begins[HELD], out int ends[HELD]) {
    [[unroll]] for (uint u = 0u; u < HELD; u++) {
        bool isFlat = lo[u] == hi[u];
        begins[u] = orderOf(lo[u]) - int(isFlat && planarLeft);
        ends[u] = orderOf(hi[u]) + int(isFlat && !planarLeft);
    }
}

// How many of them lie to the left of a plane, and in the upper half of the word how many to the right.
uint sideCounts(int begins[HELD], int ends[HELD], float plane) {
    int p = orderOf(plane);
    uint left = 0u;
    uint right = 0u;
    [[unroll]] for (uint u = 0u; u < HELD; u++) {
        left += uint(begins[u] < p);
        right += uint(ends[u] > p);
    }
    return left | right << 16;
}

bool anyFlat(float lo[HELD], float hi[HELD]) {
    bool any = false;
    [[unroll]] for (uint u = 0u; u < HELD; u++) any = any || lo[u] == hi[u];
    return any;
}

Split bestFace(WorkNode node, uint refs[HELD]) {
    Split best = noSplit();
    uint axis = 0u;
    do {
        float lo[HELD];
        float hi[HELD];
        hold(node, refs, 0u, axis, lo, hi);
        Split ofAxis = noSplit();
        bool planarLeft = true;
        bool again;
        do {
            int begins[HELD];
            int ends[HELD];
            orderSides(lo, hi, planarLeft, begins, ends);
            [[unroll]] for (uint u = 0u; u < HELD; u++) {
                ofAxis = cheaper(ofAxis, node.cell, axis, lo[u], sideCounts(begins, ends, lo[u]), planarLeft);
                ofAxis = cheaper(ofAxis, node.cell, axis, hi[u], sideCounts(begins, ends, hi[u]), planarLeft);
            }
            again = planarLeft && anyFlat(lo, hi);
            planarLeft = false;
        } while (again);
        if (ofAxis.cost < best.cost) best = ofAxis;
        axis++;
    } while (axis < 3u);
    return best;
}
