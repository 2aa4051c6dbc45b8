// The chooser of the exact builder that sorts in each node.
#pragma once

#include "builders/builders.h"
#include "builders/events.h"
#include "builders/top_down.h"

namespace cleave {

// The best of all planes through a face of a box, by a sweep along each axis (Wald and Havran 2006, algorithm 4; survey
// section 5), over events that are gathered and sorted for this node.
class SweepChooser {
  public:
    // Adds its events and sort steps to `report`.
    SweepChooser(uint32_t maxDepth, BuildReport& report) : maxDepth_(maxDepth), report_(report) {}

    Split operator()(const NodeToSplit& node);

  private:
    const uint32_t maxDepth_;
    BuildReport& report_;
    std::vector<Event> events_, scratch_;
};

}  // namespace cleave
