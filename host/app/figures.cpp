#include "app/figures.h"

#include <algorithm>

#include "app/text.h"

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

std::optional<double> ratio(std::optional<double> value, std::optional<double> to) {
    if (!value || !to || *to == 0.0) return std::nullopt;
    return *value / *to;
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
    std::vector<Row> rows{{"builder"}};
    for (const char* name : kRaySets) {
        rows.front().push_back(std::string(name) + " ms");
        rows.front().emplace_back("Mrays/s");
    }
    rows.front().insert(rows.front().end(), {"checked", "undecided"});
    for (const BuilderFigures& f : figures) {
        Row row{nameOf(f.built.builder)};
        uint64_t checked = 0;
        uint64_t undecided = 0;
        for (const SetFigures& set : f.sets) {
            row.push_back(set.rays > 0 ? fixed(set.ms, 3) : "-");
            row.push_back(fixed(mraysPerSecond(set.rays, set.ms), 3));
            checked += set.check.rays;
            undecided += set.check.undecided;
        }
        row.insert(row.end(), {grouped(checked), grouped(undecided)});
        rows.push_back(row);
    }
    return alignedTable(rows, "l" + std::string(rows.front().size() - 1, 'r'));
}

}  // namespace cleave
