// Vertices that move while an animation plays, and what poses them. Tables of vertices are the same at all times; a
// time has matrices and weights.
#ifndef CLEAVE_SHARED_POSE_H
#define CLEAVE_SHARED_POSE_H
#include "language.h"

CLEAVE_BEGIN

// A primitive in one place.
struct PosePart {
    uint firstPosed;      // of the vertices of all parts, where its own begin
    uint firstVertex;     // in positions
    uint firstMorph;      // of its morph targets
    uint morphCount;      // of them
    uint firstWeight;     // of its node, in weights
    uint firstInfluence;  // of its first vertex
    uint influenceCount;  // of joints on each vertex; 0: placed by its node
    uint firstJoint;      // of its skin, in maps
    uint map;             // of its node, in maps
    uint reserved;
};
CLEAVE_SIZE(PosePart, 40);

// How a morph target moves a primitive.
struct PoseMorph {
    uint weight;      // of its node's weights
    uint firstDelta;  // of the primitive's first vertex
};
CLEAVE_SIZE(PoseMorph, 8);

// How much a vertex follows a joint.
struct PoseInfluence {
    double weight;
    uint joint;  // of the skin
    uint reserved;
};
CLEAVE_SIZE(PoseInfluence, 16);

// v is mapped to x v.x + y v.y + z v.z + origin.
struct AffineMap {
    dvec3 x;
    dvec3 y;
    dvec3 z;
    dvec3 origin;
};
CLEAVE_SIZE(AffineMap, 96);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer PoseWordArray { uint at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer PosePartArray { PosePart at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer PoseMorphArray { PoseMorph at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PoseInfluenceArray { PoseInfluence at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PosePointArray { dvec3 at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PoseWeightArray { double at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer AffineMapArray { AffineMap at[]; };
#endif

struct PosePush {
    CLEAVE_ADDRESS(PosePartArray) parts;
    CLEAVE_ADDRESS(PosePointArray) positions;  // of vertices
    CLEAVE_ADDRESS(PoseMorphArray) morphs;
    CLEAVE_ADDRESS(PosePointArray) deltas;  // of vertices, by morph targets
    CLEAVE_ADDRESS(PoseInfluenceArray) influences;
    CLEAVE_ADDRESS(AffineMapArray) maps;
    CLEAVE_ADDRESS(PoseWeightArray) weights;
    CLEAVE_ADDRESS(PoseWordArray) posed;      // vertices of all parts: three floats each
    CLEAVE_ADDRESS(PoseWordArray) corners;    // of triangles that move, three each: numbers of posed vertices
    CLEAVE_ADDRESS(PoseWordArray) numbers;    // of these triangles
    CLEAVE_ADDRESS(PoseWordArray) triangles;  // of the scene: nine floats each
    uint partCount;
    uint vertexCount;  // of all parts
    uint triangleCount;
    uint reserved;
};
CLEAVE_SIZE(PosePush, 104);

CLEAVE_END
#endif
