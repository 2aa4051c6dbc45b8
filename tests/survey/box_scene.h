// Boxes in a cell, and the builders' sweep over them.
#pragma once

#include <vector>

#include "builders/events.h"
#include "support/small_scenes.h"

namespace cleave::test {

struct BoxScene {
    Box cell;
    std::vector<Box> boxes;
};

// The best plane along an axis, as the exact builders find it.
inline Split sweep(const BoxScene& scene, int axis) {
    std::vector<Event> events(2 * scene.boxes.size()), scratch(2 * scene.boxes.size());
    Event* end = events.data();
    for (uint32_t i = 0; i < scene.boxes.size(); ++i) end = writeEvents(end, scene.boxes[i], axis, i);
    const std::span<Event> filled(events.data(), end);
    sortEvents(filled, scratch.data());
    return sweepEvents(noSplit(), kDefaultCosts, filled, scene.cell, static_cast<uint32_t>(axis),
                       static_cast<uint32_t>(scene.boxes.size()));
}

}  // namespace cleave::test
