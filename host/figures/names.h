// Builders, axes, views, traversals and triangle tests by name: as the command line takes them and as figures show
// them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "cleave/modes.hpp"
#include "render/cmd_render.h"
#include "tree/kd_tree.h"

namespace cleave {

// Who builds the tree, by name: one of run/device_builders.h, the twin of gpu, or one of builders/builder_names.h.
struct Builder {
    std::string_view name;
    bool operator==(const Builder&) const = default;
    static const Builder gpu, gpuExact, twin, exact, brute;
};
inline constexpr Builder Builder::gpu{"gpu"};
inline constexpr Builder Builder::gpuExact{"gpu-exact"};
inline constexpr Builder Builder::twin{"twin"};
inline constexpr Builder Builder::exact{"exact"};
inline constexpr Builder Builder::brute{"brute"};

inline constexpr std::array<std::pair<const char*, AxisChoice>, 3> kAxes = {
    {{"all", AxisChoice::all}, {"widest", AxisChoice::widest}, {"cycle", AxisChoice::cycle}}};
inline constexpr std::array<std::pair<const char*, View>, 6> kViews = {{{"shaded", View::shaded},
                                                                        {"path", View::path},
                                                                        {"normals", View::normals},
                                                                        {"depth", View::depth},
                                                                        {"steps", View::steps},
                                                                        {"leaves", View::leaves}}};
inline constexpr std::array<std::pair<const char*, Traversal>, 3> kTraversals = {
    {{"restart", Traversal::restart}, {"stack", Traversal::stack}, {"short-stack", Traversal::shortStack}}};
inline constexpr std::array<std::pair<const char*, TriangleTest>, 3> kTriangleTests = {
    {{"watertight", TriangleTest::watertight},
     {"plain", TriangleTest::plain},
     {"unfiltered", TriangleTest::unfiltered}}};

std::string nameOf(Builder builder);
std::string nameOf(AxisChoice axes);
std::string nameOf(Traversal traversal);
std::string nameOf(TriangleTest test);

}  // namespace cleave
