#version 460
// Moves each reference to its place in the next level, or into its leaf's list; stable. Finds the bounds of the references
// of large nodes of the next level. A workgroup per block. References that were clipped, which go to two places, are treated
// after the others.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

shared uint clipped[kBlock];  // positions in the block; their order decides nothing
shared uint clippedCount;
shared uint lastLo[6];        // bounds of the children of the block's last node, as ordered bits: left xyz, right xyz
shared uint lastHi[6];

// The node that the invocation moves references of: the next one's is mostly the same.
uint current = kNone;
uint child, first, leftBase, rightBase;
uint chunks[2];  // its children's first chunks, kNone of those that are not large
Box bounds[2];   // of the references that went to them

// Whether it has children that may be large.
bool isLargeAndSplit(BuildNode node) { return isLarge(node.count, args.exactUpTo) && node.child != kNone; }

uint chunkOfLarge(uint index) {
    BuildNode node = nodesOut().at[index];
    return isLarge(node.count, args.exactUpTo) ? node.chunk : kNone;
}

void includeInMemory() {
    for (uint side = 0u; side < 2u; side++) {
        if (current == kNone || chunks[side] == kNone) continue;
        for (uint axis = 0u; axis < 3u; axis++) {
            atomicMin(args.bounds.at[chunks[side] * kBoundsWords + axis], orderedBits(bounds[side].lo[axis]));
            atomicMax(args.bounds.at[chunks[side] * kBoundsWords + 3u + axis], orderedBits(bounds[side].hi[axis]));
        }
    }
}

void turnTo(uint index) {
    if (index == current) return;
    includeInMemory();
    current = index;
    BuildNode node = nodesIn().at[index];
    child = node.child;
    first = node.first;
    leftBase = node.leftBase;
    rightBase = node.rightBase;
    bool large = isLargeAndSplit(node);
    chunks[0] = large ? chunkOfLarge(child) : kNone;
    chunks[1] = large ? chunkOfLarge(child + 1u) : kNone;
    bounds[0] = emptyBox();
    bounds[1] = emptyBox();
}

void place(uint index, uint prim, Box box, uint side) {
    PrimRef r;
    r.lo = box.lo;
    r.prim = prim;
    r.hi = box.hi;
    r.node = child + side;
    refsOut().at[index] = r;
}

Box withBox(Box all, Box b, bool counts) {
    all.lo = mix(all.lo, min(all.lo, b.lo), bvec3(counts));
    all.hi = mix(all.hi, max(all.hi, b.hi), bvec3(counts));
    return all;
}

// `before`: left and right references of the level before this one.
void moveWhole(uint i, uint side, uvec2 before) {
    PrimRef r = refsIn().at[i];
    turnTo(r.node);
    if (child == kNone) {
        args.leafRefs.at[leftBase + i - first] = r.prim;
        return;
    }
    if (side == 0u) return;  // its node is built already
    Box box;
    box.lo = r.lo;
    box.hi = r.hi;
    bool isLeft = side == kLeft;
    place(isLeft ? leftBase + before.x : rightBase + before.y, r.prim, box, isLeft ? 0u : 1u);
    bounds[0] = withBox(bounds[0], box, isLeft);
    bounds[1] = withBox(bounds[1], box, !isLeft);
}

void moveParts(uint i, uint side, uvec2 before) {
    PrimRef r = refsIn().at[i];
    turnTo(r.node);
    if ((side & kLeft) != 0u) {
        Box left = args.clipped.at[2u * i];
        place(leftBase + before.x, r.prim, left, 0u);
        bounds[0] = withBox(bounds[0], left, true);
    }
    if ((side & kRight) != 0u) {
        Box right = args.clipped.at[2u * i + 1u];
        place(rightBase + before.y, r.prim, right, 1u);
        bounds[1] = withBox(bounds[1], right, true);
    }
}

// Most invocations are at the same node in the end: its bounds meet in shared memory first.
void includeAll(uint lastRef) {
    uint i = gl_LocalInvocationID.x;
    uint last = refsIn().at[lastRef].node;
    BuildNode node = nodesIn().at[last];
    if (isLargeAndSplit(node)) {
        if (current == last) {
            for (uint side = 0u; side < 2u; side++) {
                for (uint axis = 0u; axis < 3u; axis++) {
                    atomicMin(lastLo[3u * side + axis], orderedBits(bounds[side].lo[axis]));
                    atomicMax(lastHi[3u * side + axis], orderedBits(bounds[side].hi[axis]));
                }
            }
            current = kNone;
        }
        meet();
        uint chunk = i < 6u ? chunkOfLarge(node.child + i / 3u) : kNone;
        if (chunk != kNone) {
            atomicMin(args.bounds.at[chunk * kBoundsWords + i % 3u], lastLo[i]);
            atomicMax(args.bounds.at[chunk * kBoundsWords + 3u + i % 3u], lastHi[i]);
        }
    }
    includeInMemory();
}

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    uint begin = block * kBlock;
    uint count = min(kBlock, refCount - begin);
    if (i == 0u) clippedCount = 0u;
    if (i < 6u) {
        lastLo[i] = 0xFFFFFFFFu;
        lastHi[i] = 0u;
    }
    meet();
    bool leaves = args.state.at.finish != 0u;  // all nodes become leaves, whatever side references were to go to
    uvec2 beforeBlock = args.blockSums.at[block].xy;
    if (!touch(refsIn(), begin, begin + count, 1u)) return;
    for (uint k = i; k < count; k += gl_WorkGroupSize.x) {
        uint word = args.sides.at[begin + k];
        if ((word & kClipped) != 0u && !leaves) {
            clipped[atomicAdd(clippedCount, 1u)] = k;
        } else {
            moveWhole(begin + k, sidesIn(word), beforeBlock + countsBefore(word));
        }
    }
    meet();
    for (uint k = i; k < clippedCount; k += gl_WorkGroupSize.x) {
        uint word = args.sides.at[begin + clipped[k]];
        moveParts(begin + clipped[k], sidesIn(word), beforeBlock + countsBefore(word));
    }
    includeAll(begin + count - 1u);
}
