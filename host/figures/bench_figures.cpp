#include "figures/bench_figures.h"

#include <algorithm>
#include <bit>

#include "base/hash.h"
#include "base/text.h"
#include "figures/timing.h"

namespace cleave {
namespace {

using Row = std::vector<std::string>;

const TreeStatistics* exactAmong(const std::vector<BuilderFigures>& figures) {
    for (const BuilderFigures& f : figures)
        if (f.built.builder == Builder::exact) return &f.built.statistics;
    return nullptr;
}

std::string rangeOf(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fixed(*least, 3) + ".." + fixed(*most, 3);
}

Row treeRow(const BuiltTree& built, const TreeStatistics* exact, uint64_t included) {
    const TreeStatistics& s = built.statistics;
    const auto references = static_cast<double>(s.references);
    Row row{nameOf(built.builder), fixed(built.ms, 3), rangeOf(built.runs), fixed(s.sahCost, 3)};
    if (exact != nullptr) row.push_back(fixed(ratio(s.sahCost, exact->sahCost), 3));
    row.push_back(grouped(s.nodes));
    row.push_back(grouped(s.references));
    row.push_back(fixed(ratio(references, static_cast<double>(included)), 2));
    if (exact != nullptr) row.push_back(fixed(ratio(references, static_cast<double>(exact->references)), 3));
    row.insert(row.end(), {std::to_string(s.maxDepth), fixed(s.expectedInner, 2), fixed(s.expectedLeaves, 2),
                           fixed(s.expectedTriangles, 2), bytesText(built.peakBytes)});
    return row;
}

double totalMs(const BuildProfile& profile) {
    double sum = 0.0;
    for (const PassWork& pass : profile.passes) sum += pass.ms;
    return sum;
}

// Of the triangle tests of all sets.
std::string resolvedText(const ModeFigures& mode) {
    double resolved = 0.0, tests = 0.0;
    for (const SetFigures& set : mode.sets) {
        if (!set.work) continue;
        resolved += set.work->resolved * static_cast<double>(set.rays);
        tests += set.work->triangles * static_cast<double>(set.rays);
    }
    return tests > 0.0 ? fixed(100.0 * resolved / tests, 2) + " %" : "-";
}

Row rayRow(Builder builder, const ModeFigures& mode, bool modesDiffer) {
    Row row{nameOf(builder)};
    if (modesDiffer) row.insert(row.end(), {nameOf(mode.traversal), nameOf(mode.test)});
    CheckResult sum;
    for (const SetFigures& set : mode.sets) {
        row.push_back(set.rays > 0 ? fixed(set.ms, 3) : "-");
        row.push_back(fixed(mraysPerSecond(set.rays, set.ms), 3));
        sum.add(set.check);
    }
    if (modesDiffer) row.push_back(resolvedText(mode));
    row.insert(row.end(), {grouped(sum.rays), grouped(sum.mismatches), grouped(sum.undecided)});
    return row;
}

}  // namespace

std::string treeTable(const std::vector<BuilderFigures>& figures, uint64_t included) {
    const TreeStatistics* exact = exactAmong(figures);
    Row head{"builder", "build ms", "min..max", "SAH cost"};
    if (exact != nullptr) head.emplace_back("/exact");
    head.insert(head.end(), {"nodes", "references", "/triangle"});
    if (exact != nullptr) head.emplace_back("/exact");
    head.insert(head.end(), {"depth", "inner", "leaves", "triangles", "peak"});
    std::vector<Row> rows{head};
    for (const BuilderFigures& f : figures) rows.push_back(treeRow(f.built, exact, included));
    return alignedTable(rows, "l" + std::string(head.size() - 1, 'r'));
}

std::string rayTable(const std::vector<BuilderFigures>& figures) {
    bool modesDiffer = false;
    for (const BuilderFigures& f : figures) modesDiffer = modesDiffer || f.modes.size() > 1;
    Row head{"builder"};
    if (modesDiffer) head.insert(head.end(), {"traversal", "test"});
    for (const char* name : kRaySets) head.insert(head.end(), {std::string(name) + " ms", "Mrays/s"});
    if (modesDiffer) head.emplace_back("in double");
    head.insert(head.end(), {"checked", "wrong", "undecided"});
    std::vector<Row> rows{head};
    for (const BuilderFigures& f : figures)
        for (const ModeFigures& mode : f.modes) rows.push_back(rayRow(f.built.builder, mode, modesDiffer));
    return alignedTable(rows, (modesDiffer ? "lll" : "l") + std::string(head.size() - (modesDiffer ? 3 : 1), 'r'));
}

std::string workTable(const std::vector<BuilderFigures>& figures) {
    std::vector<Row> rows{{"builder", "traversal", "test", "rays", "inner", "leaves", "triangles", "in double",
                           "restarts", "lanes in use"}};
    for (const BuilderFigures& f : figures)
        for (const ModeFigures& mode : f.modes)
            for (size_t i = 0; i < kRaySets.size(); ++i) {
                if (!mode.sets[i].work) continue;
                const RayWork& work = *mode.sets[i].work;
                rows.push_back({nameOf(f.built.builder), nameOf(mode.traversal), nameOf(mode.test), kRaySets[i],
                                fixed(work.inner, 2), fixed(work.leaves, 2), fixed(work.triangles, 2),
                                fixed(work.resolved, 2), fixed(work.restarts, 2),
                                fixed(100.0 * work.lanesInUse, 1) + " %"});
            }
    return alignedTable(rows, "llllrrrrrr");
}

std::string passTable(const std::vector<BuilderFigures>& figures) {
    std::vector<Row> passes{{"builder", "pass", "ms", "of all", "runs", "workgroups", "ns each", "elements", "",
                             "ns each", "ns/reference", "ns/node"}};
    std::vector<Row> levels{{"builder", "level", "ms", "references", "nodes", "ns/reference", "ns/node"}};
    const auto each = [](double ms, uint64_t n) { return n == 0 ? std::string("-") : fixed(ms * 1e6 / double(n), 1); };
    for (const BuilderFigures& f : figures) {
        const BuildProfile& profile = f.built.profile;
        const double sum = totalMs(profile);
        if (!(sum > 0.0)) continue;
        uint64_t references = 0;
        for (const LevelWork& level : profile.levels) references += level.references;
        for (const PassWork& p : profile.passes)
            passes.push_back({nameOf(f.built.builder), p.name, fixed(p.ms, 3), fixed(100.0 * p.ms / sum, 1) + " %",
                              grouped(p.runs), grouped(p.workgroups), each(p.ms, p.workgroups), grouped(p.elements),
                              p.what, each(p.ms, p.elements), each(p.ms, references), each(p.ms, profile.nodes)});
        for (size_t depth = 0; depth < profile.levels.size(); depth++) {
            const LevelWork& l = profile.levels[depth];
            levels.push_back({nameOf(f.built.builder), grouped(depth), fixed(l.ms, 3), grouped(l.references),
                              grouped(l.nodes), each(l.ms, l.references), each(l.ms, l.nodes)});
        }
    }
    if (passes.size() == 1) return "";
    return alignedTable(passes, "llrrrrrrlrrr") + alignedTable(levels, "lrrrrrr");
}

std::string hitsHash(std::span<const Hit> hits, Query query) {
    Hash hash;
    for (const Hit& hit : hits) {
        if (query == Query::any) {
            hash.add(hit.prim != kNone);
            continue;
        }
        hash.add(std::bit_cast<uint32_t>(hit.t));
        hash.add(hit.prim);
        hash.add(std::bit_cast<uint32_t>(hit.u));
        hash.add(std::bit_cast<uint32_t>(hit.v));
    }
    return hash.text();
}

std::string kernelLines(const std::vector<BuilderFigures>& figures) {
    std::string lines;
    for (const BuilderFigures& f : figures) {
        std::vector<PassWork> kernels = f.built.profile.passes;
        std::sort(kernels.begin(), kernels.end(), [](const auto& a, const auto& b) { return a.ms > b.ms; });
        const double sum = totalMs(f.built.profile);
        if (!(sum > 0.0)) continue;
        lines += nameOf(f.built.builder) + " build by kernel, %:";
        for (const PassWork& kernel : kernels) lines += " " + kernel.name + " " + fixed(100.0 * kernel.ms / sum, 1);
        lines += "\n";
    }
    return lines;
}

}  // namespace cleave
