#include "scene/pose_again.h"

#include <algorithm>

namespace cleave {
namespace {

// Moves a part's triangles, or what they have, to where they are in the whole.
class Placing {
  public:
    Placing(PosedScene& whole, const PosedScene& part) : whole_(whole), part_(part) {}

    // Whether the part's meshes are the whole's that move, with as many triangles, and with normals where these have.
    bool fits(const std::vector<bool>& movingNodes) const {
        auto next = part_.meshes.begin();
        for (const ShownMesh& mesh : whole_.meshes) {
            if (!movingNodes[mesh.node]) continue;
            if (next == part_.meshes.end() || next->node != mesh.node || next->triangles != mesh.triangles)
                return false;
            ++next;
        }
        return next == part_.meshes.end() && (part_.corners.normals.empty() || !whole_.corners.normals.empty());
    }

    void run(const std::vector<bool>& movingNodes) {
        size_t first = 0, next = 0;
        auto mesh = part_.meshes.begin();
        for (ShownMesh& shown : whole_.meshes) {
            if (movingNodes[shown.node]) {
                replace(first, next, shown.triangles);
                next += shown.triangles;
                shown = *mesh++;
            }
            first += shown.triangles;
        }
    }

  private:
    void replace(size_t first, size_t next, size_t count) {
        copy(part_.triangles, next, whole_.triangles, first, count);
        copy(part_.sides, next, whole_.sides, first, count);
        copy(part_.corners.normals, 3 * next, whole_.corners.normals, 3 * first, 3 * count);
    }
    template <typename Item>
    static void copy(const std::vector<Item>& from, size_t at, std::vector<Item>& to, size_t first, size_t count) {
        if (!from.empty()) std::copy_n(from.begin() + ptrdiff_t(at), count, to.begin() + ptrdiff_t(first));
    }

    PosedScene& whole_;
    const PosedScene& part_;
};

}  // namespace

bool poseAgain(PosedScene& posed, const Scene& scene, const PoseTime& time, const std::vector<bool>& movingNodes,
               Detail detail) {
    PosedScene part = posePart(scene, time, movingNodes, kMostTriangles, detail);
    Placing placing(posed, part);
    if (!placing.fits(movingNodes)) {
        posed = {};  // two poses need not be in memory together
        posed = pose(scene, time, kMostTriangles, detail);
        return false;
    }
    placing.run(movingNodes);
    posed.cameras = std::move(part.cameras);
    posed.lights = std::move(part.lights);
    posed.warnings = std::move(part.warnings);
    if (const auto warning = nonFiniteWarning(posed)) posed.warnings.push_back(*warning);
    return true;
}

}  // namespace cleave
