#include "app/report.h"

#include "figures/timing.h"
#include "formats/write_file.h"

namespace cleave {

Json sceneJson(const SceneFacts& facts) {
    // The kinds that scripts look for are there also where their count is 0.
    Json leftOut{{"points", 0}, {"lines", 0}};
    for (const auto& [what, count] : facts.posed.leftOut) leftOut[what] = count;
    leftOut["nonFinite"] = facts.nonFinite;
    leftOut["noArea"] = facts.noArea;
    for (const auto& [need, reason] : facts.needs.leftOut()) {
        Json& told = leftOut[keyOf(need)];
        std::visit([&told](const auto& value) { told = value; }, reason);
    }
    return {{"name", facts.scene.name},
            {"triangles", facts.triangles},
            {"leftOut", leftOut},
            {"loadMs", numberJson(facts.loadMs)},
            {"poseMs", numberJson(facts.poseMs)},
            {"materials", facts.scene.materials.size()},
            {"cameras", facts.posed.cameras.size()},
            {"animations", facts.scene.animations.size()}};
}

Json sceneJson(const Session& session) {
    return sceneJson({session.scene(), session.posed(), session.needs(), session.posed().triangles.size(),
                      session.set().nonFinite, session.set().noArea, session.loadMilliseconds(),
                      session.poseMilliseconds()});
}

Json completed(const Run& run, Json report) {
    const std::optional<std::string> name = run.device.name();
    report["device"] = {{"name", name ? Json(*name) : Json(nullptr)}};
    const TransferCount transfers = run.device.transfers();
    report["transfer"] = {{"upBytes", transfers.upBytes}, {"downBytes", transfers.downBytes}};
    report["process"] = {{"peakBytes", processPeakBytes()}};
    report["total"] = {{"ms", numberJson(run.total.milliseconds())}};
    return report;
}

void writeJson(const std::filesystem::path& file, const Json& report) {
    // Names come from files and may be no UTF-8; what is not is replaced.
    writeFile(file, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void writeReport(const Run& run, Json report) {
    if (run.options.json) writeJson(*run.options.json, completed(run, std::move(report)));
}

}  // namespace cleave
