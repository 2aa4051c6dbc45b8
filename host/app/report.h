// The JSON report of a run.
#pragma once

#include "app/session.h"
#include "figures/json.h"

namespace cleave {

// What reports tell of a scene.
struct SceneFacts {
    const Scene& scene;
    const PosedScene& posed;
    const Needs& needs;
    size_t triangles = 0;
    uint64_t nonFinite = 0;
    uint64_t noArea = 0;
    double loadMs = 0.0;
    double poseMs = 0.0;
};
Json sceneJson(const SceneFacts& facts);
Json sceneJson(const Session& session);

// The report with what all of them tell: the device, transfers, memory and the time of the whole run.
Json completed(const Run& run, Json report);
// To a file, whole or not at all.
void writeJson(const std::filesystem::path& file, const Json& report);

// Completes the report and writes the file of --json where one is asked for.
void writeReport(const Run& run, Json report);

}  // namespace cleave
