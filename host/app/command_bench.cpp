#include <algorithm>

#include "app/bench_peers.h"
#include "app/commands.h"
#include "app/report.h"
#include "base/text.h"
#include "figures/bench_figures.h"
#include "figures/timing.h"
#include "formats/write_file.h"
#include "scene/ray_sets.h"

namespace cleave {
namespace {

BuilderFigures benchBuilder(Run& run, Session& session, Builder builder, RaySets& sets) {
    BuilderFigures figures;
    figures.built = session.buildTimed(builder, run.options.runs);
    const DeviceTree& tree = session.upload(figures.built);
    for (const Traversal traversal : run.traversals()) {
        for (const TriangleTest test : run.options.triangleTests) {
            ModeFigures mode{traversal, test, {}};
            const bool first = sets[0].hits.empty();
            for (size_t i = 0; i < sets.size(); ++i) {
                mode.sets[i] =
                    measureSet(run, session, tree, sets[i], {sets[i].query, traversal, test, false}, kRaySets[i],
                               run.options.runs, raysToJudge(run.options), first ? &sets[i].hits : nullptr);
                if (i == 0 && first) makeSecondaryRays(sets, session);
            }
            figures.modes.push_back(mode);
        }
    }
    figures.built.onDevice.reset();
    return figures;
}

Json workJson(const RayWork& work) {
    return {{"inner", work.inner},       {"leaves", work.leaves},     {"triangles", work.triangles},
            {"resolved", work.resolved}, {"restarts", work.restarts}, {"lanesInUse", work.lanesInUse}};
}

Json modeJson(const ModeFigures& mode) {
    Json sets = Json::object();
    CheckResult sum;
    for (size_t i = 0; i < kRaySets.size(); ++i) {
        const SetFigures& set = mode.sets[i];
        Json& json = sets[kRaySets[i]];
        json = traceJson(mode.traversal, mode.test, set.rays, set.ms, set.invalidRays, set.cappedRays);
        json["runsMs"] = set.runs;
        json["hitsHash"] = set.hitsHash;
        json["check"] = checkJson(set.check);
        if (set.work) json["work"] = workJson(*set.work);
        sum.add(set.check);
    }
    return {{"traversal", nameOf(mode.traversal)},
            {"triangleTest", nameOf(mode.test)},
            {"sets", sets},
            {"check", checkJson(sum)}};
}

Json profileJson(const BuildProfile& profile) {
    Json json{{"passes", Json::array()}, {"levels", Json::array()}};
    for (const PassWork& p : profile.passes)
        json["passes"].push_back({{"pass", p.name},
                                  {"ms", numberJson(p.ms)},
                                  {"runs", p.runs},
                                  {"workgroups", p.workgroups},
                                  {"elements", p.elements},
                                  {"of", p.what}});
    for (const LevelWork& l : profile.levels)
        json["levels"].push_back({{"ms", numberJson(l.ms)}, {"references", l.references}, {"nodes", l.nodes}});
    return json;
}

// The first mode's figures at the top; all of them in `modes` where there are several.
Json builderJson(const BuilderFigures& figures) {
    Json report{{"build", buildJson(figures.built)}};
    if (!figures.built.profile.levels.empty()) report["build"]["profile"] = profileJson(figures.built.profile);
    report.update(modeJson(figures.modes.front()));
    if (figures.modes.size() == 1) return report;
    for (const ModeFigures& mode : figures.modes) report["modes"].push_back(modeJson(mode));
    return report;
}

// The first builder's figures at the top, too.
Json benchScene(Run& run, const std::filesystem::path& file) {
    Session session(run, file);
    RaySets sets;
    // Without a triangle there is nowhere to look from, and no rays.
    const Box bounds = session.worldBounds();
    if (!isEmpty(bounds)) sets[0].rays = primaryRays(bounds, run.options.interior);
    std::vector<BuilderFigures> all;
    std::vector<PeerFigures> peers;
    for (const Builder builder : run.options.builders) {
        all.push_back(benchBuilder(run, session, builder, sets));
        if (run.options.peers && all.size() == 1) peers = benchPeers(run, session, all.front().built, sets);
        all.back().built.tree = {};
    }

    run.print(oneLine(file.filename().string()) + ": " + grouped(session.posed().triangles.size()) + " triangles, " +
              oneLine(run.device.name().value_or("")) + ", median of " + std::to_string(run.options.runs) + "\n" +
              treeTable(all, session.set().included.size()) + rayTable(all) +
              (run.options.work ? workTable(all) + passTable(all) : "") + kernelLines(all) +
              (run.options.peers ? peerTable(all, peers) : "") + "\n");
    Json report{{"scene", sceneJson(session)}};
    report.update(builderJson(all.front()));
    for (const PeerFigures& figures : peers) report["peers"].push_back(peerJson(figures));
    for (const BuilderFigures& figures : all) report["builders"].push_back(builderJson(figures));
    return report;
}

}  // namespace

void runBench(Run& run) {
    if (run.options.survey) return runSurvey(run);
    if (run.options.json) requireWritable(*run.options.json);
    if (run.options.queries) return runQueryBench(run);
    if (run.options.needs) return runNeedsBench(run);
    Json scenes = Json::array();
    for (const std::filesystem::path& file : run.options.scenes) scenes.push_back(benchScene(run, file));
    writeReport(run, scenes.size() == 1 ? scenes.front() : Json{{"scenes", scenes}});
}

}  // namespace cleave
