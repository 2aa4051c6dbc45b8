// The structs of the public header and of the kernels are the same bytes.
#include "cleave/cleave.hpp"
#include "shared/build.h"
#include "shared/ray.h"
#include "shared/trace.h"
#include "shared/tree.h"

namespace cleave {

#define CLEAVE_SAME(A, a, B, b) static_assert(offsetof(A, a) == offsetof(B, b))
static_assert(sizeof(TreeHeader) == sizeof(TreeData) && TreeHeader::kMagic == kTreeMagic &&
              TreeHeader::kShortOfCapacity == kShortOfCapacity && kTreeFormat == kTreeFormatNumber);
CLEAVE_SAME(TreeHeader, levels, TreeData, levels);
CLEAVE_SAME(TreeHeader, noArea, TreeData, noArea);
CLEAVE_SAME(TreeHeader, exponent, TreeData, exponent);
CLEAVE_SAME(TreeHeader, lo, TreeData, bounds);
CLEAVE_SAME(TreeHeader, wanted, TreeData, wantedRefs);
CLEAVE_SAME(TreeHeader, bytes, TreeData, bytes);
CLEAVE_SAME(TreeHeader, wantedBytes, TreeData, wantedBytes);
CLEAVE_SAME(TreeHeader, triangles, TreeData, triangles);
CLEAVE_SAME(TreeHeader, leafRefs, TreeData, leafRefs);
static_assert(sizeof(OpenNode) == sizeof(OpenLeaf));
CLEAVE_SAME(OpenNode, lo, OpenLeaf, cell);
CLEAVE_SAME(OpenNode, node, OpenLeaf, treeNode);
CLEAVE_SAME(OpenNode, chunk, OpenLeaf, chunk);
static_assert(sizeof(TraceRay) == sizeof(Ray) && sizeof(TraceHit) == sizeof(Hit) &&
              sizeof(TraceSteps) == sizeof(StepCount) && sizeof(TraceCounts) == sizeof(TraceCounters));
CLEAVE_SAME(TraceRay, direction, Ray, direction);
CLEAVE_SAME(TraceRay, tMax, Ray, tMax);
CLEAVE_SAME(TraceHit, prim, Hit, prim);
CLEAVE_SAME(TraceHit, v, Hit, v);
CLEAVE_SAME(TraceSteps, resolved, StepCount, resolved);
#undef CLEAVE_SAME

}  // namespace cleave
