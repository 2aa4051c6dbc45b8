#version 460
// Builds small nodes to their leaves (Zhou et al. 2008, their small nodes). A workgroup takes batch after batch of them
// and builds it level by level, an invocation per node. References stay where they are and levels list them; what is
// clipped becomes new references, made by all invocations together.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
#include "lib/clip.glsl"

layout(local_size_x_id = 0) in;

shared uint cutCount;
shared uint sizeCounts[3];  // nodes of up to four references, of up to eight, and runs of eight in larger ones
shared uvec4 groupTotal;
shared uint nextBatch;

// The workgroup's part of the arrays: where its references begin, and its level's list and nodes.
PrimRefArray workRefs;
UintArray lists;
UintArray workOrder;
WorkNodeArray workNodes;
WorkSplitArray workSplits;
SahCosts costs;
uint refBase;
uint cutBase;
uint listBase;
uint nodeBase;
uint splitBase;
uint orderBase;

// Nodes of like size are split at the same time, so that invocations do not wait for each other; in a large one each
// looks at a run of eight references.
void sortIn(uint k, uint count) {
    uint size = min((count - 1u) / 4u, 2u);
    uint runs = size < 2u ? 1u : ceilDiv(count, 8u);
    uint at = orderBase + size * kWorkNodes + atomicAdd(sizeCounts[size], runs);
    [[unroll]] for (uint run = 0u; run < kSubtree / 8u; run++) {
        if (run < runs) workOrder.at[at + run] = k | run << 16;
    }
}
PrimRef refAt(uint k) { return workRefs.at[refBase + lists.at[listBase + k]]; }

uint refOf(WorkNode node, uint i) { return refBase + lists.at[listBase + node.first + min(i, node.count - 1u)]; }

#define NODE WorkNode
#define BOXES workRefs
#include "lib/best_face.glsl"

// Notes how a node is split, if that is worth it.
void choose(uint k, WorkNode node, Split best, uint depth) {
    WorkSplit w;
    w.axis = isWorthwhile(costs, best, node.cell, node.count, depth, args.state.at.maxDepth) ? best.axis : kLeafAxis;
    w.position = best.position;
    w.left = best.planarLeft;
    workSplits.at[splitBase + k] = w;
}

uint orderAt(uint size, uint k) { return workOrder.at[orderBase + size * kWorkNodes + k]; }

// The best plane of a run of a node is noted behind the splits of nodes.
void noteRun(uint k, Split s) {
    WorkSplit w;
    w.axis = s.axis;
    w.position = s.position;
    w.left = s.planarLeft;
    w.right = floatBitsToUint(s.cost);
    workSplits.at[splitBase + kWorkNodes + k] = w;
}
Split notedRun(uint k) {
    WorkSplit w = workSplits.at[splitBase + kWorkNodes + k];
    Split s;
    s.axis = w.axis;
    s.position = w.position;
    s.planarLeft = w.left;
    s.cost = uintBitsToFloat(w.right);
    return s;
}

void chooseSplits(uint depth, uint four, uint eight, uint runs) {
    uint i = gl_LocalInvocationID.x;
    for (uint k = i; k < four; k += gl_WorkGroupSize.x) {
        uint n = orderAt(0u, k);
        WorkNode node = workNodes.at[nodeBase + n];
        choose(n, node, bestOfFour(node), depth);
    }
    for (uint k = i; k < eight; k += gl_WorkGroupSize.x) {
        uint n = orderAt(1u, k);
        WorkNode node = workNodes.at[nodeBase + n];
        choose(n, node, bestOfEight(node), depth);
    }
    for (uint k = i; k < runs; k += gl_WorkGroupSize.x) {
        uint run = orderAt(2u, k);
        noteRun(k, bestOfRun(workNodes.at[nodeBase + (run & 0xFFFFu)], 8u * (run >> 16)));
    }
    meetInMemory();
    for (uint k = i; k < runs; k += gl_WorkGroupSize.x) {
        uint n = orderAt(2u, k);
        if (n >> 16 != 0u) continue;  // not a node's first run
        WorkNode node = workNodes.at[nodeBase + n];
        Split best = notedRun(k);
        for (uint run = 1u; 8u * run < node.count; run++) {
            Split s = notedRun(k + run);
            if (isBetter(s, best)) best = s;
        }
        choose(n, node, best, depth);
    }
}

