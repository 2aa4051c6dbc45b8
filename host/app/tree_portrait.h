// What a report shows of a tree beside its times: what lines meet in it, and pictures.
#pragma once

#include <string>
#include <vector>

#include "app/session.h"
#include "figures/scene_errors.h"

namespace cleave {

class TreePortrait {
  public:
    TreePortrait(Run& run, Session& session) : run_(run), session_(session) {}

    // Counts along uniformly distributed lines, the same for each tree. `any` is a tree over the same triangles that is
    // on the device: it says where lines hit.
    LineErrors lines(const BuiltTree& built, const BuiltTree& any);

    // A heat map of steps, one of triangles per leaf, a cut through the cells. The scale of steps is that of
    // `standard`, so that pictures of several trees compare.
    std::vector<ReportPicture> pictures(const BuiltTree& built, const BuiltTree& standard);

  private:
    Run& run_;
    Session& session_;
    std::vector<Ray> lines_;
    std::vector<Hit> lineHits_;
    std::vector<Ray> pixels_;
    float mostSteps_ = 0.0f;

    Tracer::Result seen(const BuiltTree& built);
};

}  // namespace cleave
