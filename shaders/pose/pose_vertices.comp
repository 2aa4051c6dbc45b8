#version 460
// Poses vertices: moved by morph targets, then by a skin or by their node, in double and rounded to float once. An
// invocation for each. Operations and their order are those of the host's pose (host/scene/posed_vertices.cpp), which
// is this kernel's twin.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/config.h"
#include "shared/geometry.h"
#include "shared/pose.h"
#include "shared/round.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(push_constant, scalar) uniform Push { PosePush push; };

// The last part whose vertices begin at or before this one.
PosePart partOf(uint vertex) {
    uint low = 0u;
    uint high = push.partCount;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (push.parts.at[middle].firstPosed <= vertex) low = middle;
        else high = middle;
    }
    return push.parts.at[low];
}

dvec3 morphed(PosePart part, uint vertex) {
    precise dvec3 position = push.positions.at[part.firstVertex + vertex];
    for (uint i = 0u; i < part.morphCount; i++) {
        PoseMorph morph = push.morphs.at[part.firstMorph + i];
        double weight = push.weights.at[part.firstWeight + morph.weight];
        if (weight == 0.0LF) continue;
        precise dvec3 delta = weight * push.deltas.at[morph.firstDelta + vertex];
        position = position + delta;
    }
    return position;
}

dvec3 divided(dvec3 v, double by) {
    return dvec3(correctedQuotient(v.x, by, v.x / by), correctedQuotient(v.y, by, v.y / by),
                 correctedQuotient(v.z, by, v.z / by));
}

// Sums the maps of joints by weight.
AffineMap skinMap(PosePart part, uint vertex) {
    precise dvec3 x = dvec3(0.0LF);
    precise dvec3 y = dvec3(0.0LF);
    precise dvec3 z = dvec3(0.0LF);
    precise dvec3 origin = dvec3(0.0LF);
    precise double weightSum = 0.0LF;
    uint first = part.firstInfluence + vertex * part.influenceCount;
    for (uint i = 0u; i < part.influenceCount; i++) {
        PoseInfluence influence = push.influences.at[first + i];
        if (influence.weight == 0.0LF) continue;
        AffineMap map = push.maps.at[part.firstJoint + influence.joint];
        precise dvec3 ownX = influence.weight * map.x;
        precise dvec3 ownY = influence.weight * map.y;
        precise dvec3 ownZ = influence.weight * map.z;
        precise dvec3 ownOrigin = influence.weight * map.origin;
        x = x + ownX;
        y = y + ownY;
        z = z + ownZ;
        origin = origin + ownOrigin;
        weightSum = weightSum + abs(influence.weight);
    }
    if (weightSum == 0.0LF) return push.maps.at[part.firstJoint + push.influences.at[first].joint];
    if (weightSum == 1.0LF) return AffineMap(x, y, z, origin);
    return AffineMap(divided(x, weightSum), divided(y, weightSum), divided(z, weightSum), divided(origin, weightSum));
}

void main() {
    uint posed = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (posed >= push.vertexCount) return;
    PosePart part = partOf(posed);
    uint vertex = posed - part.firstPosed;
    dvec3 p = morphed(part, vertex);
    AffineMap m;
    if (part.influenceCount > 0u) m = skinMap(part, vertex);
    else m = push.maps.at[part.map];
    push.posed.at[3u * posed] = roundedBits(transformedBy(m.x.x, m.y.x, m.z.x, m.origin.x, p));
    push.posed.at[3u * posed + 1u] = roundedBits(transformedBy(m.x.y, m.y.y, m.z.y, m.origin.y, p));
    push.posed.at[3u * posed + 2u] = roundedBits(transformedBy(m.x.z, m.y.z, m.z.z, m.origin.z, p));
}
