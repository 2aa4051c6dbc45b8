// One cell of the table of stability: a case, a builder, a traversal and a family of rays, and what came of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "judge/oracle.h"
#include "run/tracer.h"
#include "stability/ray_families.h"

namespace cleave {

// Rays of a family, the answers that every builder and every traversal must give, and what the reference says of those.
struct Volley {
    const RayFamily* family = nullptr;
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    std::vector<Reference::Judgement> judged;
    bool byBruteForce = false;  // else the answers of the first builder's tree, by the first traversal
};

struct Cell {
    std::string scene, builder, traversal, family;
    bool isEdgeFamily = false;
    uint64_t rays = 0;
    uint64_t hits = 0;
    uint64_t wrong = 0;             // hit, but another t or triangle than the reference's
    uint64_t missed = 0;            // the reference hits
    uint64_t falseHits = 0;         // the reference misses
    uint64_t undecided = 0;         // see Reference
    uint64_t differing = 0;         // t, prim, u or v is not the expected one, with ==
    uint64_t capped = 0;            // given up at the step cap
    double maxUlpError = 0.0;       // of t, in units in the last place of the reference's t
    double maxRelativeError = 0.0;  // of t
    uint32_t mostSteps = 0;         // nodes and leaves visited; 0 where a traversal does not count
    double ms = 0.0;                // tracing alone, steps being counted
    bool byBruteForce = false;      // as in Volley
    std::string first;              // the first ray that breaks a bound, or else the first undecided one, for a person
};

// Judges many answers, on `threads` threads.
std::vector<Reference::Judgement> judgeAll(const Reference& reference, std::span<const Ray> rays,
                                           std::span<const Hit> hits, uint32_t threads);

// Fills a cell's counts. Answers that equal the expected ones have been judged already; only others are judged here.
// An answer to Query::any is as expected if it is a hit where a hit is expected, and none closer than that.
void count(Cell& cell, const Volley& volley, const Tracer::Result& traced, const Reference& reference, Query query);

// Why the cell is out of bounds; empty if it is not. Bounds: no wrong, missed or false answer, none that differs, no
// capped ray, and at most 1 in 100,000 undecided (rounded up) outside of edge families.
std::string whyBroken(const Cell& cell);

// Throws Error, naming the first broken cell and how many there are, if any cell is out of bounds.
void requireWithinBounds(std::span<const Cell> cells);

}  // namespace cleave
