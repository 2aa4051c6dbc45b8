#include "figures/picture_rows.h"

#include <algorithm>
#include <cmath>

namespace cleave {
namespace {

ErrorRow rowOf(const SceneErrors& scene, const SampledPictures& pictures) {
    ErrorRow row;
    row.scene = scene.name;
    row.builder = scene.paths.builder;
    row.settings = std::to_string(pictures.samples) + " samples";
    double squares = 0.0;
    for (const double error : pictures.errors) squares += error * error;
    row.error = std::sqrt(squares / static_cast<double>(pictures.errors.size()));
    const auto [low, high] = std::minmax_element(pictures.errors.begin(), pictures.errors.end());
    row.errorLow = *low;
    row.errorHigh = *high;
    row.time = spreadOf(pictures.runs);
    return row;
}

template <class Across>
LogPoints errorsOver(const SceneErrors& scene, Across across) {
    LogPoints points;
    for (const SampledPictures& pictures : scene.paths.pictures) {
        const ErrorRow row = rowOf(scene, pictures);
        const LogPoint point{across(pictures, row), row.error};
        if (point.x > 0.0 && point.y > 0.0) points.push_back(point);
    }
    return points;
}

std::optional<double> slopeOf(const std::vector<SceneErrors>& scenes, LogPoints (*pointsOf)(const SceneErrors&)) {
    std::vector<LogPoints> groups;
    for (const SceneErrors& scene : scenes) groups.push_back(pointsOf(scene));
    return logSlope(groups);
}

Json slopesJson(const std::vector<SceneErrors>& scenes) {
    return {{"slope", numberJson(slopeOf(scenes, errorsByTime))},
            {"slopeBySamples", numberJson(slopeOf(scenes, errorsBySamples))}};
}

}  // namespace

std::vector<ErrorRow> pictureRows(const SceneErrors& scene) {
    std::vector<ErrorRow> rows;
    for (const SampledPictures& pictures : scene.paths.pictures) rows.push_back(rowOf(scene, pictures));
    markPareto(rows);
    return rows;
}

LogPoints errorsByTime(const SceneErrors& scene) {
    return errorsOver(scene, [](const SampledPictures&, const ErrorRow& row) { return row.time.median; });
}

LogPoints errorsBySamples(const SceneErrors& scene) {
    return errorsOver(
        scene, [](const SampledPictures& pictures, const ErrorRow&) { return static_cast<double>(pictures.samples); });
}

Json pictureRowsJson(const SceneErrors& scene) {
    Json rows = errorRowsJson(pictureRows(scene));
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i]["samples"] = scene.paths.pictures[i].samples;
        rows[i]["similarity"] = numberJson(medianOf(scene.paths.pictures[i].similarities));
    }
    return rows;
}

Json pictureJson(const std::vector<SceneErrors>& scenes) {
    Json all = slopesJson(scenes);
    all["scenes"] = Json::array();
    for (const SceneErrors& scene : scenes) {
        if (scene.paths.pictures.empty()) continue;
        Json one{{"scene", scene.name},
                 {"width", scene.paths.width},
                 {"height", scene.paths.height},
                 {"referenceSamples", scene.paths.referenceSamples},
                 {"referenceError", numberJson(scene.paths.referenceError)}};
        one.update(slopesJson({scene}));
        all["scenes"].push_back(one);
    }
    return all;
}

}  // namespace cleave
