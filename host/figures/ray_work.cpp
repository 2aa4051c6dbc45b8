#include "figures/ray_work.h"

#include <algorithm>

namespace cleave {

RayWork workOf(std::span<const StepCount> steps, uint32_t lanes) {
    RayWork work;
    double places = 0.0;
    for (size_t first = 0; first < steps.size(); first += lanes) {
        uint32_t most = 0;
        for (const StepCount& s : steps.subspan(first, std::min<size_t>(lanes, steps.size() - first))) {
            work.inner += s.inner;
            work.leaves += s.leaves;
            work.triangles += s.triangles;
            work.resolved += s.resolved;
            work.restarts += s.restarts;
            most = std::max(most, s.inner + s.leaves);
        }
        places += static_cast<double>(most) * lanes;
    }
    work.lanesInUse = places > 0.0 ? (work.inner + work.leaves) / places : 0.0;
    const double rays = std::max<double>(1.0, static_cast<double>(steps.size()));
    for (double* sum : {&work.inner, &work.leaves, &work.triangles, &work.resolved, &work.restarts}) *sum /= rays;
    return work;
}

}  // namespace cleave
