#version 460
// Finds the bins of large nodes that may hold the best plane, and gives each its part of workFaces. Counters become the
// references that begin before a bin and end after it, bounds those of open bins. A workgroup per chunk; that of a node's first chunk acts, each
// invocation on a run of bins.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
#include "shared/face_bins.h"
layout(local_size_x_id = 0) in;

shared uint allStarts[3];  // that are counted
shared uint allEnds[3];
shared uint leastMost;   // ordered bits: the best plane costs at most that
shared uint openLo[3];   // where open bins are, as ordered bits
shared uint openHi[3];

BuildNode node;
uint capacity;
FaceBins bins[3];
uint from, to;

// What begins and ends in the run.
void countRun(out uvec3 starts, out uvec3 ends) {
    starts = uvec3(0u);
    ends = uvec3(0u);
    for (uint axis = 0u; axis < 3u; axis++) {
        for (uint b = from; b < to; b++) {
            uint word = faceWord(node.chunk, capacity, axis, b);
            starts[axis] += args.bins.at[word];
            ends[axis] += args.bins.at[word + capacity];
        }
    }
}

// Replaces the counters; a bound of what the best plane in these bins costs, at most `most`. `starts` and `ends`: before
// the run.
float boundRun(float most, uvec3 starts, uvec3 ends) {
    for (uint axis = 0u; axis < 3u; axis++) {
        for (uint b = from; b < to; b++) {
            uint word = faceWord(node.chunk, capacity, axis, b);
            uint begin = args.bins.at[word];
            uint end = args.bins.at[word + capacity];
            uint left = node.count - allStarts[axis] + starts[axis];
            uint right = node.count - ends[axis];
            args.bins.at[word] = left;
            args.bins.at[word + capacity] = right - end;
            args.openBins.at[word] = begin + end;
            if (isBetweenCandidates(bins[axis], b, starts[axis], allEnds[axis] - ends[axis])) {
                most = min(most, mostCost(args.costs, node.cell, axis, bins[axis], b, left, right));
            }
            starts[axis] += begin;
            ends[axis] += end;
        }
    }
    return most;
}

// Forgets the faces of bins that cannot hold the best plane; how many remain.
uint closeBins() {
    float most = fromOrderedBits(leastMost);
    uint faces = 0u;
    for (uint axis = 0u; axis < 3u; axis++) {
        for (uint b = from; b < to; b++) {
            uint word = faceWord(node.chunk, capacity, axis, b);
            uint inBin = args.openBins.at[word];
            if (inBin == 0u) continue;
            float least = leastCost(args.costs, node.cell, axis, bins[axis], b, args.bins.at[word], args.bins.at[word + capacity]);
            if (least > most) {
                args.openBins.at[word] = 0u;
                continue;
            }
            atomicMin(openLo[axis], orderedBits(faceBinEdge(bins[axis], b)));
            atomicMax(openHi[axis], orderedBits(faceBinEdge(bins[axis], b + 1u)));
            faces += inBin;
        }
    }
    return faces;
}

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    node = nodesIn().at[args.chunks.at[c].node];
    if (node.chunk != c) return;
    uint i = gl_LocalInvocationID.x;
    capacity = faceBinCapacity(node.count);
    for (uint axis = 0u; axis < 3u; axis++) bins[axis] = faceBins(node.cell, axis, capacity);
    uint run = ceilDiv(capacity, gl_WorkGroupSize.x);
    from = min(capacity, i * run);
    to = min(capacity, from + run);
    uvec3 starts, ends;
    countRun(starts, ends);
    uvec3 startsBefore = uvec3(sumBefore(uvec4(starts, 0u), gl_WorkGroupSize.x));
    meet();
    uvec3 endsBefore = uvec3(sumBefore(uvec4(ends, 0u), gl_WorkGroupSize.x));
    // What does not cost less than a leaf is not wanted.
    float most = collapsedAxes(node.cell) < 2u ? leafCost(args.costs, node.cell, node.count) : -1.0f;
    if (i == gl_WorkGroupSize.x - 1u) {
        for (uint axis = 0u; axis < 3u; axis++) {
            allStarts[axis] = startsBefore[axis] + starts[axis];
            allEnds[axis] = endsBefore[axis] + ends[axis];
            openLo[axis] = 0xFFFFFFFFu;
            openHi[axis] = 0u;
        }
        leastMost = orderedBits(most);
    }
    meet();
    atomicMin(leastMost, orderedBits(boundRun(most, startsBefore, endsBefore)));
    meet();
    uint first = 6u * node.first + sumBefore(uvec4(closeBins(), 0u, 0u, 0u), gl_WorkGroupSize.x).x;
    for (uint b = from; b < to; b++) {
        for (uint axis = 0u; axis < 3u; axis++) {
            uint word = faceWord(node.chunk, capacity, axis, b);
            uint inBin = args.openBins.at[word];
            args.openBins.at[word] = inBin > 0u ? first : kNone;
            args.openBins.at[word + capacity] = inBin > 0u ? first : kNone;
            first += inBin;
        }
    }
    if (i < 3u) {
        args.bounds.at[c * kBoundsWords + i] = openLo[i];
        args.bounds.at[c * kBoundsWords + 3u + i] = openHi[i];
    }
}
