#version 460
// Builds small nodes to their leaves (Zhou et al. 2008, their small nodes). A workgroup takes block after block of
// references and builds the nodes that begin in it, level by level, an invocation per node. References stay where they
// are and levels list them; what is clipped becomes new references, made by all invocations together.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
#include "shared/clip.h"

layout(local_size_x_id = 0) in;

shared uint cutCount;
shared uint sizeCounts[4];
shared uvec4 groupTotal;

// The workgroup's part of the arrays: where its references begin, and its level's list and nodes.
PrimRefArray workRefs;
UintArray lists;
SahCosts costs;
uint refBase;
uint cutBase;
uint listBase;
uint nodeBase;
uint splitBase;

// Nodes of like size are split at the same time, so that invocations do not wait for each other.
void sortIn(uint k, uint count) {
    uint size = uint(count > 4u) + uint(count > 8u) + uint(count > 16u);
    uint at = atomicAdd(sizeCounts[size], 1u);
    args.workOrder.at[4u * splitBase + size * kWorkNodes + at] = k;
}
uint sorted(uint k) {
    uint size = 0u;
    for (; size < 3u && k >= sizeCounts[size]; size++) k -= sizeCounts[size];
    return args.workOrder.at[4u * splitBase + size * kWorkNodes + k];
}

PrimRef refAt(uint k) { return workRefs.at[refBase + lists.at[listBase + k]]; }

// The cheaper one, as betterOf(), but without branches; axes come in order.
Split cheaper(Split best, Box cell, uint axis, float position, uint left, uint right, uint planarLeft, bool counts) {
    float cost = splitCost(costs, cell, axis, position, left, right);
    bool isInside = counts && cell.lo[axis] < position && position < cell.hi[axis];
    bool wins = cost < best.cost || (cost == best.cost && axis == best.axis && position < best.position);
    if (isInside && wins) {
        best.cost = cost;
        best.axis = axis;
        best.position = position;
        best.planarLeft = planarLeft;
    }
    return best;
}

// How many boxes begin before four faces, end after them and lie in them.
struct FaceCounts {
    uvec4 left;
    uvec4 right;
    uvec4 planar;
};

FaceCounts noCounts() {
    FaceCounts c;
    c.left = uvec4(0u);
    c.right = uvec4(0u);
    c.planar = uvec4(0u);
    return c;
}

FaceCounts with(FaceCounts c, vec4 faces, float lo, float hi) {
    c.left += uvec4(lessThan(vec4(lo), faces));
    c.right += uvec4(greaterThan(vec4(hi), faces));
    c.planar += uvec4(equal(vec4(lo == hi ? lo : infinity()), faces));
    return c;
}

Split withFaces(Split best, Box cell, uint axis, vec4 faces, FaceCounts c) {
    [[unroll]] for (uint u = 0u; u < 4u; u++) {
        best = cheaper(best, cell, axis, faces[u], c.left[u] + c.planar[u], c.right[u], 1u, true);
    }
    if (any(notEqual(c.planar, uvec4(0u)))) {
        [[unroll]] for (uint u = 0u; u < 4u; u++) {
            best = cheaper(best, cell, axis, faces[u], c.left[u], c.right[u] + c.planar[u], 0u, c.planar[u] > 0u);
        }
    }
    return best;
}

uint refOf(WorkNode node, uint i) { return refBase + lists.at[listBase + node.first + min(i, node.count - 1u)]; }

// Of at most four references: their boxes are loaded once.
Split bestOfFew(WorkNode node) {
    Split best = noSplit();
    uvec4 refs;
    [[unroll]] for (uint u = 0u; u < 4u; u++) refs[u] = refOf(node, u);
    for (uint axis = 0u; axis < 3u; axis++) {
        vec4 lo;
        vec4 hi;
        [[unroll]] for (uint u = 0u; u < 4u; u++) {
            lo[u] = workRefs.at[refs[u]].lo[axis];
            hi[u] = workRefs.at[refs[u]].hi[axis];
        }
        FaceCounts ofLo = noCounts();
        FaceCounts ofHi = noCounts();
        [[unroll]] for (uint u = 0u; u < 4u; u++) {
            // What is not there begins nowhere and ends nowhere.
            bool isThere = u < node.count;
            float otherLo = isThere ? lo[u] : infinity();
            float otherHi = isThere ? hi[u] : -infinity();
            ofLo = with(ofLo, lo, otherLo, otherHi);
            ofHi = with(ofHi, hi, otherLo, otherHi);
        }
        best = withFaces(best, node.cell, axis, lo, ofLo);
        best = withFaces(best, node.cell, axis, hi, ofHi);
    }
    return best;
}

