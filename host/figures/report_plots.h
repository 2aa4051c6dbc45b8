// The plots of a report: the page shows them, and they stand beside it as files.
#pragma once

#include <string>
#include <vector>

#include "figures/error_rows.h"

namespace cleave {

struct NamedPlot {
    std::string name;  // tree, rays, hits, leaves, depths, paths
    std::string svg;
};

std::string treePlot(const SceneErrors& scene);
std::string rayPlot(const SceneErrors& scene);
std::string hitPlot(const SceneErrors& scene);
// Empty without pictures of paths that are off.
std::string pathPlot(const SceneErrors& scene);
// Shares of leaves by their number of triangles, and by their depth; a curve per builder at its defaults.
std::string leafPlot(const SceneErrors& scene);
std::string depthPlot(const SceneErrors& scene);

// All of them, of a scene that was measured.
std::vector<NamedPlot> plotsOf(const SceneErrors& scene);

}  // namespace cleave
