#include "figures/report_paths.h"

#include "base/text.h"
#include "figures/html.h"
#include "figures/picture_rows.h"
#include "figures/report_plots.h"
#include "figures/report_text.h"

namespace cleave {
namespace {

std::string slopeText(const LogPoints& points) {
    const std::optional<double> slope = logSlope({&points, 1});
    return slope ? signedText(*slope, 3) : "-";
}

std::string slopes(const SceneErrors& scene) {
    return paragraph("Fitted slope of the error in logarithmic axes: " + slopeText(errorsByTime(scene)) +
                     " over time, " + slopeText(errorsBySamples(scene)) +
                     " over samples. Independent samples give \u22120.5; a better choice of samples is steeper.");
}

}  // namespace

std::string pathSection(const SceneErrors& scene) {
    const PathErrors& paths = scene.paths;
    if (paths.pictures.empty()) return "";
    std::string html =
        headline("Pictures of light: error, against rendering time") +
        paragraph("Error: the root mean squared difference of linear radiance from a converged picture of " +
                  grouped(paths.referenceSamples) +
                  " samples with other seeds, over all pixels and colours, in per "
                  "cent of the mean radiance there. " +
                  std::to_string(paths.width) + " \u00D7 " + std::to_string(paths.height) +
                  " pixels, through the tree of <code>" + paths.builder +
                  "</code>. Where samples are few, there are the more pictures, each with a seed of its own: the error "
                  "is the root of their mean square. Similarity is the mean structural similarity (Wang et al. 2004) "
                  "of the luma of the pixels shown; 1 is the same. The reference is itself off by " +
                  errorText(paths.referenceError) + " % (the standard error of the mean of its " +
                  std::to_string(paths.referenceParts) +
                  " parts, each with a seed of its own), which is in every error.") +
        pathPlot(scene) + slopes(scene);
    const std::vector<ErrorRow> errors = pictureRows(scene);
    std::vector<HtmlRow> rows{
        {"samples", "error, %", "low\u2013high", "pictures", "similarity", "ms", "low\u2013high"}};
    for (size_t i = 0; i < errors.size(); ++i) {
        const ErrorRow& row = errors[i];
        const SampledPictures& pictures = paths.pictures[i];
        rows.push_back({std::to_string(pictures.samples), errorText(row.error),
                        errorText(row.errorLow) + "\u2013" + errorText(row.errorHigh),
                        std::to_string(pictures.errors.size()), fixed(medianOf(pictures.similarities), 4),
                        medianText(row.time), rangeOf(row.time)});
    }
    return html + htmlTable("Pictures of paths in " + scene.name, rows, "rrrrrrr") +
           picturesOf(scene, "paths", "With the fewest samples, and the reference.");
}

}  // namespace cleave
