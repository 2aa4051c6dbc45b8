// Every pass of a build starts with this.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/build.h"
#include "lib/group.glsl"
#include "lib/meet.glsl"

layout(push_constant, scalar) uniform Push { BuildPush push; };

#define args push.args.at

PrimRefArray refsIn() { return (push.depth & 1u) == 0u ? args.refs0 : args.refs1; }
PrimRefArray refsOut() { return (push.depth & 1u) == 0u ? args.refs1 : args.refs0; }
BuildNodeArray nodesIn() { return (push.depth & 1u) == 0u ? args.nodes0 : args.nodes1; }
BuildNodeArray nodesOut() { return (push.depth & 1u) == 0u ? args.nodes1 : args.nodes0; }
#define thisLevel args.state.at.level[push.depth]

// Left and right references of its block before the one that has this word of `sides`.
uvec2 countsBefore(uint word) { return uvec2(leftBefore(word), rightBefore(word)); }

void setBounds(uint chunk, Box b) {
    for (uint axis = 0u; axis < 3u; axis++) {
        args.bounds.at[chunk * kBoundsWords + axis] = orderedBits(b.lo[axis]);
        args.bounds.at[chunk * kBoundsWords + 3u + axis] = orderedBits(b.hi[axis]);
    }
}

BinRange rangeOf(uint chunk, uint axis) {
    uint b = chunk * kBoundsWords + axis;
    return binRange(fromOrderedBits(args.bounds.at[b]), fromOrderedBits(args.bounds.at[b + 3u]), args.binCount,
                    args.invBinCount);
}
