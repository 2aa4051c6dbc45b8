// What the vertices of a primitive have beside their positions, for those who colour surfaces.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/accessor_view.h"
#include "scene/morph_targets.h"
#include "scene/refuse.h"

namespace cleave {

// NORMAL, TEXCOORD_0 and 1, and COLOR_0. Morph targets move normals alone. Numbers that are not finite are read as 0.
class SurfaceVertices {
  public:
    // What glTF does not allow, or whose data is not there, is left out, and a warning says so; `where` names the
    // primitive. The scene outlives this.
    SurfaceVertices(const Scene& scene, const gltf::Primitive& primitive, const Deformation& deformation,
                    const std::string& where, Warnings& warnings);
    // Returns how many accessors are read for a vertex.
    size_t terms() const;

    bool hasNormals() const { return normals_.has_value(); }
    bool hasTexCoords(size_t set) const { return texCoords_[set].has_value(); }
    bool hasColours() const { return colours_.has_value(); }
    // Each needs what it reads to be there.
    glm::dvec3 normal(size_t vertex) const;  // of any length, as the primitive has it
    glm::vec2 texCoord(size_t set, size_t vertex) const;
    glm::vec4 colour(size_t vertex) const;  // linear RGBA in [0, 1]

  private:
    struct Target {
        AccessorValues deltas;
        double weight;
    };
    std::optional<AccessorValues> normals_;
    std::vector<Target> normalTargets_;
    std::array<std::optional<AccessorValues>, 2> texCoords_;
    std::optional<AccessorValues> colours_;
    bool coloursHaveAlpha_ = false;
};

// Returns the matrix that takes normals along where `m` takes points: its inverse transpose, but for a factor that is
// positive. It is defined for flat transforms too.
glm::dmat3 normalMatrix(const glm::dmat4& m);

// Returns a vector of length 1; zero where it has no direction.
glm::vec3 unitOrZero(const glm::dvec3& v);

}  // namespace cleave
