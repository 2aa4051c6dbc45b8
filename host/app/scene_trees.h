// The trees that a scene's pictures and hits need: one over all of its triangles, or one of those that never move and
// one of the others (Shevtsov et al. 2007): what stays is built once, and each pose needs the other tree alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/session.h"
#include "figures/json.h"

namespace cleave {

// What is asked of the trees, as far as it is known before they are built.
struct TreeWork {
    bool showsTree = false;  // somebody looks at it
    bool recurs = false;     // in more than one pose
    uint64_t rays = 0;       // of a pose
};

// Rays of a picture, about: what follows from hits depends on what is hit. A path is taken for three bounces, with a
// shadow ray each.
uint64_t raysOf(const Options& options);

class SceneTrees {
  public:
    // Builds lazily or splits as the options say; splits by itself where a scene recurs and what it saves of building
    // is more than what rays lose. What stays is built by `exact`, if no builder is named. The session outlives this.
    SceneTrees(const Options& options, Session& session, const TreeWork& work);

    bool areSplit() const { return parts_.size() > 1; }
    uint64_t movingTriangles() const { return moving_; }
    uint64_t staticTriangles() const;

    // Builds what the session's pose needs: all at first, and then what may have moved. `plain`: without statistics and
    // hashes, which take longer.
    void build(bool plain);
    // The milliseconds of the last build(), what rays have built since included, and those of them that went into what
    // stays.
    double ms() const { return lazy_ ? lazy_->figures().ms : ms_; }
    double staticMs() const { return staticMs_; }

    // On the device; of what is lazy, rays build what they come to; the nearest to `eye` is the first one to be
    // visited.
    Forest forest(const glm::dvec3& eye);
    Forest forest();

    // Figures, as buildJson() and builtLine() have them of one tree. Not of plain ones.
    Json json() const;
    std::string lines() const;
    // Who builds what each pose needs.
    Builder builder() const { return parts_.back().builder; }

  private:
    struct Part {
        Builder builder;
        std::vector<uint32_t> list;  // numbers of triangles; empty: all
        bool stays = false;          // the same in all poses
        BuiltTree built{};
    };

    void split();
    const BuiltTree& builtLazily() const;

    const Options& options_;
    Session& session_;
    TreeWork work_;
    std::vector<ShownMesh> meshes_;  // that the parts are of
    bool isLazy_ = false;
    std::unique_ptr<LazyTree> lazy_;
    mutable std::optional<BuiltTree> builtLazily_;  // as it was when somebody asked
    std::vector<Part> parts_;                       // what stays comes first
    uint64_t moving_ = 0;
    double ms_ = 0.0;
    double staticMs_ = 0.0;
};

}  // namespace cleave
