#include "figures/built_tree.h"

#include "base/text.h"
#include "figures/timing.h"

namespace cleave {

std::string builtLine(const BuiltTree& built) {
    return "build     " + fixed(built.ms, 3) + " ms (" + nameOf(built.builder) + "), SAH cost " +
           fixed(built.statistics.sahCost, 2) + ", " + grouped(built.statistics.nodes) + " nodes\n";
}

std::string tracedLine(uint64_t rays, double ms, uint64_t invalidRays) {
    const std::string invalid = invalidRays > 0 ? ", " + grouped(invalidRays) + " invalid" : "";
    return "trace     " + fixed(ms, 3) + " ms, " + grouped(rays) + " rays" + invalid + ", " +
           fixed(mraysPerSecond(rays, ms), 2) + " Mrays/s\n";
}

std::string checkedLine(const CheckResult& check) {
    return "check     " + grouped(check.rays) + " rays, " + grouped(check.mismatches) + " wrong, " +
           grouped(check.undecided) + " undecided\n";
}

}  // namespace cleave
