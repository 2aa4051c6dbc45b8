#include "base/error.h"
#include "facade/copied.h"
#include "facade/states.h"

namespace cleave::scene {

Tree::Tree(std::unique_ptr<State> state, const TreeCounts& counts) : state_(std::move(state)), counts_(counts) {}
Tree::~Tree() = default;
Tree::Tree(Tree&&) noexcept = default;
Tree& Tree::operator=(Tree&&) noexcept = default;

VkDeviceAddress Tree::address() const { return state_->tree->address(); }

Answers Tree::trace(std::span<const TraceRay> rays, const TraceMode& mode, std::span<const TraceHit> from) const {
    if (!from.empty() && from.size() != rays.size())
        throw Error("tracing: there are " + std::to_string(from.size()) + " hits to go on from for " +
                    std::to_string(rays.size()) + " rays; give one per ray, or none");
    const Tracer::Result result = state_->tracer->trace(*state_->tree, copied<Ray>(rays), mode, copied<Hit>(from));
    Answers answers;
    answers.hits = copied<TraceHit>(std::span(result.hits));
    answers.steps = copied<TraceSteps>(std::span(result.steps));
    answers.ms = result.ms;
    answers.invalidRays = result.invalidRays;
    answers.unfinishedRays = result.cappedRays;
    return answers;
}

}  // namespace cleave::scene
