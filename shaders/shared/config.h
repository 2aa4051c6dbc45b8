// Every knob of the GPU program, a sentence each. Included by GLSL and by C++.
#ifndef CLEAVE_SHARED_CONFIG_H
#define CLEAVE_SHARED_CONFIG_H
#include "language.h"

CLEAVE_BEGIN

// Cost model of every surface-area-heuristic builder (Wald and Havran 2006).
CLEAVE_CONST float kCostTraverse = 15.0f;
CLEAVE_CONST float kCostIntersect = 20.0f;
CLEAVE_CONST float kEmptyBonus = 0.8f;  // multiplies the cost of a split that leaves a side empty

// Deepest leaf. The restart trail holds one bit per inner level in two words, and needs one bit to spare.
CLEAVE_CONST uint kMaxDepth = 63u;

// Bins per axis of min-max binning (Shevtsov et al. 2007, section 4.1).
CLEAVE_CONST uint kBins = 32u;

// A node with at most so many references is split by exact SAH, by one workgroup, instead of by binning. The survey
// says 32, the number of bins; on scans, whose vertices lie on a grid, the planes that cut nothing are seen by exact
// SAH only (docs/decisions.md).
CLEAVE_CONST uint kExactBelow = 160u;
CLEAVE_CONST uint kMostExactBelow = 1024u;  // the work grows with its square

// References that one workgroup of `bounds` and `bin` reads: a large node is cut into chunks of this size.
CLEAVE_CONST uint kChunk = 1024u;

// References (or nodes) of one block of a scan: its sum is one entry of the block sums.
CLEAVE_CONST uint kBlock = 256u;

// Invocations per workgroup of the passes that treat elements one by one.
CLEAVE_CONST uint kGroup = 64u;

// Inner nodes after which a traversal gives up on a ray and counts it as capped: above what any valid tree needs. A ray
// that comes from a million diagonals away visits all cells along its way, from the restart node each: 24 million nodes
// in the dragon.
CLEAVE_CONST uint kStepCap = 1u << 30;

CLEAVE_END
#endif
