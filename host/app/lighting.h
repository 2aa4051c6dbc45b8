// What lights a scene, in the form that pictures take.
#pragma once

#include "run/renderer.h"
#include "scene/pose.h"

namespace cleave {

// By how much surfaces of the material are looked for as lights; 0: they are found by chance alone. Unlit ones show
// their colour and no more.
float lampBrightness(const gltf::Material& material);

// What lights a scene: what shines in it, its lights (KHR_lights_punctual) and surfaces; where nothing does, a sun and
// the sky. Intensities are taken as they are: candelas and lux count as radiometric units.
Lighting lightingOf(const Scene& scene, const PosedScene& posed);

// How far from a surface of the view `shaded` what is near takes light from all around it, in a scene of these bounds.
float ambientReachOf(const Box& bounds);

}  // namespace cleave
