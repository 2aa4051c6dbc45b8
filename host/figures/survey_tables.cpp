#include "figures/survey_tables.h"

#include <cmath>

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
    const SurveyBuilder* find(std::string_view builder) const {
        return scene != nullptr ? scene->find(builder) : nullptr;
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
Figure oneThread(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->oneThread) : Figure(); }
Figure oneCpu(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->oneCpu) : Figure(); }
Figure allThreads(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->allThreads) : Figure(); }
Figure uploadTime(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->upload) : Figure(); }
Figure primaryTime(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->primary) : Figure(); }
Figure diffuseTime(const SurveyBuilder* b) { return b != nullptr ? medianIfAny(b->diffuse) : Figure(); }
Figure sahCost(const SurveyBuilder* b) { return b != nullptr ? b->statistics.sahCost : Figure(); }
Figure rayCost(const SurveyBuilder* b) { return b != nullptr ? Figure(b->rayCost) : Figure(); }

Figure rayTime(const SurveyBuilder* b) {
    const Figure primary = primaryTime(b), diffuse = diffuseTime(b);
    return primary && diffuse ? Figure(*primary + *diffuse) : std::nullopt;
}

// From triangles to answered primary rays.
Figure timeToImage(const SurveyBuilder* b) {
    const Figure build = allThreads(b), primary = primaryTime(b);
    return build && primary ? Figure(*build + uploadTime(b).value_or(0.0) + *primary) : std::nullopt;
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

// Table 5.1.
std::string exactTable(const std::vector<SurveyScene>& scenes) {
    constexpr SurveyTable kTable = SurveyTable::exactBuilds;
    std::vector<Row> rows{{"model", "triangles", "N log^2 N cpu ms", "N log N cpu ms", "ratio", kBar, "triangles",
                           "N log^2 N s", "N log N s", "ratio"}};
    for (const Subject& s : subjectsOf(scenes, kTable)) {
        const Figure perNode = oneCpu(s.find("exact-nlog2n")), once = oneCpu(s.find("exact"));
        const Figure hadPerNode = s.published(kTable, "exact-nlog2n"), hadOnce = s.published(kTable, "exact");
        rows.push_back({s.label(), s.scene != nullptr ? grouped(s.scene->triangles) : "-", fixed(perNode, 1),
                        fixed(once, 1), fixed(ratio(perNode, once), 2), kBar,
                        std::string(s.model != nullptr ? s.model->triangles : "-"), fixed(hadPerNode, 2),
                        fixed(hadOnce, 2), fixed(ratio(hadPerNode, hadOnce), 2)});
    }
    return table("Table 5.1: the two exact builds, one thread | published (Wald and Havran 2006)", rows, 1);
}

// Table 6.1, and where threads help.
std::string buildTable(const std::vector<SurveyScene>& scenes, uint32_t threads) {
    constexpr SurveyTable kTable = SurveyTable::huntBuilds;
    const std::string many = threadsText(threads);
    std::vector<Row> rows{{"model", "builder", "1 thread cpu ms", "exact/it", many + " ms", "exact/it", "1 to " + many,
                           kBar, "seconds", "exact/it"}};
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name : {"exact", "hunt-all", "hunt-hybrid", "hunt-one", "shevtsov"}) {
            const SurveyBuilder *const b = s.find(name), *const exact = s.find("exact");
            const Figure published = s.published(kTable, name);
            if (b == nullptr && !published) continue;
            rows.push_back({labelAbove(s, name), std::string(name), fixed(oneCpu(b), 1),
                            fixed(ratio(oneCpu(exact), oneCpu(b)), 2), fixed(allThreads(b), 1),
                            fixed(ratio(allThreads(exact), allThreads(b)), 2),
                            fixed(ratio(oneThread(b), allThreads(b)), 2), kBar, fixed(published, 2),
                            fixed(ratio(s.published(kTable, "exact"), published), 2)});
        }
    return table("Table 6.1: build time | published (Hunt et al. 2006)", rows, 2);
}

// Table 6.2, and section 4's claim about medians.
std::string renderingTable(const std::vector<SurveyScene>& scenes) {
    constexpr SurveyTable kTable = SurveyTable::huntRendering;
    std::vector<Row> rows{{"model", "builder", "primary ms", "diffuse ms", "both +%", "ray cost +%", "SAH cost", "+%",
                           "references", kBar, "+%"}};
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name :
             {"exact", "hunt-all", "hunt-hybrid", "hunt-one", "shevtsov", "gpu", "spatial-median", "object-median"}) {
            const SurveyBuilder *const b = s.find(name), *const exact = s.find("exact");
            const Figure published = s.published(kTable, name);
            if (b == nullptr && !published) continue;
            rows.push_back({labelAbove(s, name), std::string(name), fixed(primaryTime(b), 1), fixed(diffuseTime(b), 1),
                            fixed(perCentMore(rayTime(b), rayTime(exact)), 2),
                            fixed(perCentMore(rayCost(b), rayCost(exact)), 2), fixed(sahCost(b), 2),
                            fixed(perCentMore(sahCost(b), sahCost(exact)), 2),
                            b != nullptr ? grouped(b->statistics.references) : "-", kBar, fixed(published, 2)});
        }
    return table("Table 6.2: rendering, and what the trees cost, over exact's | published (Hunt et al. 2006)", rows, 2);
}

// Table 7.1.
std::string imageTable(const std::vector<SurveyScene>& scenes, uint32_t threads) {
    constexpr SurveyTable kTable = SurveyTable::shevtsovToImage;
    std::vector<Row> rows{{"model", "builder", "build ms", "upload ms", "primary ms", "to image ms", "exact/it", kBar,
                           "seconds", "exact/it"}};
    for (const Subject& s : subjectsOf(scenes, kTable))
        for (const std::string_view name : {"exact", "shevtsov", "gpu"}) {
            const SurveyBuilder* const b = s.find(name);
            const Figure published = s.published(kTable, name);
            if (b == nullptr && !published) continue;
            rows.push_back({labelAbove(s, name), std::string(name), fixed(allThreads(b), 1), fixed(uploadTime(b), 1),
                            fixed(primaryTime(b), 1), fixed(timeToImage(b), 1),
                            fixed(ratio(timeToImage(s.find("exact")), timeToImage(b)), 2), kBar, fixed(published, 3),
                            fixed(ratio(s.published(kTable, "exact"), published), 1)});
        }
    return table("Table 7.1: time to image, " + threadsText(threads) + " | published (Shevtsov et al. 2007)", rows, 2);
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
           complexityTable(scenes) + footnotes(scenes);
}

}  // namespace cleave
