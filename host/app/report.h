// The JSON report of a run.
#pragma once

#include "app/session.h"
#include "figures/json.h"

namespace cleave {

Json sceneJson(const Session& session);

// Adds device and total, and writes the file of --json where one is asked for.
void writeReport(const Run& run, Json report);

}  // namespace cleave
