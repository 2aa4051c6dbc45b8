#include "figures/survey_tables.h"

#include <cmath>
#include <span>

#include "base/text.h"
#include "figures/timing.h"

namespace cleave {
namespace {

using Row = std::vector<std::string>;
using Figure = std::optional<double>;

// A row group of a table: a scene that was measured, a model of the survey, or both.
struct Subject {
    const SurveyScene* scene;
    const SurveyModel* model;

    std::string label() const {
        if (scene == nullptr) return std::string(model->name);
        return scene->name + (scene->standsIn ? "*" : "");
    }
    // Null if that was not measured.
    const SurveyVariant* ours(std::string_view builder) const {
        const SurveyBuilder* const found = scene != nullptr ? scene->find(builder) : nullptr;
        return found != nullptr ? &found->ours : nullptr;
    }
    const SurveyVariant* pure(std::string_view builder) const {
        const SurveyBuilder* const found = scene != nullptr ? scene->find(builder) : nullptr;
        return found != nullptr && found->pure ? &*found->pure : nullptr;
    }
    Figure published(SurveyTable table, std::string_view builder) const {
        return model != nullptr ? publishedFigure(table, model->name, builder) : std::nullopt;
    }
};

// The survey's models in their order, then the other scenes.
std::vector<Subject> subjectsOf(const std::vector<SurveyScene>& scenes, SurveyTable table) {
    std::vector<Subject> subjects;
    for (const SurveyModel& model : surveyModels()) {
        bool measured = false;
        for (const SurveyScene& scene : scenes)
            if (scene.model == &model) {
                subjects.push_back({&scene, &model});
                measured = true;
            }
        if (!measured && isPublished(table, model.name)) subjects.push_back({nullptr, &model});
    }
    for (const SurveyScene& scene : scenes)
        if (scene.model == nullptr) subjects.push_back({&scene, nullptr});
    return subjects;
}

Figure medianIfAny(const std::vector<double>& runs) { return runs.empty() ? Figure() : medianOf(runs); }
// Medians in ms; nothing for a builder that is not there.
Figure oneThread(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->oneThread) : Figure(); }
Figure oneCpu(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->oneCpu) : Figure(); }
Figure allThreads(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->allThreads) : Figure(); }
Figure uploadTime(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->upload) : Figure(); }
Figure primaryTime(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->primary) : Figure(); }
Figure diffuseTime(const SurveyVariant* v) { return v != nullptr ? medianIfAny(v->diffuse) : Figure(); }
Figure sahCost(const SurveyVariant* v) { return v != nullptr ? v->statistics.sahCost : Figure(); }
Figure rayCost(const SurveyVariant* v) { return v != nullptr ? Figure(v->rayCost) : Figure(); }

Figure rayTime(const SurveyVariant* v) {
    const Figure primary = primaryTime(v), diffuse = diffuseTime(v);
    return primary && diffuse ? Figure(*primary + *diffuse) : std::nullopt;
}

// From triangles to answered primary rays.
Figure timeToImage(const SurveyVariant* v) {
    const Figure build = allThreads(v), primary = primaryTime(v);
    return build && primary ? Figure(*build + uploadTime(v).value_or(0.0) + *primary) : std::nullopt;
}

Figure perCentMore(Figure value, Figure than) {
    const Figure r = ratio(value, than);
    return r ? Figure(100.0 * (*r - 1.0)) : std::nullopt;
}

// Published figures follow a bar, which is a column of its own.
constexpr const char* kBar = "|";

std::string table(const std::string& title, const std::vector<Row>& rows, size_t words) {
    return title + "\n" + alignedTable(rows, std::string(words, 'l') + std::string(rows.front().size() - words, 'r')) +
           "\n";
}

std::string threadsText(uint32_t threads) { return std::to_string(threads) + (threads == 1 ? " thread" : " threads"); }

// The name of a model, once above the rows of its builders.
std::string labelAbove(const Subject& subject, std::string_view builder) {
    return builder == "exact" ? subject.label() : "";
}

