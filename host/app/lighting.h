// What lights a scene, in the form that pictures take.
#pragma once

#include "run/renderer.h"
#include "scene/pose.h"

namespace cleave {

// What lights a scene: what shines in it, its lights (KHR_lights_punctual) and surfaces; where nothing does, a sun and
// the sky. Intensities are taken as they are: candelas and lux count as radiometric units.
Lighting lightingOf(const Scene& scene, const PosedScene& posed);

}  // namespace cleave
