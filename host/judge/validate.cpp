// Coverage is proven in two steps. (1) A triangle that meets the open interior of a leaf's cell must be listed there.
// That is enough for every triangle that lies in no axis-parallel plane: the planes of the tree cut it along lines
// only, so each of its points is a limit of its points in open cells; one of finitely many cells holds infinitely many
// of these, lists the triangle by (1), and is closed. (2) A triangle in a plane x[axis] = const may lie in faces of
// cells. There, apart from lines again, each of its points has one leaf below the plane and one above it (or one in
// all: inside a cell, or on the bounds). So the two sides are walked together, and for each pair of leaves whose
// rectangles overlap within the triangle one must list it. Root bounds without thickness are the case of one side only.
#include "judge/validate.h"

#include <algorithm>

#include "judge/separation.h"

namespace cleave {
namespace {

constexpr size_t kReported = 10;

struct Visit {
    uint32_t node;
    uint32_t depth;
    Box cell;
};

std::string nodeName(uint32_t node) { return "node " + std::to_string(node); }
std::string triangleName(uint32_t triangle) { return "triangle " + std::to_string(triangle); }

// -1, or the axis along which all three vertices have the same coordinate.
int planarAxis(const Triangle& t) {
    for (int axis = 0; axis < 3; ++axis)
        if (t.a[axis] == t.b[axis] && t.a[axis] == t.c[axis]) return axis;
    return -1;
}

bool isWithin(const vec3& p, const Box& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(b.lo[axis] <= p[axis] && p[axis] <= b.hi[axis])) return false;
    return true;
}

class Validator {
  public:
    Validator(const KdTree& tree, const TriangleSet& set, uint32_t maxDepth)
        : tree_(tree), set_(set), maxDepth_(maxDepth) {}

    ValidationReport run() {
        included_.assign(set_.triangles.size(), false);
        for (const uint32_t i : set_.included) included_[i] = true;
        checkBounds();
        checkStructure();
        // Coverage is defined for a sound tree only.
        if (report_.ok() && !set_.included.empty()) checkCoverage();
        if (report_.ok()) countSurplus();
        return std::move(report_);
    }

  private:
    void fail(const std::string& text) {
        if (report_.errors.size() < kReported) report_.errors.push_back(text);
        ++report_.errorCount;
    }

    void checkBounds() {
        for (const uint32_t i : set_.included) {
            const Triangle& t = set_.triangles[i];
            if (!isWithin(t.a, tree_.bounds) || !isWithin(t.b, tree_.bounds) || !isWithin(t.c, tree_.bounds))
                fail(triangleName(i) + " reaches out of the root bounds");
        }
        if (tree_.exponent != set_.exponent) fail("the tree's exponent is not that of its triangles");
    }

    void checkStructure() {
        if (tree_.nodes.empty()) return fail("the tree has no nodes");
        std::vector<bool> seen(tree_.nodes.size(), false);
        std::vector<Visit> stack{{0, 0, tree_.bounds}};
        seen[0] = true;
        firstOf_.assign(tree_.nodes.size(), 0);
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            if (isLeaf(tree_.nodes[visit.node]))
                checkLeaf(visit);
            else
                checkInner(visit, seen, stack);
        }
        for (uint32_t i = 0; i < seen.size(); ++i)
            if (!seen[i]) fail(nodeName(i) + " cannot be reached from the root");
    }

    void checkInner(const Visit& visit, std::vector<bool>& seen, std::vector<Visit>& stack) {
        const KdNode node = tree_.nodes[visit.node];
        const uint32_t child = nodeChild(node);
        const int axis = static_cast<int>(nodeAxis(node));
        const float plane = nodePosition(node);
        if (child + size_t{1} >= tree_.nodes.size()) return fail(nodeName(visit.node) + " has children out of range");
        if (seen[child] || seen[child + 1]) return fail(nodeName(visit.node) + " has a child that was reached before");
        seen[child] = seen[child + 1] = true;
        if (!(visit.cell.lo[axis] < plane && plane < visit.cell.hi[axis]))
            fail(nodeName(visit.node) + " has a plane that is not strictly inside its cell");
        Visit left{child, visit.depth + 1, visit.cell};
        Visit right{child + 1, visit.depth + 1, visit.cell};
        left.cell.hi[axis] = plane;
        right.cell.lo[axis] = plane;
        stack.push_back(right);
        stack.push_back(left);
    }

    // Also keeps the leaf's list in ascending order, for the questions that follow.
    void checkLeaf(const Visit& visit) {
        const KdNode node = tree_.nodes[visit.node];
        const uint64_t first = leafFirst(node), count = leafCount(node);
        leaves_.push_back(visit);
        if (visit.depth > maxDepth_) fail(nodeName(visit.node) + " is a leaf at depth " + std::to_string(visit.depth));
        if (first + count > tree_.leafTriangles.size())
            return fail(nodeName(visit.node) + " has a leaf list out of range");
        if (sorted_.size() + count > tree_.leafTriangles.size())
            return fail(nodeName(visit.node) + " shares its leaf list with another leaf");
        const auto begin = static_cast<std::ptrdiff_t>(sorted_.size());
        firstOf_[visit.node] = static_cast<uint32_t>(begin);
        for (uint64_t i = first; i < first + count; ++i) {
            const uint32_t triangle = tree_.leafTriangles[i];
            sorted_.push_back(triangle);
            if (triangle >= included_.size())
                fail(nodeName(visit.node) + " lists " + triangleName(triangle) + ", which does not exist");
            else if (!included_[triangle])
                fail(nodeName(visit.node) + " lists " + triangleName(triangle) + ", which is left out");
        }
        std::sort(sorted_.begin() + begin, sorted_.end());
        if (std::adjacent_find(sorted_.begin() + begin, sorted_.end()) != sorted_.end())
            fail(nodeName(visit.node) + " lists a triangle twice");
    }

