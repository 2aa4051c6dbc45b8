// Counts the children of a node once its references are classified; for count_children and emit_nodes.

// Left and right references of the level before one of them, or before its end.
uvec2 offsetsAt(uint index) {
    if (index == thisLevel.refCount) return args.state.at.refTotals.xy;
    uint word = args.sides.at[index];
    return args.blockSums.at[index / kBlock].xy + countsBefore(word);
}

// Left and right references of a node: the difference of the offsets at its ends.
uvec2 childCounts(BuildNode node) {
    if (node.split.axis >= kLeafAxis) return uvec2(0u);
    return offsetsAt(node.first + node.count) - offsetsAt(node.first);
}

// What a node adds to the sums of its block: splits, references in leaves, and of the next level chunks and references
// of nodes that `subtrees` builds.
uvec4 nodeCounts(BuildNode node, uvec2 children) {
    if (node.split.axis == kLeafAxis) return uvec4(0u, node.count, 0u, 0u);
    if (node.split.axis == kSubtreeAxis) return uvec4(0u);
    uint upTo = args.exactUpTo;
    return uvec4(1u, 0u, chunksOf(children.x, upTo) + chunksOf(children.y, upTo), subtreeRefsOf(children.x, upTo) + subtreeRefsOf(children.y, upTo));
}