// Of any number: eight at once are compared with all.
Split bestOfMany(WorkNode node) {
    Split best = noSplit();
    for (uint axis = 0u; axis < 3u; axis++) {
        for (uint from = 0u; from < node.count; from += 8u) {
            vec4 lo[2];
            vec4 hi[2];
            FaceCounts ofLo[2];
            FaceCounts ofHi[2];
            [[unroll]] for (uint h = 0u; h < 2u; h++) {
                [[unroll]] for (uint u = 0u; u < 4u; u++) {
                    uint r = refOf(node, from + 4u * h + u);
                    lo[h][u] = workRefs.at[r].lo[axis];
                    hi[h][u] = workRefs.at[r].hi[axis];
                }
                ofLo[h] = noCounts();
                ofHi[h] = noCounts();
            }
            for (uint k = 0u; k < node.count; k++) {
                uint r = refBase + lists.at[listBase + node.first + k];
                float otherLo = workRefs.at[r].lo[axis];
                float otherHi = workRefs.at[r].hi[axis];
                [[unroll]] for (uint h = 0u; h < 2u; h++) {
                    ofLo[h] = with(ofLo[h], lo[h], otherLo, otherHi);
                    ofHi[h] = with(ofHi[h], hi[h], otherLo, otherHi);
                }
            }
            [[unroll]] for (uint h = 0u; h < 2u; h++) {
                best = withFaces(best, node.cell, axis, lo[h], ofLo[h]);
                best = withFaces(best, node.cell, axis, hi[h], ofHi[h]);
            }
        }
    }
    return best;
}

// Which references go where; those that straddle the plane are to be cut.
WorkSplit divided(WorkNode node, Split s, uint k) {
    WorkSplit w;
    w.axis = s.axis;
    w.position = s.position;
    w.left = 0u;
    w.right = 0u;
    for (uint i = 0u; i < node.count; i++) {
        uint r = refBase + lists.at[listBase + node.first + i];
        uint side = sideOf(workRefs.at[r].lo[s.axis], workRefs.at[r].hi[s.axis], s.position, s.planarLeft);
        w.left |= (side & kLeft) << i;
        w.right |= (side >> 1) << i;
    }
    w.both = w.left & w.right;
    w.cut = atomicAdd(cutCount, bitCount(w.both));
    uint next = w.cut;
    for (uint rest = w.both; rest != 0u && next < kWorkCuts; rest &= rest - 1u) {
        WorkCut c;
        c.bit = lowestBit(rest);
        c.ref = lists.at[listBase + node.first + c.bit];
        c.node = k;
        args.workCuts.at[cutBase + next] = c;
        next++;
    }
    return w;
}

void splitNode(uint k, uint depth) {
    WorkNode node = args.workNodes.at[nodeBase + k];
    Split best = noSplit();
    if (node.count <= 4u) best = bestOfFew(node);
    if (node.count > 4u) best = bestOfMany(node);
    WorkSplit w;
    w.axis = kLeafAxis;
    w.left = 0u;
    w.right = 0u;
    if (isWorthwhile(costs, best, node.cell, node.count, depth, args.state.at.maxDepth)) w = divided(node, best, k);
    args.workSplits.at[splitBase + k] = w;
}

// Makes the two parts of a reference, at `at`; one without a point of the triangle goes nowhere.
void cut(uint c, uint at) {
    WorkCut w = args.workCuts.at[cutBase + c];
    PrimRef r = workRefs.at[refBase + w.ref];
    uint axis = args.workSplits.at[splitBase + w.node].axis;
    float position = args.workSplits.at[splitBase + w.node].position;
    Box box;
    box.lo = r.lo;
    box.hi = r.hi;
    SplitBoxes parts;
    if (args.clip != 0u) {
        parts = splitBoxes(withoutNumber(args.triangles.at[r.prim]), box, axis, position);
    } else {
        parts.left = leftOf(box, axis, position);
        parts.right = rightOf(box, axis, position);
    }
    r.lo = parts.left.lo;
    r.hi = parts.left.hi;
    workRefs.at[refBase + at] = r;
    r.lo = parts.right.lo;
    r.hi = parts.right.hi;
    workRefs.at[refBase + at + 1u] = r;
    if (isEmpty(parts.left)) atomicAnd(args.workSplits.at[splitBase + w.node].left, ~(1u << w.bit));
    if (isEmpty(parts.right)) atomicAnd(args.workSplits.at[splitBase + w.node].right, ~(1u << w.bit));
}

