// A scene in a report: its plots, tables and pictures as HTML.
#pragma once

#include <string>

#include "figures/scene_errors.h"

namespace cleave {

// How a report was made, as far as its scenes' sections tell it.
struct ReportSettings {
    std::string traversal;   // of the rays
    uint64_t raysOfSet = 0;  // in each set, at most
    SahCosts costs = kDefaultCosts;
    bool withPeers = false;
};

// The same text for the same figures.
std::string sceneHtml(const SceneErrors& scene, const ReportSettings& settings);

}  // namespace cleave