void append(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

// Table 5.1.
std::string exactTable(const std::vector<SurveyScene>& scenes) {
    constexpr SurveyTable kTable = SurveyTable::exactBuilds;
    std::vector<Row> rows{{"model", "triangles", "pure lg^2", "pure lg", "ratio", "ours lg^2", "ours lg", "ratio", kBar,
                           "lg^2 s", "lg s", "ratio"}};
    const auto pair = [](Figure perNode, Figure once, int digits) {
        return Row{fixed(perNode, digits), fixed(once, digits), fixed(ratio(perNode, once), 2)};
    };
    for (const Subject& s : subjectsOf(scenes, kTable)) {
        Row row{s.label(), s.scene != nullptr ? grouped(s.scene->triangles) : std::string(s.model->triangles)};
        append(row, pair(oneCpu(s.pure("exact-nlog2n")), oneCpu(s.pure("exact")), 1));
        append(row, pair(oneCpu(s.ours("exact-nlog2n")), oneCpu(s.ours("exact")), 1));
        row.push_back(kBar);
        append(row, pair(s.published(kTable, "exact-nlog2n"), s.published(kTable, "exact"), 2));
        rows.push_back(row);
    }
    return table(
        "Table 5.1: cpu ms of N lg^2 N and N lg N builds, sorting in all nodes (pure) | published (Wald and Havran "
        "2006)",
        rows, 1);
}

// Table 6.1, and where threads help.
std::string buildTable(const std::vector<SurveyScene>& scenes, uint32_t threads) {
    constexpr SurveyTable kTable = SurveyTable::huntBuilds;
    const std::string many = threadsText(threads);
    std::vector<Row> rows{
        {"model", "builder", "pure ms", "x", "ours ms", "x", many, "x", "1 over it", kBar, "seconds", "x"}};
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name : {"exact", "hunt-all", "hunt-hybrid", "hunt-one", "shevtsov"}) {
            const SurveyVariant *const ours = s.ours(name), *const pure = s.pure(name), *const exact = s.ours("exact");
            const Figure published = s.published(kTable, name);
            if (ours == nullptr && !published) continue;
            rows.push_back({labelAbove(s, name), std::string(name), fixed(oneCpu(pure), 1),
                            fixed(ratio(oneCpu(s.pure("exact")), oneCpu(pure)), 2), fixed(oneCpu(ours), 1),
                            fixed(ratio(oneCpu(exact), oneCpu(ours)), 2), fixed(allThreads(ours), 1),
                            fixed(ratio(allThreads(exact), allThreads(ours)), 2),
                            fixed(ratio(oneThread(ours), allThreads(ours)), 2), kBar, fixed(published, 2),
                            fixed(ratio(s.published(kTable, "exact"), published), 2)});
        }
    return table(
        "Table 6.1: build, cpu ms of 1 thread, ms of " + many + "; x: exact's over it | published (Hunt et al. 2006)",
        rows, 2);
}

// Table 6.2.
std::string renderingTable(const std::vector<SurveyScene>& scenes) {
    constexpr SurveyTable kTable = SurveyTable::huntRendering;
    std::vector<Row> rows{
        {"model", "builder", "pure time", "cost", "SAH", "refs", "ours time", "cost", "SAH", "refs", kBar, "time"}};
    const auto more = [](const SurveyVariant* v, const SurveyVariant* exact) {
        return Row{fixed(perCentMore(rayTime(v), rayTime(exact)), 2), fixed(perCentMore(rayCost(v), rayCost(exact)), 2),
                   fixed(perCentMore(sahCost(v), sahCost(exact)), 2),
                   v != nullptr ? grouped(v->statistics.references) : "-"};
    };
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name : {"exact", "hunt-all", "hunt-hybrid", "hunt-one", "shevtsov", "gpu"}) {
            const Figure published = s.published(kTable, name);
            if (s.ours(name) == nullptr && !published) continue;
            Row row{labelAbove(s, name), std::string(name)};
            append(row, more(s.pure(name), s.pure("exact")));
            append(row, more(s.ours(name), s.ours("exact")));
            append(row, {kBar, fixed(published, 2)});
            rows.push_back(row);
        }
    return table("Table 6.2: % over exact: time of rays, their cost by count, SAH cost | published (Hunt et al. 2006)",
                 rows, 2);
}