    bool lists(uint32_t node, uint32_t triangle) const {
        const auto begin = sorted_.begin() + firstOf_[node];
        return std::binary_search(begin, begin + leafCount(tree_.nodes[node]), triangle);
    }

    void checkCoverage() {
        for (const uint32_t i : set_.included) {
            const int axis = planarAxis(set_.triangles[i]);
            if (axis < 0)
                work_.push_back(i);
            else
                coverPlanar(i, axis);
        }
        cover(0, tree_.bounds, 0);
    }

    // work_[begin..] are the triangles that meet the open interior of the cell and lie in no axis-parallel plane.
    void cover(uint32_t index, const Box& cell, size_t begin) {
        const KdNode node = tree_.nodes[index];
        const size_t end = work_.size();
        if (isLeaf(node)) {
            for (size_t i = begin; i < end; ++i)
                if (!lists(index, work_[i]))
                    fail(nodeName(index) + " does not list " + triangleName(work_[i]) + ", which meets its cell");
            return;
        }
        const int axis = static_cast<int>(nodeAxis(node));
        for (int side = 0; side < 2; ++side) {
            Box part = cell;
            (side == 0 ? part.hi : part.lo)[axis] = nodePosition(node);
            for (size_t i = begin; i < end; ++i)
                if (reaches(set_.triangles[work_[i]], part, axis, nodePosition(node), side == 0))
                    work_.push_back(work_[i]);
            cover(nodeChild(node) + static_cast<uint32_t>(side), part, end);
            work_.resize(end);
        }
    }

    // Does a triangle that meets the open cell meet its part on one side of the plane? One that does not straddle the
    // plane lies in a closed half space and not in the plane: its points in the cell are in that half, or tend to it.
    static bool reaches(const Triangle& t, const Box& part, int axis, float plane, bool left) {
        const float lo = std::min({t.a[axis], t.b[axis], t.c[axis]});
        const float hi = std::max({t.a[axis], t.b[axis], t.c[axis]});
        if (left ? lo >= plane : hi <= plane) return false;
        if (left ? hi <= plane : lo >= plane) return true;
        return meets(t, part, Contact::interior);
    }

    void coverPlanar(uint32_t triangle, int axis) {
        const float x = set_.triangles[triangle].a[axis];
        const bool onHigh = x == tree_.bounds.hi[axis], onLow = x == tree_.bounds.lo[axis];
        const uint32_t below = onLow && !onHigh ? kNone : 0, above = onHigh ? kNone : 0;
        coverPair({triangle, axis, x}, below, above, tree_.bounds);
    }

    struct Sheet {
        uint32_t triangle;
        int axis;
        float x;  // the coordinate of all its points
    };

    bool isLeafOrNone(uint32_t index) const { return index == kNone || isLeaf(tree_.nodes[index]); }

    // `below` ends at the sheet, `above` starts there (kNone: nothing on that side); the same node twice: the sheet
    // lies strictly inside its cell. `cell` is their common rectangle, whatever it says about the sheet's own axis.
    void coverPair(const Sheet& sheet, uint32_t below, uint32_t above, const Box& cell) {
        if (!meetsRectangle(set_.triangles[sheet.triangle], cell, sheet.axis)) return;
        if (isLeafOrNone(below) && isLeafOrNone(above)) {
            const bool listed =
                (below != kNone && lists(below, sheet.triangle)) || (above != kNone && lists(above, sheet.triangle));
            const uint32_t named = below != kNone ? below : above;
            if (!listed) fail(triangleName(sheet.triangle) + " is not covered where it touches " + nodeName(named));
            return;
        }
        const bool inside = below == above;
        const uint32_t index = isLeafOrNone(below) ? above : below;
        const KdNode node = tree_.nodes[index];
        const int axis = static_cast<int>(nodeAxis(node));
        const float plane = nodePosition(node);
        for (uint32_t side = 0; side < 2; ++side) {
            const uint32_t child = nodeChild(node) + side;
            Box part = cell;
            if (axis == sheet.axis) {
                if (inside && sheet.x == plane) return coverPair(sheet, child, child + 1, cell);
                const bool touches = inside ? (sheet.x < plane) == (side == 0) : (index == below) == (side == 1);
                if (!touches) continue;
            } else if (side == 0) {
                part.hi[axis] = std::min(part.hi[axis], plane);
            } else {
                part.lo[axis] = std::max(part.lo[axis], plane);
            }
            // The planes of one side may lie outside the rectangle that the other has already cut.
            if (axis != sheet.axis && part.lo[axis] >= part.hi[axis]) continue;
            coverPair(sheet, inside || index == below ? child : below, inside || index == above ? child : above, part);
        }
    }

    void countSurplus() {
        for (const Visit& leaf : leaves_)
            for (uint32_t i = 0; i < leafCount(tree_.nodes[leaf.node]); ++i)
                if (!meets(set_.triangles[sorted_[firstOf_[leaf.node] + i]], leaf.cell, Contact::closed))
                    ++report_.surplusReferences;
    }

    const KdTree& tree_;
    const TriangleSet& set_;
    const uint32_t maxDepth_;
    ValidationReport report_;
    std::vector<bool> included_;
    std::vector<Visit> leaves_;
    std::vector<uint32_t> sorted_;   // leaf lists, each ascending
    std::vector<uint32_t> firstOf_;  // per node: where its list begins in sorted_
    std::vector<uint32_t> work_;     // stacked lists of the nodes on the path
};

}  // namespace

ValidationReport validate(const KdTree& tree, const TriangleSet& set, uint32_t maxDepth) {
    return Validator(tree, set, maxDepth).run();
}

}  // namespace cleave
