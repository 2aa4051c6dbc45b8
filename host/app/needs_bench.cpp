// bench --needs: whole runs of `render`, from the file to the pixels, with all left out that the scene has no need of,
// and with one part after the other kept. Everything is made anew for each; only compiled kernels are there already.
#include <algorithm>
#include <ctime>

#include "app/commands.h"
#include "app/picture_of.h"
#include "app/report.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/timing.h"
#include "formats/write_file.h"

namespace cleave {
namespace {

constexpr uint32_t kWidth = 480, kHeight = 270;
constexpr uint32_t kPathSamples = 1;
constexpr std::pair<View, const char*> kViews[] = {{View::shaded, "shaded"}, {View::path, "path"}};

// A way to render the scene, and what it took.
struct Way {
    std::string name;
    Options options;
    std::vector<uint32_t> pixels;
    uint64_t deviceBytes = 0;
    std::vector<double> runs;     // ms
    std::vector<double> cpuRuns;  // of all threads, ms
};

Way wayOf(const Options& asked, const std::filesystem::path& file, View view, std::string name, NeedSet keep) {
    Way way{std::move(name), asked, {}, 0, {}, {}};
    Options& options = way.options;
    options.command = Command::render;
    options.scenes = {file};
    options.view = view;
    options.width = kWidth;
    options.height = kHeight;
    if (view == View::path) options.samples = kPathSamples;
    options.keep = keep;
    options.quiet = true;
    return way;
}

struct Shot {
    Picture picture;
    double ms = 0.0;
    double cpuMs = 0.0;
    uint64_t deviceBytes = 0;
    std::map<Need, Reason> leftOut;
};

// `judged`: so many of its primary rays are.
Shot shoot(const Options& options, uint64_t judged) {
    const std::clock_t began = std::clock();
    Run run(options);
    Session session(run, options.scenes.front(), showsSurfaces(options.view) ? Detail::corners : Detail::triangles);
    const DeviceSurfaces surfaces = session.surfacesOnDevice(options.view);
    BuiltTree built = session.buildPlain(session.chosenBuilder(countsSteps(options.view)));
    const DeviceTree& tree = session.upload(built);
    const PictureRequest request = requestOf(run, session);
    Shot shot;
    shot.picture = run.device.renderer().render(tree, session.trianglesOnDevice(), surfaces, request);
    shot.ms = run.total.milliseconds();
    shot.cpuMs = 1000.0 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    shot.deviceBytes = run.device.device().memoryInUse();
    shot.leftOut = session.needs().leftOut();
    if (judged > 0)
        requireAnswered(shot.picture.cappedRays, checkPicture(run, session, tree, surfaces, request),
                        session.scene().name);
    return shot;
}

void requireSame(const Way& way, const std::vector<uint32_t>& pixels) {
    if (way.pixels != pixels)
        throw Error("the picture of " + way.options.scenes.front().string() + " is another one with " + way.name +
                    " kept; please report this scene");
}

// The first way leaves out what it can, the last nothing; those between keep one part each. All show the same.
std::vector<Way> waysOf(const Options& asked, const std::filesystem::path& file, View view) {
    std::vector<Way> ways{wayOf(asked, file, view, "nothing", {})};
    Options first = ways.front().options;
    first.check = raysToJudge(asked);
    const Shot shot = shoot(first, first.check);
    for (const auto& [need, reason] : shot.leftOut) ways.push_back(wayOf(asked, file, view, wordsOf(need), only(need)));
    ways.push_back(wayOf(asked, file, view, "everything", NeedSet().set()));
    for (Way& way : ways) {
        Shot made = shoot(way.options, 0);
        way.pixels = std::move(made.picture.pixels);
        way.deviceBytes = made.deviceBytes;
        requireSame(way, shot.picture.pixels);
    }
    return ways;
}

double ratio(double of, double to) { return to > 0.0 ? of / to : 1.0; }

std::string tableOf(const char* view, const std::vector<Way>& ways) {
    std::vector<std::vector<std::string>> rows{
        {"view", "kept", "ms", "min..max", "ratio", "CPU ms", "ratio", "device memory", "ratio"}};
    const Way& least = ways.front();
    for (const Way& way : ways) {
        const auto [low, high] = std::minmax_element(way.runs.begin(), way.runs.end());
        rows.push_back({view, way.name, fixed(medianOf(way.runs), 1), fixed(*low, 1) + ".." + fixed(*high, 1),
                        fixed(ratio(medianOf(way.runs), medianOf(least.runs)), 3), fixed(medianOf(way.cpuRuns), 1),
                        fixed(ratio(medianOf(way.cpuRuns), medianOf(least.cpuRuns)), 3), bytesText(way.deviceBytes),
                        fixed(ratio(static_cast<double>(way.deviceBytes), static_cast<double>(least.deviceBytes)), 3)});
    }
    return alignedTable(rows, "llrrrrrrr");
}

Json jsonOf(const char* view, const std::vector<Way>& ways) {
    Json list = Json::array();
    const double least = medianOf(ways.front().runs);
    for (const Way& way : ways)
        list.push_back({{"view", view},
                        {"kept", way.name},
                        {"ms", numberJson(medianOf(way.runs))},
                        {"runsMs", way.runs},
                        {"cpuMs", numberJson(medianOf(way.cpuRuns))},
                        {"ratio", numberJson(ratio(medianOf(way.runs), least))},
                        {"deviceBytes", way.deviceBytes}});
    return list;
}

Json benchScene(Run& run, const std::filesystem::path& file) {
    Json json{{"scene", file.string()}, {"needs", Json::array()}};
    std::string text = oneLine(file.filename().string()) + ", " + std::to_string(kWidth) + " x " +
                       std::to_string(kHeight) + ", median of " + std::to_string(run.options.runs) + " runs\n";
    for (const auto& [view, name] : kViews) {
        run.progress.phase("comparing pictures");
        std::vector<Way> ways = waysOf(run.options, file, view);
        // Side by side, so that all meet the same load of the machine.
        for (uint32_t i = 0; i < run.options.runs; ++i) {
            run.progress.phase("timing pictures, run " + std::to_string(i + 1));
            for (Way& way : ways) {
                const Shot shot = shoot(way.options, 0);
                way.runs.push_back(shot.ms);
                way.cpuRuns.push_back(shot.cpuMs);
            }
        }
        text += tableOf(name, ways);
        for (Json& row : jsonOf(name, ways)) json["needs"].push_back(std::move(row));
    }
    run.print(text + "\n");
    return json;
}

}  // namespace

void runNeedsBench(Run& run) {
    Json scenes = Json::array();
    for (const std::filesystem::path& file : run.options.scenes) scenes.push_back(benchScene(run, file));
    writeReport(run, scenes.size() == 1 ? scenes.front() : Json{{"scenes", scenes}});
}

}  // namespace cleave
