#include "figures/tree_pictures.h"

#include <algorithm>
#include <cmath>

#include "figures/legend.h"
#include "shared/picture.h"
#include "shared/shade.h"

namespace cleave {
namespace {

constexpr uint32_t kNearlyWhite = 0xFFF4F4F4u;
constexpr uint32_t kTile = 8;

Picture blank(uint32_t width, uint32_t height, float high) {
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.pixels.assign(size_t{width} * height, kNearlyWhite);
    picture.scaleHigh = high;
    return picture;
}

uint32_t colourOf(double count, float high) { return packedColour(scaleColour(static_cast<float>(count) / high)); }

// The pixel of a ray of primaryRays(): these go through tiles of 8 x 8 row by row.
size_t pixelOfRay(size_t ray, uint32_t size) {
    constexpr size_t kRaysOfTile = size_t{kTile} * kTile;
    const size_t tile = ray / kRaysOfTile, inTile = ray % kRaysOfTile, tiles = size / kTile;
    const size_t x = tile % tiles * kTile + inTile % kTile, y = tile / tiles * kTile + inTile / kTile;
    return y * size + x;
}

uint32_t mixedColour(uint32_t one, uint32_t other) {  // half of each
    return (((one & 0xFEFEFEFEu) >> 1) + ((other & 0xFEFEFEFEu) >> 1)) | 0xFF000000u;
}

class CutDrawing {
  public:
    CutDrawing(const KdTree& tree, const Cut& cut, uint32_t size, float high) : tree_(tree), cut_(cut), high_(high) {
        const dvec3 lo(tree.bounds.lo), extent = dvec3(tree.bounds.hi) - lo;
        corner_ = lo;
        place_ = lo[cut.across] + 0.5 * extent[cut.across];
        const double longest = std::max(extent[cut.right], extent[cut.up]);
        scale_ = longest > 0.0 ? size / longest : 1.0;
        picture_ = blank(pixels(extent[cut.right]), pixels(extent[cut.up]), high);
    }

    Picture drawn() {
        if (!isEmpty(tree_.bounds)) visit(0, tree_.bounds);
        return std::move(picture_);
    }

  private:
    static constexpr double kLeastWithEdges = 4.0;  // pixels

    const KdTree& tree_;
    const Cut cut_;
    const float high_;
    dvec3 corner_;
    double place_ = 0.0, scale_ = 1.0;
    Picture picture_;

    uint32_t pixels(double length) const { return std::max(1u, static_cast<uint32_t>(std::lround(length * scale_))); }

    void visit(uint32_t index, const Box& cell) {
        const KdNode node = tree_.nodes[index];
        if (isLeaf(node)) return drawCell(cell, leafCount(node));
        const auto axis = static_cast<int>(nodeAxis(node));
        const float position = nodePosition(node);
        const uint32_t child = nodeChild(node);
        const bool cutsAcross = axis == cut_.across;
        if (!cutsAcross || place_ < position) visit(child, leftOf(cell, nodeAxis(node), position));
        if (!cutsAcross || place_ >= position) visit(child + 1, rightOf(cell, nodeAxis(node), position));
    }

    // Pixels whose centres lie in the cell.
    void drawCell(const Box& cell, uint32_t count) {
        const auto first = [&](int axis, float low) {
            return static_cast<int64_t>(std::ceil((double{low} - corner_[axis]) * scale_ - 0.5));
        };
        const int64_t left = first(cut_.right, cell.lo[cut_.right]), right = first(cut_.right, cell.hi[cut_.right]);
        const int64_t bottom = first(cut_.up, cell.lo[cut_.up]), top = first(cut_.up, cell.hi[cut_.up]);
        const uint32_t inner = count == 0 ? kNearlyWhite : colourOf(count, high_);
        const uint32_t edge = mixedColour(inner, count == 0 ? 0xFF808080u : 0xFF000000u);
        const bool hasEdges = static_cast<double>(std::min(right - left, top - bottom)) >= kLeastWithEdges;
        for (int64_t y = std::max<int64_t>(bottom, 0); y < std::min<int64_t>(top, picture_.height); ++y)
            for (int64_t x = std::max<int64_t>(left, 0); x < std::min<int64_t>(right, picture_.width); ++x) {
                const auto row = picture_.height - 1 - static_cast<uint64_t>(y);
                picture_.pixels[row * picture_.width + static_cast<uint64_t>(x)] =
                    hasEdges && (x == left || y == bottom) ? edge : inner;
            }
    }
};

}  // namespace

Picture stepsPicture(std::span<const StepCount> steps, uint32_t size, float high) {
    Picture picture = blank(size, size, high);
    for (size_t i = 0; i < steps.size(); ++i)
        picture.pixels[pixelOfRay(i, size)] = colourOf(double(steps[i].inner) + steps[i].leaves, high);
    drawLegend(picture);
    return picture;
}

Picture leavesPicture(std::span<const StepCount> steps, std::span<const Hit> hits, uint32_t size, float high) {
    Picture picture = blank(size, size, high);
    for (size_t i = 0; i < steps.size(); ++i)
        if (hits[i].prim != kNone) picture.pixels[pixelOfRay(i, size)] = colourOf(steps[i].hitLeaf, high);
    drawLegend(picture);
    return picture;
}

Cut cutOf(const KdTree& tree) {
    const vec3 extent = isEmpty(tree.bounds) ? vec3(1.0f) : tree.bounds.hi - tree.bounds.lo;
    if (extent.y <= extent.x && extent.y <= extent.z) return {1, 0, 2};
    if (extent.x <= extent.z) return {0, 2, 1};
    return {2, 0, 1};
}

Picture cutPicture(const KdTree& tree, const Cut& cut, uint32_t size, float high) {
    Picture picture = CutDrawing(tree, cut, size, high).drawn();
    drawLegend(picture);
    return picture;
}

}  // namespace cleave