// What a node adds: splits, references of the next level, references in leaves, nodes of the next level.
uvec4 additions(uint k) {
    WorkSplit w = args.workSplits.at[splitBase + k];
    if (w.axis == kLeafAxis) return uvec4(0u, 0u, args.workNodes.at[nodeBase + k].count, 0u);
    uint left = bitCount(w.left);
    uint right = bitCount(w.right);
    return uvec4(1u, left + right, 0u, min(left, 1u) + min(right, 1u));
}

// A child: a node of the next level, or an empty leaf.
void putChild(uint block, Box cell, uint first, uint count, uint number, uint next, uint leafRef) {
    if (count == 0u) {
        args.stagedNodes.at[block * kStagedNodes + number] = leafNode(leafRef, 0u);
        return;
    }
    WorkNode n;
    n.cell = cell;
    n.first = first;
    n.count = count;
    n.staged = number;
    args.workNodes.at[(nodeBase ^ kWorkNodes) + next] = n;
    sortIn(next, count);
}

// Stages a node, and hands its references on. `before`: what the nodes before it add. `at`: where the parts of cut
// references are.
void putNode(Subtrees s, uint block, uint k, uvec4 before, uint at) {
    WorkNode node = args.workNodes.at[nodeBase + k];
    WorkSplit w = args.workSplits.at[splitBase + k];
    uint leafRef = s.leafRefs + before.z;
    if (w.axis == kLeafAxis) {
        args.stagedNodes.at[block * kStagedNodes + node.staged] = leafNode(leafRef, node.count);
        for (uint i = 0u; i < node.count; i++) {
            args.stagedRefs.at[block * kStagedRefs + leafRef + i] = refAt(node.first + i).prim;
        }
        return;
    }
    uint child = s.nodes + 2u * before.x;
    args.stagedNodes.at[block * kStagedNodes + node.staged] = innerNode(w.axis, w.position, child);
    uint leftCount = bitCount(w.left);
    uint rightCount = bitCount(w.right);
    uint toLeft = (listBase ^ kWorkList) + before.y;
    uint toRight = toLeft + leftCount;
    uint part = at + 2u * w.cut;
    for (uint i = 0u; i < node.count; i++) {
        uint bit = 1u << i;
        uint left = lists.at[listBase + node.first + i];
        uint right = left;
        if ((w.both & bit) != 0u) {
            left = part;
            right = part + 1u;
            part += 2u;
        }
        if ((w.left & bit) != 0u) {
            lists.at[toLeft] = left;
            toLeft++;
        }
        if ((w.right & bit) != 0u) {
            lists.at[toRight] = right;
            toRight++;
        }
    }
    putChild(block, leftOf(node.cell, w.axis, w.position), before.y, leftCount, child, before.w, leafRef);
    putChild(block, rightOf(node.cell, w.axis, w.position), before.y + leftCount, rightCount, child + 1u,
             before.w + min(leftCount, 1u), leafRef);
}

// Sums up over the workgroup; `mine` becomes the sum of the invocations before.
uvec4 total(inout uvec4 mine) {
    uvec4 before = sumBefore(mine, gl_WorkGroupSize.x);
    if (gl_LocalInvocationID.x == gl_WorkGroupSize.x - 1u) groupTotal = before + mine;
    mine = before;
    meet();
    return groupTotal;
}

// The nodes of the level [first, end) that are to be built become the first level of subtrees. How many: x, and their
// references: y.
uvec4 takeRoots(uint first, uint end) {
    uint i = gl_LocalInvocationID.x;
    uint run = ceilDiv(end - first, gl_WorkGroupSize.x);
    uint from = first + i * run;
    uint to = min(from + run, end);
    uvec4 sum = uvec4(0u);
    for (uint n = from; n < to; n++) {
        uint count = nodesIn().at[n].count;
        if (isSubtree(count, args.exactUpTo)) sum += uvec4(1u, count, 0u, 0u);
    }
    uvec4 all = total(sum);
    for (uint n = from; n < to; n++) {
        BuildNode node = nodesIn().at[n];
        if (!isSubtree(node.count, args.exactUpTo)) continue;
        WorkNode w;
        w.cell = node.cell;
        w.first = sum.y;
        w.count = node.count;
        w.staged = sum.x;
        args.workNodes.at[nodeBase + sum.x] = w;
        sortIn(sum.x, node.count);
        for (uint k = 0u; k < node.count; k++) {
            workRefs.at[refBase + sum.y + k] = refsIn().at[node.first + k];
            lists.at[listBase + sum.y + k] = sum.y + k;
        }
        sum += uvec4(1u, node.count, 0u, 0u);
    }
    return all;
}

