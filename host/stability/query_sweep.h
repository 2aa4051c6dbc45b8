// Asks a scene's trees for all hits, counts, insides, nearest points and overlaps, and compares with brute force by
// exact predicates (judge/crossings.h, judge/nearest.h, judge/separation.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "run/searcher.h"
#include "run/tracer.h"

namespace cleave {

// One query of one scene under one builder.
struct QueryCell {
    std::string scene, builder, query;
    uint64_t asked = 0;      // rays, points or boxes
    uint64_t differing = 0;  // answered otherwise than brute force does
    std::string first;       // the first of these, for a person
};

// How a tree answers.
struct QueriesUnderTest {
    std::string builder;
    std::function<std::vector<Hit>(std::span<const Ray> rays, uint32_t hitsPerRay)> all;
    std::function<std::vector<int32_t>(std::span<const Ray> rays, bool isSigned)> count;
    std::function<std::vector<uint8_t>(std::span<const vec3> points)> contains;
    std::function<std::vector<Hit>(std::span<const vec3> points)> nearest;
    std::function<std::vector<uvec2>(std::span<const Box> boxes)> overlaps;
};
// All of them lead to the device; what is given outlives the answers.
QueriesUnderTest queriesOf(const std::string& builder, const DeviceTree& tree, Tracer& tracer, Searcher& searcher);

struct QuerySweepSettings {
    uint64_t items = 1000;    // of each query, unless
    uint64_t work = 100'000;  // so many pairs of an item and a triangle are less
    uint64_t seed = 1;
    uint32_t threads = 2;
};

class QuerySweep {
  public:
    // `world` and `set` outlive this. Makes rays, points and boxes, and answers them by brute force.
    QuerySweep(std::string scene, std::span<const Triangle> world, const TriangleSet& set,
               const QuerySweepSettings& settings);

    // A cell per query. Insides are asked of closed surfaces only.
    std::vector<QueryCell> run(const QueriesUnderTest& tested) const;

  private:
    bool isNear(const vec3& point, const Hit& hit, double wanted) const;

    std::string scene_;
    std::span<const Triangle> world_;
    const TriangleSet& set_;
    double tolerance_;  // of distances
    bool isClosed_;
    std::vector<Ray> rays_;
    std::vector<vec3> points_;
    std::vector<Box> boxes_;
    std::vector<std::vector<Hit>> crossings_;  // of rays: t and number
    std::vector<int32_t> windings_;
    std::vector<uint8_t> isInside_;
    std::vector<double> distances_;
    std::vector<std::vector<uint32_t>> met_;  // by boxes
};

// Throws Error, naming the first cell that differs and how many there are, if any does.
void requireAsBruteForce(std::span<const QueryCell> cells);

}  // namespace cleave
