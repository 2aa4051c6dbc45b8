#include "app/commands.h"
#include "app/report.h"
#include "app/saved_tree.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/timing.h"
#include "formats/write_file.h"
#include "judge/validate.h"
#include "measure/leaf_reasons.h"

namespace cleave {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string pointText(glm::vec3 p) {
    const auto number = [](float x) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", static_cast<double>(x));
        return std::string(text);
    };
    return number(p.x) + ", " + number(p.y) + ", " + number(p.z);
}

std::string sceneTable(const Session& session) {
    const PosedScene& scene = session.posed();
    Rows rows{{"scene", oneLine(scene.name)}, {"triangles", grouped(scene.triangles.size())}};
    for (const auto& [what, count] : scene.leftOut) rows.push_back({"left out: " + what, grouped(count)});
    if (session.set().nonFinite > 0) rows.push_back({"left out: not finite", grouped(session.set().nonFinite)});
    if (session.set().noArea > 0) rows.push_back({"left out: no area", grouped(session.set().noArea)});
    const Box bounds = session.worldBounds();
    if (!isEmpty(bounds)) {
        rows.push_back({"bounds from", pointText(bounds.lo)});
        rows.push_back({"bounds to", pointText(bounds.hi)});
    }
    uint64_t bytes = 0;
    for (const gltf::Buffer& buffer : session.scene().buffers) bytes += buffer.bytes.size();
    rows.push_back({"loading", fixed(session.loadMilliseconds(), 1) + " ms, posing " +
                                   fixed(session.poseMilliseconds(), 1) + " ms; buffers " + bytesText(bytes) +
                                   ", the process so far " + bytesText(processPeakBytes())});
    rows.push_back({"materials", grouped(session.scene().materials.size())});
    rows.push_back({"cameras", grouped(scene.cameras.size())});
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        rows.push_back({"camera " + std::to_string(i),
                        oneLine(scene.cameras[i].name) + " (" +
                            (scene.cameras[i].orthographic ? "orthographic" : "perspective") + ")"});
    const std::vector<gltf::Animation>& animations = session.scene().animations;
    rows.push_back({"animations", grouped(animations.size())});
    for (size_t i = 0; i < animations.size(); ++i)
        rows.push_back({"animation " + std::to_string(i), oneLine(animations[i].name)});
    return alignedTable(rows, "ll");
}

std::string treeTable(const BuiltTree& built, const Session& session) {
    const TreeStatistics& s = built.statistics;
    const size_t included = session.set().included.size();
    const double each = included > 0 ? static_cast<double>(s.references) / static_cast<double>(included) : 0.0;
    Rows rows{{"builder", nameOf(built.builder)},
              {"build", fixed(built.ms, 3) + " ms"},
              {"SAH cost", fixed(s.sahCost, 3)},
              {"expected per ray", fixed(s.expectedInner, 2) + " inner nodes, " + fixed(s.expectedLeaves, 2) +
                                       " leaves, " + fixed(s.expectedTriangles, 2) + " triangles"},
              {"nodes", grouped(s.nodes)},
              {"leaves", grouped(s.leaves) + " (" + grouped(s.emptyLeaves) + " empty)"},
              {"references", grouped(s.references) + " (" + fixed(each, 2) + " per triangle)"},
              {"deepest leaf", std::to_string(s.maxDepth)},
              {"largest leaf", grouped(s.largestLeaf)},
              {"peak memory", bytesText(built.peakBytes) + ", the whole process " + bytesText(processPeakBytes())},
              {"tree hash", built.hash}};
    if (built.memoryLimited) rows.push_back({"memory", "limit met: the last levels are leaves"});
    return alignedTable(rows, "ll");
}

// Numbers of leaves by their numbers of triangles.
std::string histogramTable(const TreeStatistics& s) {
    Rows rows{{"triangles", "leaves"}};
    for (size_t n = 0; n < s.leafHistogram.size(); ++n) {
        if (s.leafHistogram[n] == 0) continue;
        const bool last = n + 1 == s.leafHistogram.size();
        rows.push_back({std::to_string(n) + (last ? "+" : ""), grouped(s.leafHistogram[n])});
    }
    return alignedTable(rows, "rr");
}

// A reason why nodes are leaves: its key in reports and its words for a person.
struct LeafReason {
    const char* name;
    const char* words;
    uint64_t LeafReasons::*count;
};
constexpr LeafReason kLeafReasons[] = {
    {"empty", "no triangle", &LeafReasons::empty},
    {"depthLimit", "the depth limit", &LeafReasons::depthLimit},
    {"collapsedAxes", "two axes of the cell collapsed", &LeafReasons::collapsedAxes},
    {"identicalBoxes", "all boxes identical", &LeafReasons::identicalBoxes},
    {"noPlane", "no face of a box inside of the cell", &LeafReasons::noPlane},
    {"cost", "no split costs less", &LeafReasons::cost},
    {"wouldPay", "none, a split would cost less", &LeafReasons::wouldPay},
};

std::string reasonTable(const LeafReasons& reasons) {
    Rows rows{{"why a leaf", "leaves"}};
    for (const LeafReason& reason : kLeafReasons)
        if (reasons.*reason.count > 0) rows.push_back({reason.words, grouped(reasons.*reason.count)});
    return alignedTable(rows, "lr");
}

Json reasonJson(const LeafReasons& reasons) {
    Json json = Json::object();
    for (const LeafReason& reason : kLeafReasons) json[reason.name] = reasons.*reason.count;
    return json;
}

Json validationJson(const ValidationReport& report) {
    return {{"ok", report.ok()},
            {"errors", report.errorCount},
            {"surplusReferences", report.surplusReferences},
            {"first", report.errors}};
}

}  // namespace

void runInfo(Run& run) {
    const Options& options = run.options;
    if (options.json) requireWritable(*options.json);
    if (options.saveTree) requireWritable(*options.saveTree);
    Session session(run, options.scenes.front());
    run.print(sceneTable(session));
    const BuiltTree built = session.build(session.chosenBuilder(true));
    if (options.saveTree) saveTree(*options.saveTree, built.tree, session.posed().triangles);
    run.progress.phase("asking leaves");
    const LeafReasons reasons = countLeafReasons(built.tree, session.set(), options.settings);
    run.progress.clear();
    run.print("\n" + session.needs().line() + treeTable(built, session) + "\n" + histogramTable(built.statistics) +
              "\n" + reasonTable(reasons));

    Json report{{"scene", sceneJson(session)}, {"build", buildJson(built)}};
    report["build"]["leafReasons"] = reasonJson(reasons);
    if (!options.validate) return writeReport(run, report);
    run.progress.phase("validating");
    // The brute-force "tree" is one leaf, which any depth allows.
    const ValidationReport validation =
        validate(built.tree, session.set(), depthLimit(options.settings, session.set().included.size()));
    report["validation"] = validationJson(validation);
    writeReport(run, report);
    if (!validation.ok())
        throw Error("the tree of " + session.scene().name + " is broken in " + grouped(validation.errorCount) +
                    " places, first: " + (validation.errors.empty() ? "not told" : validation.errors.front()) +
                    "; please report this scene");
    run.print("\nvalid: every point of every triangle is in a leaf that lists it (" +
              grouped(validation.surplusReferences) + " surplus references)\n");
}

}  // namespace cleave