// Builds the subtrees of the roots; what became of them. Without nodes if they outgrow the workgroup.
Subtrees grown(uint block, uvec4 roots) {
    Subtrees s;
    s.roots = roots.x;
    s.nodes = roots.x;
    s.leafRefs = 0u;
    s.levels = 0u;
    uint refs = roots.y;
    uint i = gl_LocalInvocationID.x;
    for (uint count = roots.x; count > 0u;) {
        if (i == 0u) cutCount = 0u;
        meetInMemory();
        for (uint k = i; k < count; k += gl_WorkGroupSize.x) splitNode(sorted(k), push.depth + s.levels);
        meetInMemory();
        uint cuts = cutCount;
        bool fits = cuts <= kWorkCuts && refs + 2u * cuts <= kWorkRefs;
        for (uint c = i; fits && c < cuts; c += gl_WorkGroupSize.x) cut(c, refs + 2u * c);
        meetInMemory();
        if (i < 4u) sizeCounts[i] = 0u;
        uint run = ceilDiv(count, gl_WorkGroupSize.x);
        uint from = i * run;
        uint to = min(from + run, count);
        uvec4 sum = uvec4(0u);
        for (uint k = from; k < to; k++) sum += additions(k);
        uvec4 all = total(sum);
        if (!fits || all.y > kWorkList || all.w > kWorkNodes || s.nodes + 2u * all.x > kStagedNodes || s.leafRefs + all.z > kStagedRefs) {
            s.nodes = 0u;
            break;
        }
        for (uint k = from; k < to; k++) {
            putNode(s, block, k, sum, refs);
            sum += additions(k);
        }
        s.nodes += 2u * all.x;
        s.leafRefs += all.z;
        s.levels++;
        refs += 2u * cuts;
        count = all.w;
        listBase ^= kWorkList;
        nodeBase ^= kWorkNodes;
        meetInMemory();
    }
    return s;
}

void buildBlock(uint block) {
    BuildNodeArray level = nodesIn();
    uint i = gl_LocalInvocationID.x;
    uint end = min((block + 1u) * kBlock, thisLevel.refCount);
    uint first = refsIn().at[block * kBlock].node;
    if (level.at[first].first < block * kBlock) first++;
    uint last = refsIn().at[end - 1u].node;
    if (i < 4u) sizeCounts[i] = 0u;
    uvec4 roots = takeRoots(first, last + 1u);
    meetInMemory();
    if (push.depth >= args.state.at.maxDepth) roots.x = 0u;
    Subtrees s = grown(block, roots);
    s.firstNode = first;
    s.endNode = last + 1u;
    bool built = s.nodes > 0u;
    if (!built) {
        s.firstNode = 0u;
        s.endNode = 0u;
        s.roots = 0u;
        s.leafRefs = 0u;
        s.levels = 0u;
    }
    if (i == 0u) {
        args.subtrees.at[block] = s;
        args.blockSums.at[block] = uvec4(0u, 0u, s.nodes - s.roots, s.leafRefs);
    }
    uint run = ceilDiv(s.endNode - s.firstNode, gl_WorkGroupSize.x);
    uint from = first + i * run;
    uint to = built ? min(from + run, last + 1u) : from;
    uvec4 sum = uvec4(0u);
    for (uint n = from; n < to; n++) sum.x += isSubtree(level.at[n].count, args.exactUpTo) ? 1u : 0u;
    total(sum);
    for (uint n = from; n < to; n++) {
        if (!isSubtree(level.at[n].count, args.exactUpTo)) continue;
        level.at[n].split.axis = kSubtreeAxis;
        level.at[n].child = sum.x;
        sum.x++;
    }
}

void main() {
    uint blocks = ceilDiv(thisLevel.refCount, kBlock);
    uint workers = workersFor(blocks);
    uint worker = groupIndex();
    if (worker >= workers) return;
    workRefs = args.workRefs;
    lists = args.workLists;
    costs = args.costs;
    refBase = worker * kWorkRefs;
    cutBase = worker * kWorkCuts;
    listBase = worker * 2u * kWorkList;
    nodeBase = worker * 2u * kWorkNodes;
    splitBase = worker * kWorkNodes;
    for (uint block = worker; block < blocks; block += workers) {
        buildBlock(block);
        meetInMemory();
    }
}
