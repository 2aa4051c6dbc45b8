#include "app/build_options.h"

#include <string_view>

#include "app/option_kinds.h"
#include "app/run_options.h"
#include "facade/host_builders.h"

namespace cleave {
namespace {

constexpr std::array<std::pair<const char*, StopRule>, 2> kStopRules = {
    {{"sah", StopRule::cost}, {"sa-n", StopRule::equation41}}};
constexpr std::array<std::pair<const char*, SmallNodes>, 2> kSmallNodes = {
    {{"count", SmallNodes::count}, {"sort", SmallNodes::sort}}};
constexpr std::array<std::pair<const char*, bool>, 2> kSwitch = {{{"on", true}, {"off", false}}};

Builder builderNamed(const std::string& name) {
    for (const auto& [known, description] : allBuilders())
        if (name == known) return {known};
    throw CLI::ValidationError("--builder", "'" + name + "' is not known; there is: " + namesIn(allBuilders()));
}

void addHeuristic(CLI::App& app, BuildSettings& settings) {
    SahCosts& costs = settings.costs;
    addNumber(app, "--cost-traverse", "SAH cost of an inner node", costs.traverse, {0.001, "0.001"}, {1000, "1000"});
    addNumber(app, "--cost-intersect", "SAH cost of a triangle test", costs.intersect, {0.001, "0.001"},
              {1000, "1000"});
    addNumber(app, "--cost-leaf", "SAH cost of a leaf", costs.leaf, {0, "0"}, {1000, "1000"});
    addNumber(app, "--empty-bonus", "factor on the SAH cost of a split that leaves a side empty; 1: none",
              costs.emptyBonus, {0.001, "0.001"}, {1, "1"});
    addNamed(app, "--stop", "SAH builders split where that costs less, or where areas times triangles shrink",
             settings.stop, kStopRules);
}

void addBuilders(CLI::App& app, Options& options, bool several) {
    const auto read = [&options, several](const std::string& given) {
        options.builders.clear();
        options.namesBuilder = true;
        std::vector<std::string> names = several ? CLI::detail::split(given, ',') : std::vector<std::string>{given};
        for (const std::string& name : names) {
            const Builder builder = builderNamed(name);
            for (const Builder other : options.builders)
                if (other == builder) throw CLI::ValidationError("--builder", "'" + name + "' is given twice");
            options.builders.push_back(builder);
        }
    };
    app.add_option_function<std::string>("--builder", read,
                                         std::string("who builds the tree") +
                                             (several ? ", or several: gpu,exact" : "") + " (" +
                                             namesIn(allBuilders()) + ")")
        ->type_name(several ? "NAME,..." : "NAME");
    std::string footer = "Builders:";
    for (const auto& [name, description] : allBuilders())
        footer += "\n  " + std::string(name) + ": " + std::string(description);
    app.footer(footer);
}

}  // namespace

void addBuild(CLI::App& app, Options& options, bool several) {
    BuildSettings& settings = options.settings;
    addBuilders(app, options, several);
    addMachine(app, options);
    addParsed<uint64_t>(
        app, "--memory", "SIZE", "bytes that a build may use, for example 512M or 2G", parseBytes,
        [&settings](uint64_t bytes) { settings.memory = bytes; }, "a size, for example 512M or 2G");
    addHeuristic(app, settings);
    addWhole(app, "--bins",
             "bins per axis (" + std::to_string(kBins) + "; shevtsov up to " + std::to_string(kMostBins) + ")",
             settings.bins, 2, kMostBins);
    addNamed(app, "--subsample", "bin every l-th reference of large nodes, l = max(1, floor(log10 n))",
             settings.subsample, kSwitch);
    addNamed(app, "--snap", "move sampled and binned planes to a face of a box beside them", settings.snap, kSwitch);
    addNamed(app, "--other-axes", "hunt-one: try the other axes where the longest has no split", settings.otherAxes,
             kSwitch);
    addNamed(app, "--small-nodes", "exact, exact-nlog2n: how planes of nodes of up to 64 references are found",
             settings.smallNodes, kSmallNodes);
    addWhole(app, "--exact-up-to",
             "exact SAH in nodes of at most so many references (" + std::to_string(kExactUpTo) + ")",
             settings.exactUpTo, 0, kMostExactUpTo);
    addWhole(app, "--max-depth", "deepest leaf (by the number of triangles)", settings.maxDepth, 1, kMaxDepth);
    addWhole(app, "--leaf-size", "medians: no split of nodes with at most so many references (4)", settings.leafSize, 1,
             1u << 20);
    addNamed(app, "--axes", "medians: axes that a node is cut along", settings.axes, kAxes);
    addNamed(app, "--clip", "clip triangles to the cells", settings.clip, kSwitch);
}

}  // namespace cleave