// Table 7.1.
std::string imageTable(const std::vector<SurveyScene>& scenes, uint32_t threads) {
    constexpr SurveyTable kTable = SurveyTable::shevtsovToImage;
    std::vector<Row> rows{
        {"model", "builder", "pure build", "to image", "x", "ours build", "to image", "x", kBar, "seconds", "x"}};
    const auto times = [](const SurveyVariant* v, const SurveyVariant* exact) {
        return Row{fixed(allThreads(v), 1), fixed(timeToImage(v), 1),
                   fixed(ratio(timeToImage(exact), timeToImage(v)), 2)};
    };
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name : {"exact", "shevtsov", "gpu"}) {
            const Figure published = s.published(kTable, name);
            if (s.ours(name) == nullptr && !published) continue;
            Row row{labelAbove(s, name), std::string(name)};
            append(row, times(s.pure(name), s.pure("exact")));
            append(row, times(s.ours(name), s.ours("exact")));
            append(row, {kBar, fixed(published, 3), fixed(ratio(s.published(kTable, "exact"), published), 1)});
            rows.push_back(row);
        }
    return table("Table 7.1: ms to build, upload and trace primary rays, " + threadsText(threads) +
                     "; x: exact's over it | published (Shevtsov et al. 2007)",
                 rows, 2);
}

// Section 4's claim about medians: a row per builder and rule of axes, a column per leaf size.
std::string medianTable(const std::vector<SurveyScene>& scenes) {
    Row head{"model", "builder", "axes"};
    for (const std::string cost : {"SAH ", "rays "})
        for (size_t i = 0; i < kMedianLeafSizes.size(); ++i)
            head.push_back((i == 0 ? cost : "") + std::to_string(kMedianLeafSizes[i]));
    std::vector<Row> rows{head};
    for (const SurveyScene& scene : scenes) {
        const SurveyMedians& medians = scene.medians;
        for (size_t first = 0; first + kMedianLeafSizes.size() <= medians.trees.size();
             first += kMedianLeafSizes.size()) {
            const std::span<const MedianTree> trees(&medians.trees[first], kMedianLeafSizes.size());
            Row row{first == 0 ? scene.name : "", nameOf(trees[0].builder), nameOf(trees[0].axes)};
            for (const MedianTree& tree : trees)
                row.push_back(fixed(perCentMore(tree.sahCost, medians.exactSahCost), 1));
            for (const MedianTree& tree : trees)
                row.push_back(fixed(perCentMore(tree.rayCost, medians.exactRayCost), 1));
            rows.push_back(row);
        }
    }
    return table("Section 4: medians by leaf size, % over exact: SAH cost, then cost of rays by count", rows, 3);
}

// Section 5: what one thread counted, over the growth that the survey says.
std::string complexityTable(const std::vector<SurveyScene>& scenes) {
    std::vector<Row> rows{
        {"model", "triangles", "events", "sorted once", "sorted per node", "bytes", "straddling", "at most"}};
    for (const SurveyScene& scene : scenes) {
        const SurveyComplexity& c = scene.complexity;
        const auto n = static_cast<double>(scene.triangles);
        const double lg = std::log2(n);
        const bool fits = c.straddling.octaves >= 2;
        rows.push_back({scene.name + (scene.standsIn ? "*" : ""), grouped(scene.triangles),
                        fixed(static_cast<double>(c.once.eventsSwept) / (n * lg), 2),
                        fixed(static_cast<double>(c.once.sortSteps) / (n * lg), 2),
                        fixed(static_cast<double>(c.perNode.sortSteps) / (n * lg * lg), 2),
                        fixed(static_cast<double>(c.once.peakBytes) / n, 0),
                        fits ? fixed(c.straddling.factor, 2) + " n^" + fixed(c.straddling.exponent, 2) : "-",
                        fits ? fixed(c.worstCut, 1) + " sqrt(n)" : "-"});
    }
    return table("Section 5: events swept and sort steps over N lg N, sort steps per node over N lg^2 N, bytes over N",
                 rows, 1);
}

std::string footnotes(const std::vector<SurveyScene>& scenes) {
    std::string text;
    for (const SurveyScene& scene : scenes)
        if (scene.standsIn)
            text += "* " + scene.name + " stands in for the survey's " + std::string(scene.model->name) +
                    ": as many triangles, another file\n";
    return text;
}

}  // namespace

std::string surveyTables(const std::vector<SurveyScene>& scenes, uint32_t threads) {
    return exactTable(scenes) + buildTable(scenes, threads) + renderingTable(scenes) + imageTable(scenes, threads) +
           medianTable(scenes) + complexityTable(scenes) + footnotes(scenes);
}

}  // namespace cleave
