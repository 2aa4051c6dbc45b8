// Poses a primitive: placed by a node, its instances or a skin, it becomes triangles.
#pragma once

#include <optional>
#include <string>

#include "scene/pose.h"
#include "scene/posed_vertices.h"
#include "scene/refuse.h"
#include "scene/surface_vertices.h"

namespace cleave {

// The work that is left to a pose. A small file can ask for any amount of either kind.
struct Budget {
    size_t triangles = 0;
    size_t terms = 0;  // accessors read, vertex by vertex
};

// A primitive that makes triangles, to be placed once or many times. The scene and the joints outlive it.
class PosablePrimitive {
  public:
    PosablePrimitive(PosedVertices vertices, std::optional<SurfaceVertices> surface, VertexIndices indices,
                     gltf::Mode mode, size_t count, uint32_t material)
        : vertices_(std::move(vertices)),
          surface_(std::move(surface)),
          indices_(std::move(indices)),
          mode_(mode),
          count_(count),
          material_(material) {}
    // Appends its triangles in index order. `toWorld` does not count where it has joints.
    void appendTo(PosedScene& posed, const glm::dmat4& toWorld) const;

  private:
    void appendCorners(CornerAttributes& corners, size_t first, const glm::dmat4& toWorld) const;

    PosedVertices vertices_;
    std::optional<SurfaceVertices> surface_;  // where corners are asked for
    VertexIndices indices_;
    gltf::Mode mode_;
    size_t count_;  // of triangles
    uint32_t material_;
};

// Gives corners what they are without where the last triangles have nothing; none of them if no triangle has it.
void completeCorners(PosedScene& posed);

// A node's mesh while it is posed: `instances` times.
struct MeshPosing {
    const Scene& scene;
    const Deformation& deformation;
    size_t instances;
    Detail detail;
    Budget& budget;
    std::map<std::string, uint64_t>& leftOut;
    Warnings& warnings;

    // Prepares a primitive, and takes its work from the budget; `where` names it in messages. Returns nothing if it
    // makes no triangle, and counts in leftOut what it has instead. Throws Error if there is less left of the budget.
    std::optional<PosablePrimitive> prepare(const gltf::Primitive& primitive, const std::string& where);

  private:
    bool isPosable(const gltf::Primitive& primitive, const std::string& where);
    void leaveOut(const char* what, size_t count);
    void leaveOutLines(gltf::Mode mode, size_t indices);
    void spend(size_t triangles, size_t terms);
};

}  // namespace cleave
