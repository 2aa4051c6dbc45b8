#include "instances/place_tree.h"

#include <algorithm>
#include <numeric>

namespace cleave {
namespace {

Box both(const Box& a, const Box& b) { return including(including(a, b.lo), b.hi); }

class Halving {
  public:
    explicit Halving(std::span<const Box> boxes) : boxes_(boxes) {
        tree_.nodes.resize(boxes.empty() ? 0 : 2 * boxes.size() - 1);
        tree_.order.resize(boxes.size());
        std::vector<uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        if (!all.empty()) halve(1, all);
    }
    PlaceTree take() { return std::move(tree_); }

  private:
    // The leaves below a node of the heap, level by level.
    size_t leavesBelow(size_t node) const {
        const size_t n = boxes_.size();
        size_t leaves = 0;
        for (size_t first = node, last = node; first < 2 * n; first = 2 * first, last = 2 * last + 1) {
            const size_t from = std::max(first, n), to = std::min(last, 2 * n - 1);
            if (from <= to) leaves += to - from + 1;
        }
        return leaves;
    }

    float centre(uint32_t box, uint32_t axis) const {
        return 0.5f * boxes_[box].lo[axis] + 0.5f * boxes_[box].hi[axis];
    }

    uint32_t widestAxis(std::span<const uint32_t> some) const {
        Box centres = emptyBox();
        for (const uint32_t box : some)
            centres = including(centres, vec3(centre(box, 0), centre(box, 1), centre(box, 2)));
        const vec3 size = centres.hi - centres.lo;
        if (size.x >= size.y && size.x >= size.z) return 0;
        return size.y >= size.z ? 1 : 2;
    }

    // As deep as the logarithm of the number of boxes.
    void halve(size_t node, std::span<uint32_t> some) {
        PlaceNode& at = tree_.nodes[node - 1];
        if (node >= boxes_.size()) {
            tree_.order[node - boxes_.size()] = some.front();
            at.box = boxes_[some.front()];
            return;
        }
        const uint32_t axis = widestAxis(some);
        const size_t lower = leavesBelow(2 * node);
        std::nth_element(some.begin(), some.begin() + ptrdiff_t(lower), some.end(), [&](uint32_t a, uint32_t b) {
            const float ofA = centre(a, axis), ofB = centre(b, axis);
            return ofA < ofB || (ofA == ofB && a < b);
        });
        halve(2 * node, some.first(lower));
        halve(2 * node + 1, some.subspan(lower));
        at.axis = axis;
        at.box = both(tree_.nodes[2 * node - 1].box, tree_.nodes[2 * node].box);
    }

    std::span<const Box> boxes_;
    PlaceTree tree_;
};

}  // namespace

PlaceTree placeTreeOf(std::span<const Box> boxes) { return Halving(boxes).take(); }

}  // namespace cleave
