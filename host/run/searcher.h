// Asks about points and boxes of the host in a tree on the device.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "run/device_tree.h"
#include "shared/box.h"
#include "shared/ray.h"

namespace cleave {

// How much a search does at once. Tests make these tiny; the answers are the same.
struct SearchLimits {
    size_t batch = size_t(1) << 18;        // points or boxes of one submission
    uint64_t numbers = uint64_t(1) << 26;  // triangle numbers of one, unless a single box has more
};

class Searcher {
  public:
    explicit Searcher(Device& device, SearchLimits limits = {});
    ~Searcher();

    struct Nearest {
        std::vector<Hit> hits;  // one per point; t is the distance
        double ms = 0.0;        // on the device, points and answers being there
        uint64_t invalid = 0;   // points that are not finite, answered as misses
    };
    // The nearest point of a triangle that is at most `within` away. Ties go to the lower number.
    Nearest nearest(const DeviceTree& tree, std::span<const vec3> points, float within);

    struct Contained {
        std::vector<uint8_t> isInside;  // one per point, 0 or 1
        double ms = 0.0;
        uint64_t invalid = 0;  // points that are not finite, answered by 0
    };
    // Whether each point is inside of the tree's triangles or on them. They must be a closed surface; see openEdges().
    Contained contains(const DeviceTree& tree, std::span<const vec3> points);

    struct Overlaps {
        std::vector<uvec2> pairs;  // (box, triangle), ascending
        double ms = 0.0;
        uint64_t invalid = 0;  // boxes without a point, which meet nothing: lo > hi, or no number
    };
    // The triangles that meet each box, with its boundary.
    Overlaps overlaps(const DeviceTree& tree, std::span<const Box> boxes);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cleave
