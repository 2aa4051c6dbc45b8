// What builds on a device begin with.
#pragma once

#include <span>

#include "cleave/cleave.hpp"
#include "gpu/device.h"
#include "tree/kd_tree.h"

namespace cleave {

// The geometries outlive it.
BuildInfo deviceBuildInfo(std::span<const Geometry> geometries, const BuildSettings& settings, const Device& device);

// Throws Error where there can be no such build.
BuildSizes requireSizes(const BuildInfo& info);

}  // namespace cleave
