#include "figures/peer_figures.h"

#include <algorithm>

#include "base/text.h"
#include "figures/timing.h"

namespace cleave {
namespace {

using Row = std::vector<std::string>;
using Rates = std::array<std::optional<double>, kRaySets.size()>;

std::optional<double> medianRate(uint64_t rays, const std::vector<double>& runs) {
    return runs.empty() ? std::nullopt : mraysPerSecond(rays, medianOf(runs));
}

// The longest time is the lowest rate.
std::string rateRange(uint64_t rays, const std::vector<double>& runs) {
    if (runs.empty()) return "-";
    const auto [least, most] = std::minmax_element(runs.begin(), runs.end());
    return fixed(mraysPerSecond(rays, *most), 2) + ".." + fixed(mraysPerSecond(rays, *least), 2);
}

void addBuild(Row& row, const std::vector<double>& runs) {
    const auto [least, most] = std::minmax_element(runs.begin(), runs.end());
    row.push_back(runs.empty() ? "-" : fixed(medianOf(runs), 1));
    row.push_back(runs.empty() ? "-" : fixed(*least, 1) + ".." + fixed(*most, 1));
}

// Only modes whose answers were found right compete.
Rates bestOf(const std::vector<BuilderFigures>& ours) {
    Rates best;
    for (const BuilderFigures& builder : ours)
        for (const ModeFigures& mode : builder.modes)
            for (size_t i = 0; i < best.size(); ++i) {
                const SetFigures& set = mode.sets[i];
                const std::optional<double> rate = medianRate(set.rays, set.runs);
                if (rate && set.check.mismatches == 0) best[i] = std::max(best[i].value_or(0.0), *rate);
            }
    return best;
}

Row ourRow(const BuiltTree& built, const ModeFigures& mode) {
    const bool isDefault = mode.test == TriangleTest::watertight;
    Row row{"cleave " + nameOf(built.builder), nameOf(mode.traversal) + (isDefault ? "" : ", " + nameOf(mode.test))};
    addBuild(row, built.runs);
    for (const SetFigures& set : mode.sets)
        row.insert(row.end(), {fixed(medianRate(set.rays, set.runs), 2), rateRange(set.rays, set.runs), ""});
    row.insert(row.end(), {"", ""});
    return row;
}

Row peerRow(const PeerFigures& peer, const Rates& best) {
    Row row{peer.name, peer.order};
    addBuild(row, peer.buildRuns);
    uint64_t rays = 0, disagreements = 0;
    for (size_t i = 0; i < peer.sets.size(); ++i) {
        const PeerSetFigures& set = peer.sets[i];
        const std::optional<double> rate = medianRate(set.rays, set.runs);
        row.push_back(set.isWrong() ? "wrong" : fixed(rate, 2));
        row.push_back(rateRange(set.rays, set.runs));
        row.push_back(fixed(ratio(best[i], rate), 2));
        rays += set.rays;
        disagreements += set.disagreements;
    }
    const bool has = peer.missing.empty();
    row.insert(row.end(), {has ? grouped(rays) : "missing", has ? grouped(disagreements) : "-"});
    return row;
}

}  // namespace

std::string peerTable(const std::vector<BuilderFigures>& ours, const std::vector<PeerFigures>& peers) {
    Row head{"Mrays/s", "way, order", "build ms", "min..max"};
    for (const char* name : kRaySets) head.insert(head.end(), {name, "min..max", "ours/"});
    head.insert(head.end(), {"compared", "differ"});
    std::vector<Row> rows{head};
    for (const BuilderFigures& builder : ours)
        for (const ModeFigures& mode : builder.modes) rows.push_back(ourRow(builder.built, mode));
    const Rates best = bestOf(ours);
    std::string notes;
    for (const PeerFigures& peer : peers) {
        rows.push_back(peerRow(peer, best));
        if (!peer.missing.empty()) notes += peer.name + ", " + peer.order + ": " + oneLine(peer.missing) + "\n";
    }
    return alignedTable(rows, "ll" + std::string(head.size() - 2, 'r')) + notes;
}

Json peerJson(const PeerFigures& peer) {
    Json json{{"name", peer.name},
              {"order", peer.order},
              {"buildMs", peer.buildRuns.empty() ? Json(nullptr) : Json(medianOf(peer.buildRuns))},
              {"buildRunsMs", peer.buildRuns}};
    if (!peer.missing.empty()) json["missing"] = peer.missing;
    Json sets = Json::object();
    for (size_t i = 0; peer.missing.empty() && i < peer.sets.size(); ++i) {
        const PeerSetFigures& set = peer.sets[i];
        sets[kRaySets[i]] = {{"rays", set.rays},
                             {"ms", set.runs.empty() ? Json(nullptr) : Json(medianOf(set.runs))},
                             {"mraysPerSecond", numberJson(medianRate(set.rays, set.runs))},
                             {"runsMs", set.runs},
                             {"disagreements", set.disagreements},
                             {"wrong", set.isWrong()}};
    }
    json["sets"] = sets;
    return json;
}

}  // namespace cleave
