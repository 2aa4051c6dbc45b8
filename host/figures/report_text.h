// Numbers and pieces of a report's sections.
#pragma once

#include <string>
#include <vector>

#include "figures/error_rows.h"

namespace cleave {

std::string milliseconds(double ms);
std::string rangeOf(const Spread& spread);     // "1.2–3.4"; of no runs "-"
std::string medianText(const Spread& spread);  // of no runs "-"
Spread spreadOrNone(const std::vector<double>& runs);

std::string signedText(double value, int digits);  // with a true minus
std::string errorText(double error);

std::string frontMark(const ErrorRow& row);
std::string headline(const std::string& html);

// Those of a kind, side by side, below `what` they show, in HTML.
std::string picturesOf(const SceneErrors& scene, const std::string& kind, const std::string& what);

}  // namespace cleave
