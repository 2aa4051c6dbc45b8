#include "view/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "render/cmd_render.h"
#include "scene/camera.h"
#include "shared/shade.h"

namespace cleave {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr size_t kMostPlanes = 4096;

// Half of the space, beyond which nothing is drawn.
struct HalfSpace {
    dvec3 normal;  // away from what is kept
    double offset;
    double beyond(const dvec3& p) const { return glm::dot(normal, p) - offset; }
};

class Lines {
  public:
    Lines(const Camera& camera, float width, float height, std::optional<HalfSpace> clip)
        : camera_(imageCamera(camera, static_cast<uint32_t>(width), static_cast<uint32_t>(height), infinity())),
          centre_(0.5 * double{width}, 0.5 * double{height}),
          clip_(std::move(clip)) {}

    void line(const dvec3& a, const dvec3& b, ImU32 colour, float thickness) const {
        std::pair<dvec3, dvec3> part{a, b};
        if (clip_ && !cut(part, *clip_)) return;
        // What is behind the eye has no place in the picture.
        const double near = 1e-3 * std::max(glm::length(b - a), 1e-30);
        const HalfSpace behind{-camera_.forward, -(glm::dot(camera_.forward, camera_.eye) + near)};
        if (camera_.orthographic == 0 && !cut(part, behind)) return;
        const dvec2 from = place(part.first), to = place(part.second);
        ImGui::GetBackgroundDrawList()->AddLine(ImVec2(static_cast<float>(from.x), static_cast<float>(from.y)),
                                                ImVec2(static_cast<float>(to.x), static_cast<float>(to.y)), colour,
                                                thickness);
    }

    // The edges of a box, or of the rectangle that it is.
    void box(const WorldBox& box, ImU32 colour, float thickness) const {
        const auto corner = [&](int i) {
            return dvec3(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z);
        };
        const int flat =
            (box.lo.x == box.hi.x ? 1 : 0) | (box.lo.y == box.hi.y ? 2 : 0) | (box.lo.z == box.hi.z ? 4 : 0);
        for (int i = 0; i < 8; ++i)
            for (const int bit : {1, 2, 4})
                if (!(i & bit) && !(i & flat) && corner(i) != corner(i | bit))
                    line(corner(i), corner(i | bit), colour, thickness);
    }

  private:
    ImageCamera camera_;
    dvec2 centre_;
    std::optional<HalfSpace> clip_;

    static bool cut(std::pair<dvec3, dvec3>& part, const HalfSpace& space) {
        const double a = space.beyond(part.first), b = space.beyond(part.second);
        if (a > 0.0 && b > 0.0) return false;
        if (a <= 0.0 && b <= 0.0) return true;
        const dvec3 at = glm::mix(part.first, part.second, a / (a - b));
        (a > 0.0 ? part.first : part.second) = at;
        return true;
    }

    dvec2 place(const dvec3& p) const {
        const dvec3 way = p - camera_.eye;
        const double distance = camera_.orthographic != 0 ? 1.0 : glm::dot(way, camera_.forward);
        const dvec2 at = dvec2(glm::dot(way, camera_.right), -glm::dot(way, camera_.up)) / (distance * camera_.pixel);
        return centre_ + glm::clamp(at, -1e6, 1e6);
    }
};

// As the scale of counts has them: upper levels bright.
ImU32 colourOfLevel(uint32_t depth, uint32_t levels) {
    const vec3 c = scaleColour(1.0f - 0.8f * static_cast<float>(depth) / static_cast<float>(std::max(levels, 1u)));
    return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, 0.85f));
}

std::optional<HalfSpace> clipOf(const Controls& controls, const WorldBox& root) {
    if (controls.clipAxis < 0) return std::nullopt;
    const int axis = controls.clipAxis;
    dvec3 normal(0.0);
    normal[axis] = controls.clipsAbove ? 1.0 : -1.0;
    return HalfSpace{normal, normal[axis] * glm::mix(root.lo[axis], root.hi[axis], double{controls.clipAt})};
}

WorldBox boundsOf(const std::vector<StagedTree>& trees) {
    WorldBox all = rootCell(*trees.front().tree);
    for (const StagedTree& tree : trees) {
        const WorldBox root = rootCell(*tree.tree);
        all = {glm::min(all.lo, root.lo), glm::max(all.hi, root.hi)};
    }
    return all;
}

}  // namespace

void drawOverlay(const Controls& controls, const Facts& facts, float width, float height) {
    if (!facts.painted || width < 1.0f || height < 1.0f) return;
    const std::vector<StagedTree>& trees = facts.painted->staged->trees;
    const Lines lines(facts.painted->camera, width, height, clipOf(controls, boundsOf(trees)));
    for (size_t i = 0; controls.overlayLevel > 0 && i < trees.size(); ++i) {
        lines.box(rootCell(*trees[i].tree), colourOfLevel(0, controls.overlayLevel), 1.6f);
        const std::vector<CutPlane> planes =
            cutPlanes(*trees[i].tree, controls.overlayLevel, kMostPlanes / trees.size());
        for (auto plane = planes.rbegin(); plane != planes.rend(); ++plane)
            lines.box(plane->box, colourOfLevel(plane->depth, controls.overlayLevel),
                      plane->depth + 1 < controls.overlayLevel ? 1.4f : 1.0f);
    }
    if (!controls.rayCells) return;
    for (const PassedLeaf& leaf : facts.leaves)
        lines.box(leaf.box, leaf.triangles > 0 ? IM_COL32(255, 190, 60, 230) : IM_COL32(130, 170, 210, 110), 1.2f);
}

}  // namespace cleave
