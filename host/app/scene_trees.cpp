#include "app/scene_trees.h"

#include <algorithm>

#include "base/text.h"
#include "scene/moving_nodes.h"

namespace cleave {
namespace {

// Rays of a pose that lose as much by a second tree as building one triangle takes: see docs/motion.md.
constexpr uint64_t kRaysPerTriangle = 100;

bool pays(const TreeWork& work, uint64_t staticTriangles) {
    return work.recurs && !work.showsTree && staticTriangles > work.rays / kRaysPerTriangle;
}

// Rays per triangle from which on so much of the tree is reached, and so many rays wait, that building it whole is as
// fast: see docs/lazy.md.
constexpr uint64_t kFewRaysPerTriangle = 2;

bool isBuiltLazily(const Options& options, const TreeWork& work, Builder builder, uint64_t triangles) {
    if (options.lazy == Choice::on) return true;
    return options.lazy == Choice::automatic && !needForWholeTree(options) && !options.namesBuilder &&
           builder == Builder::gpu && !work.recurs && work.rays <= kFewRaysPerTriangle * triangles;
}

bool haveSameNumbers(const std::vector<ShownMesh>& a, const std::vector<ShownMesh>& b) {
    return std::ranges::equal(a, b, {}, &ShownMesh::triangles, &ShownMesh::triangles);
}

double distanceTo(const DeviceTree& tree, const glm::dvec3& eye) {
    const Box bounds = tree.bounds();
    const double unit = std::ldexp(1.0, tree.header.exponent);
    const glm::dvec3 nearest = glm::clamp(eye, unit * glm::dvec3(bounds.lo), unit * glm::dvec3(bounds.hi));
    return glm::distance(eye, nearest);
}

}  // namespace

uint64_t raysOf(const Options& options) {
    const uint64_t pixels = uint64_t{options.width} * options.height;
    return pixels * samplesOf(options) * (options.view == View::path ? 8 : showsSurfaces(options.view) ? 2 : 1);
}

SceneTrees::SceneTrees(const Options& options, Session& session, const TreeWork& work)
    : options_(options), session_(session), work_(work) {
    split();
}

void SceneTrees::split() {
    const PosedScene& posed = session_.posedButTriangles();
    const std::vector<bool>& nodes = session_.movingNodes();
    meshes_ = posed.meshes;
    parts_.clear();
    moving_ = countMoving(posed, nodes);
    const Builder chosen = session_.chosenBuilder(work_.showsTree);
    isLazy_ = isBuiltLazily(options_, work_, chosen, posed.triangles.size());
    const bool wanted = !isLazy_ && (options_.splitMoving == Choice::on ||
                                     (options_.splitMoving == Choice::automatic && pays(work_, staticTriangles())));
    if (!wanted || moving_ == 0 || staticTriangles() == 0) {
        parts_.push_back({chosen, {}, false});
        return;
    }
    const auto builderOf = [&](const std::vector<uint32_t>& list, Builder otherwise) {
        const bool isFew = list.size() <= kFewTriangles && !session_.needs().keeps(Need::tree);
        return options_.namesBuilder ? chosen : isFew ? Builder::brute : otherwise;
    };
    for (const bool moves : {false, true}) {
        std::vector<uint32_t> list = trianglesThat(moves, posed, nodes);
        const Builder builder = builderOf(list, moves ? Builder::gpu : Builder::exact);
        parts_.push_back({builder, std::move(list), !moves});
    }
}

uint64_t SceneTrees::staticTriangles() const { return session_.posedButTriangles().triangles.size() - moving_; }

void SceneTrees::build(bool plain) {
    if (!haveSameNumbers(meshes_, session_.posedButTriangles().meshes)) split();
    ms_ = staticMs_ = 0.0;
    if (isLazy_) {
        lazy_.reset();  // the old one need not be beside the new one
        builtLazily_.reset();
        lazy_ = session_.buildLazily();
        return;
    }
    for (Part& part : parts_) {
        if (part.stays && part.built.onDevice) continue;
        part.built = {};  // the old one need not be beside the new one
        part.built = plain ? session_.buildPlain(part.builder, part.list) : session_.build(part.builder, part.list);
        session_.upload(part.built);
        ms_ += part.built.ms;
        if (part.stays) staticMs_ += part.built.ms;
    }
}

Forest SceneTrees::forest() {
    if (lazy_) return Forest(*lazy_);
    std::vector<const DeviceTree*> trees;
    for (const Part& part : parts_) trees.push_back(part.built.onDevice.get());
    return Forest(std::move(trees));
}

Forest SceneTrees::forest(const glm::dvec3& eye) {
    Forest forest = this->forest();
    std::ranges::stable_sort(forest.trees, {}, [&](const DeviceTree* tree) { return distanceTo(*tree, eye); });
    return forest;
}

// Reading a tree back and its statistics take longer than building it: report and terminal share them.
const BuiltTree& SceneTrees::builtLazily() const {
    if (!builtLazily_) builtLazily_ = session_.figuresOf(*lazy_);
    return *builtLazily_;
}

Json SceneTrees::json() const {
    if (lazy_) {
        const LazyFigures& f = lazy_->figures();
        Json json = buildJson(builtLazily());
        json.update(Json{{"lazyBuiltShare", numberJson(f.builtShare())},
                         {"topMs", numberJson(f.topMs)},
                         {"expansions", f.expansions},
                         {"openNodes", f.openNodes},
                         {"neverBuilt", f.stillOpen}});
        return json;
    }
    if (!areSplit()) return buildJson(parts_.front().built);
    Json json{{"builder", nameOf(builder())}, {"ms", numberJson(ms_)}, {"trees", parts_.size()}};
    uint64_t nodes = 0, leaves = 0, references = 0, peak = 0;
    uint32_t depth = 0;
    Json parts = Json::array();
    for (const Part& part : parts_) {
        const TreeStatistics& s = part.built.statistics;
        nodes += s.nodes;
        leaves += s.leaves;
        references += s.references;
        depth = std::max(depth, s.maxDepth);
        peak = std::max(peak, part.built.peakBytes);
        Json one{{"moves", !part.stays}, {"triangles", part.list.size()}};
        one.update(buildJson(part.built));
        parts.push_back(std::move(one));
    }
    json.update(Json{{"nodes", nodes},
                     {"leaves", leaves},
                     {"references", references},
                     {"maxDepth", depth},
                     {"peakBytes", peak},
                     {"parts", parts}});
    return json;
}

std::string SceneTrees::lines() const {
    std::string text;
    if (lazy_) {
        const LazyFigures& f = lazy_->figures();
        return builtLine(builtLazily()) + "lazily    " + fixed(100.0 * f.builtShare(), 1) + " % built, " +
               grouped(f.expansions) + " times what rays waited for; " + grouped(f.stillOpen) + " of " +
               grouped(f.openNodes) + " open nodes never\n";
    }
    for (const Part& part : parts_) {
        if (areSplit())
            text += "tree      of " + grouped(part.list.size()) + (part.stays ? " that stay\n" : " that move\n");
        text += builtLine(part.built);
    }
    return text;
}

}  // namespace cleave
