#version 460
// The best of all planes through faces in the open bins of a large node, which is the best of all, if it is worth it. A
// workgroup per chunk, of any size that is a power of two; that of a node's first chunk acts.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
#include "shared/face_bins.h"
layout(local_size_x_id = 0) in;

const uint kLookedAt = 512u;  // bins at a time
shared uint openBins[kLookedAt];
shared float leasts[kLookedAt];  // what their planes cost at least
shared uint openCount;
shared uint leastOfAll;  // ordered bits
shared uint endsInBin;
shared uint bestCost;  // ordered bits: of the best so far
shared Split bests[kLargestGroup];

BuildNode node;
Split best;
Uvec2Array faces;
// Of the bin.
uint axis;
uint first, end;   // of its faces
uint left, right;  // references that begin before it and end after it

float positionOf(uint face) { return uintBitsToFloat(faces.at[face].x); }
uint begins(uint kind) { return kind != kEndFace ? 1u : 0u; }
uint ends(uint kind) { return kind != kStartFace ? 1u : 0u; }

void compareFaces() {
    for (uint candidate = first + gl_LocalInvocationID.x; candidate < end; candidate += gl_WorkGroupSize.x) {
        float x = positionOf(candidate);
        uint below = left;
        uint above = right;
        uint planar = 0u;
        for (uint k = first; k < end; k++) {
            uvec2 face = faces.at[k];
            float position = uintBitsToFloat(face.x);
            below += position < x ? begins(face.y) : 0u;
            above += position > x ? ends(face.y) : 0u;
            planar += position == x && face.y == kFlatFace ? 1u : 0u;
        }
        best = betterOfBothSides(best, args.costs, node.cell, axis, x, below, above, planar);
    }
}

void order(uint a, uint b) {
    uvec2 lower = faces.at[a];
    uvec2 upper = faces.at[b];
    if (uintBitsToFloat(lower.x) <= uintBitsToFloat(upper.x)) return;
    faces.at[a] = upper;
    faces.at[b] = lower;
}

// Bitonic (Batcher 1968), with every comparison ascending, so that faces beyond the last need not be there.
void sortFaces() {
    uint n = end - first;
    for (uint sorted = 1u; sorted < n; sorted *= 2u) {
        for (uint apart = sorted; apart > 0u; apart /= 2u) {
            meetInMemory();
            for (uint k = gl_LocalInvocationID.x;; k += gl_WorkGroupSize.x) {
                uint lower = 2u * k - (k & (apart - 1u));
                if (lower >= n) break;
                uint upper = apart == sorted ? lower ^ (2u * sorted - 1u) : lower + apart;
                if (upper < n) order(first + lower, first + upper);
            }
        }
    }
    meetInMemory();
}

// Faces are sorted; an invocation takes a run of them.
void sweepFaces() {
    uint run = ceilDiv(end - first, gl_WorkGroupSize.x);
    uint from = min(end, first + gl_LocalInvocationID.x * run);
    uint to = min(end, from + run);
    uint begun = 0u;
    uint ended = 0u;
    for (uint k = from; k < to; k++) {
        begun += begins(faces.at[k].y);
        ended += ends(faces.at[k].y);
    }
    if (gl_LocalInvocationID.x == 0u) endsInBin = 0u;
    meet();
    atomicAdd(endsInBin, ended);
    uvec4 before = sumBefore(uvec4(begun, ended, 0u, 0u), gl_WorkGroupSize.x);
    uint below = left + before.x;
    uint above = right + endsInBin - before.y;
    // Those at the position of the run before are its.
    uint k = from;
    for (; k < to && k > first && positionOf(k) == positionOf(k - 1u); k++) {
        below += begins(faces.at[k].y);
        above -= ends(faces.at[k].y);
    }
    while (k < to) {
        float x = positionOf(k);
        uint begunHere = 0u;
        uint planar = 0u;
        for (; k < end && positionOf(k) == x; k++) {
            uint kind = faces.at[k].y;
            begunHere += begins(kind);
            above -= ends(kind);
            planar += kind == kFlatFace ? 1u : 0u;
        }
        best = betterOfBothSides(best, args.costs, node.cell, axis, x, below, above, planar);
        below += begunHere;
    }
    meet();
}

uint capacity;

uint wordOf(uint bin) { return faceWord(node.chunk, capacity, bin / capacity, bin % capacity); }

// Bins from `from` on.
void listOpenBins(uint from) {
    if (gl_LocalInvocationID.x == 0u) {
        openCount = 0u;
        leastOfAll = orderedBits(infinity());
    }
    meet();
    uint to = min(from + kLookedAt, 3u * capacity);
    for (uint k = from + gl_LocalInvocationID.x; k < to; k += gl_WorkGroupSize.x) {
        uint word = wordOf(k);
        if (args.openBins.at[word] == kNone) continue;
        FaceBins bins = faceBins(node.cell, k / capacity, capacity);
        float least = leastCost(args.costs, node.cell, k / capacity, bins, k % capacity, args.bins.at[word], args.bins.at[word + capacity]);
        uint slot = atomicAdd(openCount, 1u);
        openBins[slot] = k;
        leasts[slot] = least;
        atomicMin(leastOfAll, orderedBits(least));
    }
    meet();
}

void chooseIn(uint bin) {
    axis = bin / capacity;
    uint word = wordOf(bin);
    first = args.openBins.at[word];
    end = args.openBins.at[word + capacity];
    left = args.bins.at[word];
    right = args.bins.at[word + capacity];
    if (end - first <= kMostComparedFaces) {
        compareFaces();
    } else {
        sortFaces();
        sweepFaces();
    }
    atomicMin(bestCost, orderedBits(best.cost));
}

// The most promising bins come first, then those of the others that may still be better.
void chooseInListed() {
    for (uint turn = 0u; turn < 2u; turn++) {
        for (uint k = 0u; k < openCount; k++) {
            if ((orderedBits(leasts[k]) == leastOfAll) != (turn == 0u)) continue;
            meet();
            bool canBeBest = leasts[k] <= fromOrderedBits(bestCost);
            meet();
            if (canBeBest) chooseIn(openBins[k]);
        }
    }
    meet();
}

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    uint n = args.chunks.at[c].node;
    BuildNodeArray nodes = nodesIn();
    node = nodes.at[n];
    if (node.chunk != c) return;
    faces = args.workFaces;
    best = noSplit();
    uint i = gl_LocalInvocationID.x;
    capacity = faceBinCapacity(node.count);
    if (i == 0u) bestCost = orderedBits(infinity());
    for (uint b = 0u; b < 3u * capacity; b += kLookedAt) {
        listOpenBins(b);
        chooseInListed();
    }
    bests[i] = best;
    for (uint others = gl_WorkGroupSize.x / 2u; others > 0u; others /= 2u) {
        meet();
        if (i < others && isBetter(bests[i + others], bests[i])) bests[i] = bests[i + others];
    }
    if (i != 0u) return;
    best = bests[0];
    bool keep = isWorthwhile(args.costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth);
    nodes.at[n].split = keep ? best : noSplit();
}
