// Constants of building and tracing that one may want to tune, for GLSL and C++ alike.
#ifndef CLEAVE_SHARED_CONFIG_H
#define CLEAVE_SHARED_CONFIG_H
#include "language.h"

CLEAVE_BEGIN

// What the surface area heuristic counts with, in every builder that uses it: the costs of an inner node, of a triangle
// test and of a leaf (C_i, C_o and C_l of the survey, section 4), and the factor on the cost of a split that leaves a
// side empty. Wald and Havran's (2006) by default, who know no cost of a leaf.
struct SahCosts {
    float traverse;
    float intersect;
    float leaf;
    float emptyBonus;  // 1: none
};
CLEAVE_SIZE(SahCosts, 16);
CLEAVE_CONST float kLeastCost = 0.001f;
CLEAVE_CONST float kMostCost = 1000.0f;
CLEAVE_CONST float kCostTraverse = 15.0f;
CLEAVE_CONST float kCostIntersect = 20.0f;
CLEAVE_CONST float kCostLeaf = 0.0f;
CLEAVE_CONST float kEmptyBonus = 0.8f;

#ifdef __cplusplus
constexpr SahCosts kDefaultCosts{kCostTraverse, kCostIntersect, kCostLeaf, kEmptyBonus};
#endif

// Greatest depth of a leaf. The restart trail has one bit per level of inner nodes in two words, and needs a spare one.
CLEAVE_CONST uint kMaxDepth = 63u;

// Bins per axis of min-max binning (Shevtsov et al. 2007, section 4.1).
CLEAVE_CONST uint kBins = 32u;

// A node of at most this many references is split by exact SAH instead of by binning. The survey
// says 32, the number of bins; but on scans, whose vertices lie on a grid, only exact SAH finds the planes that cut no
// triangle (docs/decisions.md).
CLEAVE_CONST uint kExactUpTo = 224u;
CLEAVE_CONST uint kMostExactUpTo = 1024u;  // the work grows with its square

// References per workgroup of `bin` and `nearest`. Larger nodes are divided into chunks of this size.
CLEAVE_CONST uint kChunk = 1024u;

// References (or nodes) per block of a scan. Each block contributes one entry to the block sums.
CLEAVE_CONST uint kBlock = 256u;

// A node of at most this many references is built to its leaves by one invocation after another of a single workgroup
// (`subtrees`), instead of level by level. One bit of a word stands for a reference.
CLEAVE_CONST uint kSubtree = 32u;

// Such nodes of a level are built in batches: all that begin in so many of their references. At least kBlock.
CLEAVE_CONST uint kBatch = 512u;

// A level's batches are shared out to at most so many workgroups: one for every so many batches that a build has room
// for. A workgroup takes one batch after the other, and has to work with: references (those of its nodes and two for
// each that is clipped), references that are clipped in a level, references and nodes of a level. Subtrees that outgrow
// it are built level by level after all. The last two are powers of two.
CLEAVE_CONST uint kBatchesPerWorker = 16u;
CLEAVE_CONST uint kMostWorkers = 256u;
CLEAVE_CONST uint kWorkRefs = 10240u;
CLEAVE_CONST uint kWorkCuts = 1024u;
CLEAVE_CONST uint kWorkList = 4096u;
CLEAVE_CONST uint kWorkNodes = 1024u;

// Nodes and leaf references that the subtrees of a batch may have.
CLEAVE_CONST uint kStagedNodes = 5120u;
CLEAVE_CONST uint kStagedRefs = 3584u;

// Invocations per workgroup of the passes that process one element each.
CLEAVE_CONST uint kGroup = 64u;

// The largest workgroup that a kernel has. Vulkan promises 128 invocations; devices with fewer than these are refused.
CLEAVE_CONST uint kLargestGroup = 256u;

CLEAVE_END
#endif
