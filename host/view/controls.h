// What a user of the window can change, and what it is told in the panel.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/cells.h"
#include "view/painter.h"
#include "view/stage.h"

namespace cleave {

struct Controls {
    StageWish stage;
    View view = View::shaded;
    std::optional<uint32_t> samples;  // of a pixel; the view's own number otherwise
    uint32_t bounces = 8;
    float exposure = 0.0f;  // powers of two
    Traversal traversal = kDefaultTraversal;
    TriangleTest test = TriangleTest::watertight;
    bool compares = false;

    uint32_t overlayLevel = 0;  // cells down to that level are drawn; 0: none
    bool rayCells = false;      // those along the ray under the cursor
    int clipAxis = -1;          // of the plane that the overlay ends at; -1: none
    float clipAt = 0.5f;        // from one end of the scene's box, 0, to the other, 1
    bool clipsAbove = true;     // which side goes

    bool plays = false;
    bool loops = true;

    bool panel = true;
    bool keys = false;  // the list of keys
};

// What the panel tells.
struct Facts {
    std::shared_ptr<const Staged> staged;    // null: nothing yet
    std::shared_ptr<const Painted> painted;  // likewise
    std::string phase;                       // of the stage
    std::string error;                       // empty: none
    std::string note;                        // a sentence that goes by itself
    std::vector<PassedLeaf> leaves;          // under the cursor
    std::deque<float> frameMs;               // between pictures, the latest last
    double framesPerSecond = 0.0;
    uint64_t deviceBytes = 0;
    std::string device;
};

}  // namespace cleave
