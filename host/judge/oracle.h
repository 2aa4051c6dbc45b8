// The judges of hits.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cleave/modes.hpp"
#include "shared/ray.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// Same arithmetic: the shared triangle function in the plainest of loops. Judges tree and traversal, compared with ==.
// Invalid rays are misses.
Hit bruteForce(const TriangleSet& set, const Ray& ray, Query query);
// A textbook recursive walk of the tree, in double where planes are concerned. Answers equal bruteForce's with ==.
Hit stackWalk(const KdTree& tree, const TriangleSet& set, const Ray& ray, Query query);

// The reference: independent, wider arithmetic on the world-space triangles; judges the triangle function too. Hit or
// miss is decided by the exact sign of determinants where double's error bound does not decide it, and t has a relative
// error of at most 2^-98. So nothing about the ray is ever left open; what is called undecided is
// an answer that differs from the exact one
// - where a t is within a rounding of float of an end of the ray's interval, or of the largest float;
// - where the ray passes an edge of the triangle at fault within 4 units in the last place of that edge's largest
//   coordinate.
// An answer that is right there is right.
class Reference {
  public:
    explicit Reference(std::span<const Triangle> world, std::span<const uint32_t> included);
    ~Reference();
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    enum class Verdict { agrees, mismatch, undecided };
    // The kind of a mismatch, also given for undecided rays: a t or triangle that differs from the reference's, a miss
    // where it hits, or a hit where it misses.
    enum class Fault { none, wrong, missed, falseHit };
    struct Judgement {
        Verdict verdict = Verdict::agrees;
        Fault fault = Fault::none;
        // Of closest hits that agree: |t - tRef| / tRef; 0 where cancellation makes |tRef| less than its error in
        // double.
        double relativeTError = 0.0;
        // The same in units in the last place of tRef as a float; 0 where double's error is more than half of one.
        double ulpTError = 0.0;
        double referenceT = 0.0;  // the reference's own answer, where it is a fault
        uint32_t referencePrim = kNone;
    };
    // Judges one answer to one ray (a mismatch: hit or miss differs, or |t - tRef| > 1e-6 tRef, or the number differs
    // and the reference does not find the reported triangle at that t). For Query::any hit or miss only.
    Judgement judge(const Ray& ray, const Hit& hit, Query query) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Sums of judgements over many rays; `first` describes the first mismatch for a person.
struct CheckResult {
    uint64_t rays = 0;
    uint64_t mismatches = 0;
    uint64_t missed = 0, falseHits = 0;  // of the mismatches; the others are hits at a wrong t or of a wrong triangle
    uint64_t undecided = 0;
    double maxRelativeTError = 0.0;
    std::string first;

    void add(const CheckResult& more);  // its counts and its error; `first` stays
};
// Judges up to `count` of the rays, spread evenly; hits[i] answers rays[i]. Uses `threads` threads.
CheckResult check(const Reference& reference, std::span<const Ray> rays, std::span<const Hit> hits, Query query,
                  uint64_t count, uint32_t threads = 2);

}  // namespace cleave
