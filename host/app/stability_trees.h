// The trees and the traversals that stability is looked for in.
#pragma once

#include <array>
#include <memory>

#include "app/run.h"
#include "instances/instances.h"
#include "stability/sweep.h"

namespace cleave {

inline constexpr std::array kDeviceTraversals{Traversal::restart, Traversal::stack, Traversal::shortStack};

// Builds with the settings of the run's options; the tree is on the host and on the device.
std::shared_ptr<TreeUnderTest> buildForTest(Run& run, Builder builder, const TriangleSet& set,
                                            const DeviceTriangles& triangles);
// Builds the trees of the two halves of a scene, too.
void buildHalves(Run& run, Builder builder, std::span<const Triangle> world, const DeviceTriangles& triangles,
                 TreeUnderTest& tree);
// Builds the trees of a placed case and puts them in their places.
std::shared_ptr<TreeUnderTest> buildPlaced(Run& run, Builder builder, const Instances& instances);

// Leaves trees over all triangles open, one for each of lazyTraversals().
void buildLazily(Run& run, const DeviceTriangles& triangles, TreeUnderTest& tree);

// Those of the device, for closest and for any hits, with steps counted, the fastest of them through two trees and
// uncounted as well, and the walk on the host where it is affordable.
std::vector<TraversalUnderTest> traversalsFor(Run& run, const TriangleSet& set);
// Those of the device once more, through trees that are built where rays come to.
std::vector<TraversalUnderTest> lazyTraversals(Run& run);
// Those of the device through instances, likewise.
std::vector<TraversalUnderTest> placedTraversals(Run& run);

}  // namespace cleave
