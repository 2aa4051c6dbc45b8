#include "app/tree_portrait.h"

#include <algorithm>

#include "figures/tree_pictures.h"
#include "formats/base64.h"
#include "formats/png.h"
#include "measure/line_counts.h"
#include "scene/ray_sets.h"

namespace cleave {
namespace {

constexpr uint32_t kLines = 65536, kQuickLines = 16384;
constexpr uint32_t kLineSeed = 1;
constexpr uint32_t kPictureSize = 240;
constexpr float kMostInLeaf = 8.0f;      // the upper end of the scale
constexpr double kShareOnScale = 0.995;  // of the pixels that the scale of steps has apart

RayCounts perLine(const LineCounts& counts) {
    return {counts.perLine(counts.inner), counts.perLine(counts.leaves), counts.perLine(counts.triangles)};
}

// Few pixels have so many steps that a scale up to these would be dark below.
float upperEnd(std::span<const StepCount> steps) {
    std::vector<uint32_t> counts;
    for (const StepCount& s : steps) counts.push_back(s.inner + s.leaves);
    const auto at = counts.begin() + static_cast<ptrdiff_t>(kShareOnScale * static_cast<double>(counts.size() - 1));
    std::nth_element(counts.begin(), at, counts.end());
    return static_cast<float>(std::max(*at, 1u));
}

ReportPicture encoded(const std::string& kind, const BuiltTree& built, const Picture& picture) {
    return {kind, nameOf(built.builder), base64Of(pngOf(picture.width, picture.height, picture.pixels))};
}

}  // namespace

LineErrors TreePortrait::lines(const BuiltTree& built, const BuiltTree& any) {
    if (lines_.empty()) {
        lines_ = uniformLines(session_.worldBounds(), run_.options.quick ? kQuickLines : kLines, kLineSeed);
        lineHits_ = run_.device.tracer().trace(*any.onDevice, lines_).hits;
    }
    run_.progress.phase("counting along lines");
    LineCounts unstopped, hitting, missing, beyond, descent;
    for (size_t i = 0; i < lines_.size(); ++i) {
        const Ray& line = lines_[i];
        const double end = line.tMax, hit = lineHits_[i].t;
        countAlong(built.tree, line, 0.0, end, unstopped);
        if (lineHits_[i].prim == kNone) {
            countAlong(built.tree, line, 0.0, end, missing);
            continue;
        }
        countAlong(built.tree, line, 0.0, hit, hitting);
        countAlong(built.tree, line, hit, end, beyond);
        countAlong(built.tree, line, hit, hit, descent);
    }
    return {perLine(unstopped), perLine(hitting), perLine(missing), perLine(beyond),
            perLine(descent),   unstopped.lines,  hitting.lines};
}

// The pixels' rays through a tree, with their steps counted.
Tracer::Result TreePortrait::seen(const BuiltTree& built) {
    return run_.device.tracer().trace(*built.onDevice, pixels_,
                                      {Query::closest, run_.traversal(), TriangleTest::watertight, true});
}

std::vector<ReportPicture> TreePortrait::pictures(const BuiltTree& built, const BuiltTree& standard) {
    run_.progress.phase("drawing");
    if (pixels_.empty()) {
        pixels_ = primaryRays(session_.worldBounds(), run_.options.interior, kPictureSize);
        mostSteps_ = upperEnd(seen(standard).steps);
    }
    const Tracer::Result traced = seen(built);
    const Picture cut = cutPicture(built.tree, cutOf(standard.tree), 2 * kPictureSize, kMostInLeaf);
    return {encoded("steps", built, stepsPicture(traced.steps, kPictureSize, mostSteps_)),
            encoded("leaves", built, leavesPicture(traced.steps, traced.hits, kPictureSize, kMostInLeaf)),
            encoded("cut", built, cut)};
}

}  // namespace cleave
