// A loaded scene whose meshes stand in many places, and the trees of these, without a list of its triangles. What a
// Session is for copies.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "app/report.h"
#include "instances/instances.h"
#include "run/device_instances.h"

namespace cleave {

// The trees of a scene, each built once, and where they stand.
struct BuiltInstances {
    BuiltTree sum;  // all of them in one: counts and times added up, the largest peak; no tree
    DeviceInstances onDevice;
    uint64_t nonFinite = 0;
    uint64_t noArea = 0;
};

class InstancedSession {
  public:
    // `sharing`: what is kept once, as sharingOf() has it.
    InstancedSession(Run& run, ReadScene loaded, const Sharing& sharing);

    const Scene& scene() const { return scene_; }
    const PosedScene& posed() const { return posed_; }  // all but the triangles
    const Box& restBounds() const { return restBounds_; }
    Needs& needs() { return needs_; }
    const Instances& instances() const { return instances_; }
    size_t placedTriangles() const { return instances_.triangles - instances_.rest.size(); }

    BuiltInstances build(Builder builder);
    SceneFacts facts(const BuiltInstances& built) const;
    // Poses the copied scene, which is what the reference is of.
    CheckResult check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count);

  private:
    BuiltTree buildOne(Builder builder, const std::vector<Triangle>& triangles, std::span<const uint32_t> numbers);
    void warnOnce(const std::vector<std::string>& warnings);

    Run& run_;
    Needs needs_;
    Scene scene_;
    PoseTime time_;
    std::set<std::string> warned_;
    PosedScene posed_;
    Box restBounds_ = emptyBox();
    Instances instances_;
    double loadMs_ = 0.0;
    double poseMs_ = 0.0;
};

// What the run keeps once of the scene; nothing where it makes copies. Throws Error if instances are asked for by name
// and there can be none.
std::optional<Sharing> sharingFor(const Run& run, const Scene& scene);

// Of the run, or a short stack, which was the fastest where it was measured (docs/instances.md): a tree is walked in
// many places by a ray, and a whole stack is begun anew in each.
Traversal instancedTraversal(const Run& run);

// What is told of the trees and the places.
Json instancesBuildJson(const InstancedSession& session, const BuiltInstances& built);
std::string instancesLine(const InstancedSession& session, const BuiltInstances& built);

}  // namespace cleave
