// The passes of a build, in the order in which they run: all that recording, twin and tests know of them.
//
// A row: the kernel (shaders/build/<kernel>.comp), its twin (host/twin), the member of Level that tells how many
// workgroups it takes, how many lanes a workgroup has, what `scan` sums up, in which builds it runs. To add a pass
// means its .comp, its twin, its test and its row.
#pragma once

#include <cstddef>

#include "shared/build.h"

namespace cleave {

// Run once, over the triangles: sized like a level of one node with a reference per triangle.
#define CLEAVE_SETUP_PASSES(ROW)                                  \
    ROW(find_scale, findScale, perRefBlock, wide, 0, all)         \
    ROW(load_triangles, loadTriangles, perRefBlock, wide, 0, all) \
    ROW(scan, scanTriangles, once, wide, kScanTriangles, all)     \
    ROW(make_refs, makeRefs, perRefBlock, wide, 0, all)           \
    ROW(begin, begin, once, own, 0, all)

// Run once in place of these, where a tree that was left open is built further: sized like a level of the references of
// its open nodes.
#define CLEAVE_EXPAND_PASSES(ROW) ROW(expand, expand, perRefBlock, narrow, 0, all)

// Run on every level.
#define CLEAVE_LEVEL_PASSES(ROW)                                   \
    ROW(bin, bin, perChunk, narrow, 0, binned)                     \
    ROW(choose_split, chooseSplit, perChunk, narrow, 0, binned)    \
    ROW(nearest, nearest, perChunk, narrow, 0, snapping)           \
    ROW(snap, snap, perChunkGroup, own, 0, snapping)               \
    ROW(clear_bins, clearBins, perChunk, narrow, 0, exact)         \
    ROW(count_faces, countFaces, perChunk, narrow, 0, exact)       \
    ROW(open_bins, openBins, perChunk, wide, 0, exact)             \
    ROW(gather_faces, gatherFaces, perChunk, narrow, 0, exact)     \
    ROW(choose_face, chooseFace, perChunk, wide, 0, exact)         \
    ROW(subtrees, subtrees, perWorker, narrow, 0, all)             \
    ROW(exact_split, exactSplit, perRefBlock, wide, 0, closed)     \
    ROW(classify, classify, perRefBlock, narrow, 0, all)           \
    ROW(scan, scanRefs, once, wide, kScanRefs, all)                \
    ROW(count_children, countChildren, perNodeBlock, wide, 0, all) \
    ROW(next_level, nextLevel, once, wide, 0, all)                 \
    ROW(emit_nodes, emitNodes, perNodeBlock, wide, 0, all)         \
    ROW(partition, partition, perRefBlock, wide, 0, all)           \
    ROW(graft, graft, perBatch, wide, 0, all)

// Run once, at the end.
#define CLEAVE_LAST_PASSES(ROW) ROW(finish_tree, finishTree, once, own, 0, all)

// Lanes of a workgroup: the kernel's own number, or a specialisation constant that suits the device: a large one, or a
// small one for kernels that need many registers, or whose lanes add to the same few counters.
enum class Lanes { own, wide, narrow };

// All builds, or of those that may have large nodes: those that bin them, those of these that move planes to faces, and
// those that split them by exact SAH, too; or those that leave no node open.
enum class Builds { all, binned, snapping, exact, closed };

// What a build is of these.
struct PassChoice {
    bool binned = true;
    bool snapping = true;
    bool exact = false;
    bool closed = true;
};

struct BuildPass {
    const char* kernel;
    size_t groups;  // offset of its DispatchSize in Level
    Lanes lanes;
    uint32_t scans;
    Builds builds;

    bool runs(PassChoice choice) const {
        switch (builds) {
            case Builds::binned:
                return choice.binned;
            case Builds::snapping:
                return choice.snapping;
            case Builds::exact:
                return choice.exact;
            case Builds::closed:
                return choice.closed;
            default:
                return true;
        }
    }
};

#define CLEAVE_BUILD_PASS(kernel, twin, groups, lanes, scans, builds) \
    BuildPass{#kernel, offsetof(Level, groups), Lanes::lanes, scans, Builds::builds},
inline constexpr BuildPass kSetupPasses[] = {CLEAVE_SETUP_PASSES(CLEAVE_BUILD_PASS)};
inline constexpr BuildPass kExpandPasses[] = {CLEAVE_EXPAND_PASSES(CLEAVE_BUILD_PASS)};
inline constexpr BuildPass kLevelPasses[] = {CLEAVE_LEVEL_PASSES(CLEAVE_BUILD_PASS)};
inline constexpr BuildPass kLastPasses[] = {CLEAVE_LAST_PASSES(CLEAVE_BUILD_PASS)};
#undef CLEAVE_BUILD_PASS

}  // namespace cleave
