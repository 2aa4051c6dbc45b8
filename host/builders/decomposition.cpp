#include "builders/decomposition.h"

#include <algorithm>

#include "builders/binning.h"
#include "builders/graft.h"
#include "builders/threads.h"

namespace cleave {
namespace {

constexpr uint32_t kBinsPerThread = 512;

class Decomposition {
  public:
    Decomposition(KdTree& tree, const TriangleSet& set, const BuildSettings& settings, ByteCount& bytes)
        : tree_(tree),
          set_(set),
          bytes_(bytes),
          clip_(settings.clip),
          threads_(std::max(settings.threads, 1u)),
          maxDepth_(depthLimit(settings, set.included.size())) {}

    std::vector<Part> run() {
        Part whole = emptyPart(0, 0, set_.bounds, set_.included.size());
        forEachSlice(whole.count, [&](size_t, size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) whole.refs[i] = wholeTriangle(set_, set_.included[i]);
        });
        cut(std::move(whole), threads_);
        return std::move(parts_);
    }

  private:
    Part emptyPart(uint32_t node, uint32_t depth, const Box& cell, size_t count) {
        return {node, depth, cell, count, CountedArray<ClippedRef>(2 * count, bytes_)};
    }

    // Calls body(slice, begin, end) for slices of equal size, one per thread.
    template <class Body>
    void forEachSlice(size_t count, const Body& body) const {
        const auto slice = [&](size_t i) { body(i, count * i / threads_, count * (i + 1) / threads_); };
        if (threads_ == 1) return slice(0);
        forEachAtOnce(threads_, slice);
    }

    void cut(Part part, uint32_t owners) {
        const Split split = owners > 1 ? medianSplit(part, owners) : noSplit();
        if (split.axis == kLeafAxis) return parts_.push_back(std::move(part));
        const uint32_t child = appendChildren(tree_);
        tree_.nodes[part.node] = innerNode(split.axis, split.position, child);
        auto [left, right] = divide(std::move(part), split, child);
        cut(std::move(left), owners / 2);
        cut(std::move(right), owners - owners / 2);
    }

    Split medianSplit(const Part& part, uint32_t owners) const {
        const uint32_t bins = kBinsPerThread * owners;
        if (part.count <= bins || part.depth >= maxDepth_ || collapsedAxes(part.cell) >= 2) return noSplit();
        std::vector<Box> bounds(threads_);
        forEachSlice(part.count, [&](size_t slice, size_t begin, size_t end) {
            bounds[slice] = boundsOf(part.references().subspan(begin, end - begin));
        });
        Box all = bounds[0];
        for (const Box& box : bounds) all = {glm::min(all.lo, box.lo), glm::max(all.hi, box.hi)};
        const vec3 extent = all.hi - all.lo;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        const BinRange range = binRange(all.lo[axis], all.hi[axis], bins, 1.0f / static_cast<float>(bins));
        if (!isResolved(range)) return noSplit();
        return boundaryOf(part, range, axis, owners);
    }

    Split boundaryOf(const Part& part, const BinRange& range, int axis, uint32_t owners) const {
        const std::vector<uint32_t> counts = countFaces(part, range, axis);
        const uint64_t leftOwners = owners / 2, rightOwners = owners - leftOwners;
        uint64_t left = 0, right = part.count;
        uint32_t b = 0;
        do {
            left += counts[b];
            right -= counts[range.count + b];
            ++b;
        } while (b + 1 < range.count && left * rightOwners < right * leftOwners);
        const float plane = binPlane(range, b);
        if (!(part.cell.lo[axis] < plane && plane < part.cell.hi[axis])) return noSplit();
        if (std::max(left, right) == part.count) return noSplit();
        return {0.0f, static_cast<uint32_t>(axis), plane, 1};
    }

    // Numbers of references that start in each bin, then of those that end there.
    std::vector<uint32_t> countFaces(const Part& part, const BinRange& range, int axis) const {
        std::vector<std::vector<uint32_t>> ofSlice(threads_);
        forEachSlice(part.count, [&](size_t slice, size_t begin, size_t end) {
            std::vector<uint32_t> counts(2 * size_t{range.count}, 0);
            for (size_t i = begin; i < end; ++i) {
                const Box& box = part.refs[i].box;
                ++counts[startBin(range, box.lo[axis], box.hi[axis])];
                ++counts[range.count + endBin(range, box.hi[axis])];
            }
            ofSlice[slice] = std::move(counts);
        });
        std::vector<uint32_t> sum = std::move(ofSlice[0]);
        for (size_t slice = 1; slice < threads_; ++slice)
            for (size_t i = 0; i < sum.size(); ++i) sum[i] += ofSlice[slice][i];
        return sum;
    }

    struct Children {
        Part left, right;
    };
    struct Slice {
        CountedArray<ClippedRef> left, right;
        size_t leftCount = 0, rightCount = 0;
    };

    // Each thread sorts its slice into arrays of its own; then the arrays are concatenated.
    Children divide(Part part, const Split& split, uint32_t child) {
        std::vector<Slice> slices(threads_);
        forEachSlice(part.count, [&](size_t i, size_t begin, size_t end) {
            Slice& s = slices[i];
            s.left = CountedArray<ClippedRef>(end - begin, bytes_);
            s.right = CountedArray<ClippedRef>(end - begin, bytes_);
            const ChildEnds ends = partition(set_, part.references().subspan(begin, end - begin), split, clip_,
                                             {s.left.data(), s.right.data()});
            s.leftCount = static_cast<size_t>(ends.left - s.left.data());
            s.rightCount = static_cast<size_t>(ends.right - s.right.data());
        });
        part.refs = {};
        std::vector<size_t> leftAt(threads_ + 1, 0), rightAt(threads_ + 1, 0);
        for (size_t i = 0; i < threads_; ++i) {
            leftAt[i + 1] = leftAt[i] + slices[i].leftCount;
            rightAt[i + 1] = rightAt[i] + slices[i].rightCount;
        }
        const uint32_t depth = part.depth + 1;
        Children children{emptyPart(child, depth, leftOf(part.cell, split.axis, split.position), leftAt.back()),
                          emptyPart(child + 1, depth, rightOf(part.cell, split.axis, split.position), rightAt.back())};
        forEachSlice(part.count, [&](size_t i, size_t, size_t) {
            std::copy_n(slices[i].left.data(), slices[i].leftCount, children.left.refs.data() + leftAt[i]);
            std::copy_n(slices[i].right.data(), slices[i].rightCount, children.right.refs.data() + rightAt[i]);
            slices[i] = {};
        });
        return children;
    }

    KdTree& tree_;
    const TriangleSet& set_;
    ByteCount& bytes_;
    const bool clip_;
    const uint32_t threads_;
    const uint32_t maxDepth_;
    std::vector<Part> parts_;
};

}  // namespace

std::vector<Part> decompose(KdTree& tree, const TriangleSet& set, const BuildSettings& settings, ByteCount& bytes) {
    return Decomposition(tree, set, settings, bytes).run();
}

}  // namespace cleave
