// What a run does without since its scene or its view has no need of it. It is found here; who spares the work asks.
#pragma once

#include <bitset>
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "render/cmd_render.h"
#include "scene/pose.h"
#include "tree/triangle_set.h"

namespace cleave {

// A row: the key in reports, the words on the terminal.
#define CLEAVE_NEEDS(ROW)                \
    ROW(textures, "textures")            \
    ROW(vertexColours, "vertex colours") \
    ROW(normals, "normals")              \
    ROW(alphaTest, "alpha test")         \
    ROW(backFaces, "back faces")         \
    ROW(emitters, "emitters")            \
    ROW(animation, "animation")          \
    ROW(xAxis, "x axis")                 \
    ROW(yAxis, "y axis")                 \
    ROW(zAxis, "z axis")                 \
    ROW(tree, "tree")                    \
    ROW(largeNodes, "large nodes")       \
    ROW(trails, "restart trails")        \
    ROW(shadows, "shadows")              \
    ROW(stepCounters, "step counters")   \
    ROW(unusedImages, "unused images")   \
    ROW(unusedMeshes, "unused meshes")   \
    ROW(unusedBuffers, "unused buffers")

enum class Need : size_t {
#define CLEAVE_NEED(key, words) key,
    CLEAVE_NEEDS(CLEAVE_NEED)
#undef CLEAVE_NEED
        count
};
inline constexpr size_t kNeedCount = static_cast<size_t>(Need::count);
const char* keyOf(Need need);
const char* wordsOf(Need need);

using NeedSet = std::bitset<kNeedCount>;
NeedSet only(Need need);

// Why something is left out, or how many of them.
using Reason = std::variant<std::string, uint64_t>;

class Needs {
  public:
    // `kept`: what is not to be left out.
    explicit Needs(NeedSet kept = {}) : kept_(kept) {}

    // Without it from now on, unless it is kept.
    void leaveOut(Need need, Reason reason);
    bool isLeftOut(Need need) const { return found_.contains(need) && !keeps(need); }
    bool keeps(Need need) const { return kept_[static_cast<size_t>(need)]; }

    std::map<Need, Reason> leftOut() const;
    // For the terminal; empty if nothing is left out.
    std::string line() const;

  private:
    NeedSet kept_;
    std::map<Need, Reason> found_;
};

// Triangles up to which rays test all of them, without a tree: see docs/needs.md.
inline constexpr size_t kFewTriangles = 32;

// What a scene has no need of that is loaded and posed. `played`: whether an animation is.
// `bounds`: of its triangles with finite vertices, in the world.
void findInScene(Needs& needs, const Scene& scene, const Box& bounds, bool played);
// What the surfaces of a view lack.
void findInSurfaces(Needs& needs, const SurfaceData& surfaces, View view);
// What the default builder has no need of; the tree itself only where `mayDoWithout`.
void findInBuild(Needs& needs, const TriangleSet& set, uint32_t exactUpTo, bool mayDoWithout);
// What closest and any hits have no need of, and what those of a picture have not.
void findInTracing(Needs& needs, const TraceMode& mode);
void findInPicture(Needs& needs, View view, const Emitters& emitters);

// Puts back into surfaces what they lack and is kept all the same. Pictures stay as they are.
void keepInSurfaces(const Needs& needs, SurfaceData& surfaces);

}  // namespace cleave
