#include <algorithm>

#include "app/commands.h"
#include "app/report.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/timing.h"
#include "formats/npy.h"
#include "formats/write_file.h"
#include "tree/open_edges.h"

namespace cleave {
namespace {

// Points or boxes, as the file has them.
struct Asked {
    std::vector<vec3> points;
    std::vector<Box> boxes;
    size_t size() const { return points.size() + boxes.size(); }
};

struct Answered {
    std::vector<std::byte> file;
    double ms = 0.0;
    uint64_t invalid = 0;
    const char* count = "";  // what `found` counts
    uint64_t found = 0;
};

void requireClosed(const Session& session) {
    const uint64_t open = openEdges(session.posed().triangles);
    if (open > 0)
        throw Error("cannot tell what " + session.scene().name + " contains: it is not closed, " + grouped(open) +
                    (open == 1 ? " edge belongs" : " edges belong") +
                    " to an odd number of triangles; close it, or ask for --nearest");
}

Answered answer(Searcher& searcher, const DeviceTree& tree, const Options& options, const Asked& asked) {
    if (options.question == Question::nearest) {
        const Searcher::Nearest found = searcher.nearest(tree, asked.points, options.within);
        const auto isFound = [](const Hit& hit) { return hit.prim != kNone; };
        const auto count = std::count_if(found.hits.begin(), found.hits.end(), isFound);
        return {npyOfNearest(found.hits), found.ms, found.invalid, "found", static_cast<uint64_t>(count)};
    }
    if (options.question == Question::contains) {
        const Searcher::Contained found = searcher.contains(tree, asked.points);
        const auto count = std::count(found.isInside.begin(), found.isInside.end(), uint8_t{1});
        return {npyOfBools(found.isInside), found.ms, found.invalid, "inside", static_cast<uint64_t>(count)};
    }
    const Searcher::Overlaps found = searcher.overlaps(tree, asked.boxes);
    return {npyOfPairs(found.pairs), found.ms, found.invalid, "pairs", found.pairs.size()};
}

}  // namespace

void runQuery(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    const bool ofBoxes = options.question == Question::overlaps;
    Asked asked;
    if (ofBoxes)
        asked.boxes = readBoxes(options.rays);
    else
        asked.points = readPoints(options.rays);
    Session session(run, options.scenes.front());
    if (options.question == Question::contains) requireClosed(session);
    BuiltTree built = session.build(session.chosenBuilder(false));
    const DeviceTree& tree = session.upload(built);
    run.progress.phase("searching");
    const Answered answered = answer(run.device.searcher(), tree, options, asked);
    writeFile(options.output, answered.file);

    const std::optional<double> rate = mraysPerSecond(asked.size(), answered.ms);
    Json query{{"items", asked.size()},
               {"ms", numberJson(answered.ms)},
               {"mqueriesPerSecond", numberJson(rate)},
               {"invalid", answered.invalid}};
    query[answered.count] = answered.found;
    writeReport(run, {{"scene", sceneJson(session)}, {"build", buildJson(built)}, {"query", query}});
    if (answered.invalid > 0)
        run.warn(grouped(answered.invalid) + (ofBoxes ? " boxes have lo > hi or no number, and meet nothing"
                                                      : " points are not finite, and have no answer"));
    run.print(session.needs().line() + builtLine(built) + "asked     " + grouped(asked.size()) +
              (ofBoxes ? " boxes" : " points") + " in " + fixed(answered.ms, 3) + " ms" +
              (rate ? ", " + fixed(*rate, 3) + " million per second" : "") + "; " + grouped(answered.found) + " " +
              answered.count + "\nanswers   " + options.output.string() + "\n");
}

}  // namespace cleave
