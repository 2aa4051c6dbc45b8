// What the surfaces of a scene are made of, in the form that pictures take.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/needs.h"
#include "render/cmd_render.h"
#include "scene/moving_nodes.h"
#include "scene/pose.h"

namespace cleave {

// Which maps of materials a view shows. Others are not decoded.
struct ShownMaps {
    bool baseColour = false;
    bool metallicRoughness = false;
    bool normal = false;
    bool occlusion = false;
    bool emission = false;
};
ShownMaps shownMaps(View view);

// Materials, maps and corners of a posed scene. Images are decoded once each, if a triangle shows them, and take at
// most `mostBytes`. What they lack is noted as left out. For an image that is missing, damaged or beyond that, `warn`
// gets a sentence; where it would show a colour there are magenta checks.
SurfaceData surfacesOf(const Scene& scene, const PosedScene& posed, View view, uint64_t mostBytes,
                       const std::function<void(const std::string&)>& warn, Needs& needs);

// Only what differs between poses of a scene; see DeviceSurfaces::move.
SurfaceData posedSurfaces(const PosedScene& posed, const Needs& needs);
// The same of some triangles.
SurfaceData posedSurfaces(const PosedScene& posed, const TriangleRun& run, const Needs& needs);

}  // namespace cleave
