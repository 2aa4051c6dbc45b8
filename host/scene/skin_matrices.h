// Computes the matrices of a skin's joints, as they are posed.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "scene/scene.h"

namespace cleave {

// Returns whether the matrices of a skin are there. Where they are not, its meshes are placed by their nodes.
bool hasMatrices(const Scene& scene, uint32_t skin);

// Joint matrices (joint to world * inverse bind matrix) of skins, each computed when it is first asked for.
class SkinMatrices {
  public:
    // `toWorld` has the transform of every node, and outlives this.
    SkinMatrices(const Scene& scene, const std::vector<glm::dmat4>& toWorld) : scene_(scene), toWorld_(toWorld) {}
    const std::vector<glm::dmat4>& of(uint32_t skin);

  private:
    const Scene& scene_;
    const std::vector<glm::dmat4>& toWorld_;
    std::map<uint32_t, std::vector<glm::dmat4>> known_;
};

}  // namespace cleave