// Which references go where; those that straddle the plane are to be cut.
void divide(uint k) {
    WorkSplit w = workSplits.at[splitBase + k];
    if (w.axis == kLeafAxis) return;
    WorkNode node = workNodes.at[nodeBase + k];
    uint planarLeft = w.left;
    w.left = 0u;
    w.right = 0u;
    uint i = 0u;
    do {
        uint r = refBase + lists.at[listBase + node.first + i];
        uint side = sideOf(workRefs.at[r].lo[w.axis], workRefs.at[r].hi[w.axis], w.position, planarLeft);
        w.left |= (side & kLeft) << i;
        w.right |= (side >> 1) << i;
        i++;
    } while (i < node.count);
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
    workSplits.at[splitBase + k] = w;
}

// Makes the two parts of a reference, at `at`; one without a point of the triangle goes nowhere.
void cut(uint c, uint at) {
    WorkCut w = args.workCuts.at[cutBase + c];
    PrimRef r = workRefs.at[refBase + w.ref];
    uint axis = workSplits.at[splitBase + w.node].axis;
    float position = workSplits.at[splitBase + w.node].position;
    Box box;
    box.lo = r.lo;
    box.hi = r.hi;
    SplitBoxes parts;
    if (args.clip != 0u) {
        parts = partsOf(withoutNumber(args.triangles.at[r.prim]), box, axis, position);
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
    if (isEmpty(parts.left)) atomicAnd(workSplits.at[splitBase + w.node].left, ~(1u << w.bit));
    if (isEmpty(parts.right)) atomicAnd(workSplits.at[splitBase + w.node].right, ~(1u << w.bit));
}

// What a node adds: splits, references of the next level, references in leaves, nodes of the next level.
uvec4 additions(uint k) {
    WorkSplit w = workSplits.at[splitBase + k];
    if (w.axis == kLeafAxis) return uvec4(0u, 0u, workNodes.at[nodeBase + k].count, 0u);
    uint left = bitCount(w.left);
    uint right = bitCount(w.right);
    return uvec4(1u, left + right, 0u, min(left, 1u) + min(right, 1u));
}

// A child: a node of the next level, or an empty leaf.
void putChild(uint batch, Box cell, uint first, uint count, uint number, uint next, uint leafRef) {
    if (count == 0u) {
        args.stagedNodes.at[batch * kStagedNodes + number] = leafNode(leafRef, 0u);
        return;
    }
    WorkNode n;
    n.cell = cell;
    n.first = first;
    n.count = count;
    n.staged = number;
    workNodes.at[(nodeBase ^ kWorkNodes) + next] = n;
    sortIn(next, count);
}

// Stages a node, and hands its references on. `before`: what the nodes before it add. `at`: where the parts of cut
// references are.
void putNode(Subtrees s, uint batch, uint k, uvec4 before, uint at) {
    WorkNode node = workNodes.at[nodeBase + k];
    WorkSplit w = workSplits.at[splitBase + k];
    uint leafRef = s.leafRefs + before.z;
    if (w.axis == kLeafAxis) {
        args.stagedNodes.at[batch * kStagedNodes + node.staged] = leafNode(leafRef, node.count);
        uint i = 0u;
        do {
            args.stagedRefs.at[batch * kStagedRefs + leafRef + i] = refAt(node.first + i).prim;
            i++;
        } while (i < node.count);
        return;
    }
    uint child = s.nodes + 2u * before.x;
    args.stagedNodes.at[batch * kStagedNodes + node.staged] = innerNode(w.axis, w.position, child);
    uint leftCount = bitCount(w.left);
    uint rightCount = bitCount(w.right);
    uint toLeft = (listBase ^ kWorkList) + before.y;
    uint toRight = toLeft + leftCount;
    uint part = at + 2u * w.cut;
    uint i = 0u;
    do {
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
        i++;
    } while (i < node.count);
    putChild(batch, leftOf(node.cell, w.axis, w.position), before.y, leftCount, child, before.w, leafRef);
    putChild(batch, rightOf(node.cell, w.axis, w.position), before.y + leftCount, rightCount, child + 1u,
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
        workNodes.at[nodeBase + sum.x] = w;
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
Subtrees grown(uint batch, uvec4 roots) {
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
        chooseSplits(push.depth + s.levels, sizeCounts[0], sizeCounts[1], sizeCounts[2]);
        meetInMemory();
        for (uint k = i; k < count; k += gl_WorkGroupSize.x) divide(k);
        meetInMemory();
        uint cuts = cutCount;
        bool fits = cuts <= kWorkCuts && refs + 2u * cuts <= kWorkRefs;
        for (uint c = i; fits && c < cuts; c += gl_WorkGroupSize.x) cut(c, refs + 2u * c);
        meetInMemory();
        if (i < 3u) sizeCounts[i] = 0u;
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
            putNode(s, batch, k, sum, refs);
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

void buildBatch(uint batch) {
    BuildNodeArray level = nodesIn();
    uint i = gl_LocalInvocationID.x;
    bool isLast = batch + 1u == ceilDiv(thisLevel.subtreeRefCount, kBatch);
    uint first = args.batchFirsts.at[batch];
    uint end = isLast ? thisLevel.nodeCount : args.batchFirsts.at[batch + 1u];
    if (i < 3u) sizeCounts[i] = 0u;
    uvec4 roots = takeRoots(first, end);
    meetInMemory();
    Subtrees s = grown(batch, roots);
    s.firstNode = first;
    s.endNode = end;
    bool built = s.nodes > 0u;
    if (!built) {
        s.firstNode = 0u;
        s.endNode = 0u;
        s.roots = 0u;
        s.leafRefs = 0u;
        s.levels = 0u;
    }
    if (i == 0u) {
        args.subtrees.at[batch] = s;
        args.blockSums.at[batch] = uvec4(0u, 0u, s.nodes - s.roots, s.leafRefs);
    }
    uint run = ceilDiv(s.endNode - s.firstNode, gl_WorkGroupSize.x);
    uint from = first + i * run;
    uint to = built ? min(from + run, end) : from;
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

// The next one that nobody has taken. Batches differ, so that sharing them out evenly would leave workgroups idle.
uint takenBatch() {
    if (gl_LocalInvocationID.x == 0u) nextBatch = atomicAdd(args.state.at.batchesTaken, 1u);
    meet();
    return nextBatch;
}

void main() {
    uint batches = ceilDiv(thisLevel.subtreeRefCount, kBatch);
    uint workers = min(batches, args.workers);
    uint worker = groupIndex();
    if (worker >= workers) return;
    workRefs = args.workRefs;
    lists = args.workLists;
    workOrder = args.workOrder;
    workNodes = args.workNodes;
    workSplits = args.workSplits;
    costs = args.costs;
    refBase = worker * kWorkRefs;
    cutBase = worker * kWorkCuts;
    listBase = worker * 2u * kWorkList;
    nodeBase = worker * 2u * kWorkNodes;
    splitBase = worker * 2u * kWorkNodes;
    orderBase = worker * 3u * kWorkNodes;
    for (uint batch = takenBatch(); batch < batches; batch = takenBatch()) {
        buildBatch(batch);
        meetInMemory();
    }
}
