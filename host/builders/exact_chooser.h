// How exact builders choose the plane of a node by itself, without the events of its parent.
#pragma once

#include "builders/builders.h"
#include "builders/events.h"
#include "builders/face_scan.h"
#include "builders/top_down.h"

namespace cleave {

// Whether the planes of a node are found by counting at every face. Up to so many references that is faster than
// splicing events. Nearly all nodes are so small; the bunny builds in half the time that splicing down to 8 references
// took.
inline bool isCounted(const BuildSettings& settings, size_t references) {
    return settings.smallNodes == SmallNodes::count && references <= kMostScanned;
}

// The best of all planes through a face of a box: by counting, or by a sweep along each axis over events that are
// gathered and sorted for this node (Wald and Havran 2006, algorithm 4; survey section 5).
class ExactChooser {
  public:
    // Adds its events and sort steps to `report`; events that counting does without are swept, too.
    ExactChooser(const BuildSettings& settings, uint32_t maxDepth, BuildReport& report)
        : settings_(settings), maxDepth_(maxDepth), report_(report) {}

    Split operator()(const NodeToSplit& node);

  private:
    Split count(const NodeToSplit& node);
    Split sweep(const NodeToSplit& node);

    const BuildSettings& settings_;
    const uint32_t maxDepth_;
    BuildReport& report_;
    std::vector<Event> events_, scratch_;
};

}  // namespace cleave
