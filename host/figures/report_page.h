// The page of `cleave report`: plots and tables of error against run time as one HTML file that loads nothing.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "figures/report_scene.h"

namespace cleave {

struct ReportPage {
    std::string version, commandLine;
    std::string device, driver;
    uint32_t threads = 0;  // of builders on the CPU
    uint32_t runs = 0;
    bool interior = false;
    bool wentOn = false;  // some figures are from an earlier run that was interrupted
    ReportSettings settings;
    std::vector<SceneErrors> scenes;
    std::vector<std::pair<std::string, std::string>> leftOut;  // what, and why
};

// The same text for the same figures.
std::string reportHtml(const ReportPage& page);

}  // namespace cleave
