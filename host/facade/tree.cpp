#include "base/error.h"
#include "facade/asked.h"
#include "facade/copied.h"
#include "facade/states.h"
#include "tree/open_edges.h"
#include "tree/tree_bytes.h"

namespace cleave::scene {

Tree::Tree(std::unique_ptr<State> state, const TreeCounts& counts) : state_(std::move(state)), counts_(counts) {}
Tree::~Tree() = default;
Tree::Tree(Tree&&) noexcept = default;
Tree& Tree::operator=(Tree&&) noexcept = default;

VkDeviceAddress Tree::address() const { return state_->tree->address(); }

void Tree::State::requireClosed() {
    if (!openEdges) {
        openEdges = cleave::openEdges(list.empty() ? *world : cleave::trianglesOf(*world, list));
    }
    requireNoOpenEdges(*openEdges);
}

Answers Tree::trace(std::span<const TraceRay> rays, const TraceMode& mode, std::span<const TraceHit> from) const {
    if (!from.empty() && from.size() != rays.size())
        throw Error("tracing: there are " + std::to_string(from.size()) + " hits to go on from for " +
                    std::to_string(rays.size()) + " rays; give one per ray, or none");
    if (mode.query != Query::closest && mode.query != Query::any)
        throw Error("tracing: a trace finds closest and any hits; ask all() or count() for the others");
    const Tracer::Result result = state_->tracer->trace(*state_->tree, copied<Ray>(rays), mode, copied<Hit>(from));
    Answers answers;
    answers.hits = copied<TraceHit>(std::span(result.hits));
    answers.steps = copied<TraceSteps>(std::span(result.steps));
    answers.ms = result.ms;
    answers.invalidRays = result.invalidRays;
    answers.unfinishedRays = result.cappedRays;
    return answers;
}

AllHits Tree::all(std::span<const TraceRay> rays, uint32_t hitsPerRay) const {
    requireHitsPerRay(hitsPerRay);
    const Tracer::Result result = state_->tracer->all(*state_->tree, copied<Ray>(rays), hitsPerRay);
    return {copied<TraceHit>(std::span(result.hits)), result.ms, result.invalidRays};
}

Counts Tree::count(std::span<const TraceRay> rays, bool isSigned) const {
    Tracer::Counts result = state_->tracer->count(*state_->tree, copied<Ray>(rays), isSigned);
    return {std::move(result.counts), result.ms, result.invalidRays};
}

Nearest Tree::nearest(std::span<const Point> points, float within) const {
    requirePoints(points);
    requireWithin(within);
    const Searcher::Nearest found = state_->searcher->nearest(*state_->tree, copied<vec3>(points), within);
    return {copied<TraceHit>(std::span(found.hits)), found.ms};
}

Contained Tree::contains(std::span<const Point> points) const {
    requirePoints(points);
    state_->requireClosed();
    Searcher::Contained found = state_->searcher->contains(*state_->tree, copied<vec3>(points));
    return {std::move(found.isInside), found.ms};
}

SignedDistances Tree::signedDistance(std::span<const Point> points) const {
    const Contained inside = contains(points);
    const Nearest found = nearest(points);
    return {signedDistances(found.hits, inside.isInside), inside.ms + found.ms};
}

Overlaps Tree::overlaps(std::span<const Box> boxes) const {
    requireBoxes(boxes);
    const Searcher::Overlaps found = state_->searcher->overlaps(*state_->tree, copied<cleave::Box>(boxes));
    return {copied<Overlap>(std::span(found.pairs)), found.ms};
}

std::vector<std::byte> Tree::save() const {
    if (!state_->list.empty())
        throw Error("cannot save the tree: it is built over a list of triangles; save one that is built over all");
    return bytesOfTree(readBack(*state_->tree), *state_->world);
}

}  // namespace cleave::scene
