// Included where shared/build.h has declared what these hold.
#include "lib/arrays.glsl"

CLEAVE_ARRAY(PrimRefArray, PrimRef);
CLEAVE_ARRAY(BuildNodeArray, BuildNode);
CLEAVE_ARRAY(ChunkArray, Chunk);
CLEAVE_ARRAY(OpenLeafArray, OpenLeaf);
CLEAVE_ARRAY(SubtreesArray, Subtrees);
CLEAVE_ARRAY(WorkNodeArray, WorkNode);
CLEAVE_ARRAY(WorkSplitArray, WorkSplit);
CLEAVE_ARRAY(WorkCutArray, WorkCut);
CLEAVE_ARRAY(NearestFacesArray, NearestFaces);
CLEAVE_ARRAY(GeometryArray, GeometryData);
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer BuildStateRef { BuildState at; };
