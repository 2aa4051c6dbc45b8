#include "builders/exact_chooser.h"

namespace cleave {

KdTree buildExactNLog2N(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    BuildReport work;
    const ExactChooser chooser(settings, depthLimit(settings, set.included.size()), work);
    KdTree tree = buildTopDown(set, settings, chooser, report);
    if (report != nullptr) *report = {report->peakBytes, work.eventsSwept, work.sortSteps};
    return tree;
}

}  // namespace cleave
