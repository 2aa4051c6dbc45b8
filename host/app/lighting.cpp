#include "app/lighting.h"

#include <algorithm>
#include <cmath>

namespace cleave {
namespace {

// Half of what the sun's disc measures in the sky, as its sine; about twice the real one, so that shadows are seen to
// be soft.
constexpr float kSineOfSun = 0.01f;
// Irradiance across the sun's direction, and radiance of the sky: a white surface in full light is near 1.
constexpr vec3 kSun{3.6f, 3.25f, 2.7f};
constexpr Sky kDaySky{{0.42f, 0.48f, 0.55f}, {0.14f, 0.26f, 0.48f}};

LightSource sourceOf(const gltf::Light& light, const PlacedLight& placed) {
    LightSource source{};
    source.position = vec3(placed.position);
    source.direction = vec3(placed.direction);
    source.kind = light.type == gltf::LightType::directional ? kLightDirectional
                  : light.type == gltf::LightType::spot      ? kLightSpot
                                                             : kLightPoint;
    source.intensity = vec3(light.colour * light.intensity);
    source.range = static_cast<float>(light.range);
    source.cosInner = static_cast<float>(std::cos(light.innerConeAngle));
    source.cosOuter = static_cast<float>(std::cos(light.outerConeAngle));
    return source;
}

// A texture of what shines is decoration, such as a display, unless the file gives it a strength.
bool isLamp(const gltf::Material& m) {
    const bool decorates = m.emissiveTexture && m.emissiveStrength <= 1.0f;
    return !decorates && largestComponent(m.emissive * m.emissiveStrength) > 0.0f;
}

bool hasLamps(const Scene& scene, const PosedScene& posed) {
    return std::any_of(posed.materialOf.begin(), posed.materialOf.end(),
                       [&](uint32_t material) { return isLamp(scene.materials[material]); });
}

LightSource sun() {
    LightSource source{};
    source.kind = kLightDirectional;
    source.direction = towardsSun() * -1.0f;
    source.capHeight = capHeight(kSineOfSun);
    source.intensity = kSun;
    return source;
}

}  // namespace

Lighting lightingOf(const Scene& scene, const PosedScene& posed) {
    Lighting lighting;
    for (const PlacedLight& placed : posed.lights)
        lighting.lights.push_back(sourceOf(scene.lights[placed.light], placed));
    if (lighting.lights.empty() && !hasLamps(scene, posed)) {
        lighting.sky = kDaySky;
        lighting.lights.push_back(sun());
    }
    return lighting;
}

}  // namespace cleave
