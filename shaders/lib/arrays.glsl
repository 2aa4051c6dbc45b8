// Arrays in device memory, reached by their addresses.
#ifndef CLEAVE_LIB_ARRAYS
#define CLEAVE_LIB_ARRAYS
#define CLEAVE_ARRAY(Name, Type) \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Name { Type at[]; }

CLEAVE_ARRAY(FloatArray, float);
CLEAVE_ARRAY(UintArray, uint);
CLEAVE_ARRAY(Uvec2Array, uvec2);
CLEAVE_ARRAY(Uvec4Array, uvec4);
CLEAVE_ARRAY(BoxArray, Box);
CLEAVE_ARRAY(TriangleArray, Triangle);
CLEAVE_ARRAY(KdNodeArray, KdNode);
CLEAVE_ARRAY(TreeTriangleArray, TreeTriangle);
// Pairs of words that are loaded at once.
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PairArray { double at[]; };
#endif
