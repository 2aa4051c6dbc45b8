#include "app/lighting.h"

#include <algorithm>
#include <cmath>

#include "render/alias_table.h"

namespace cleave {
namespace {

// Irradiance across the sun's direction, and radiance of the sky: a white surface in full light is near 1.
constexpr vec3 kSun{3.6f, 3.25f, 2.7f};
constexpr Sky kDaySky{{0.42f, 0.48f, 0.55f}, {0.14f, 0.26f, 0.48f}};

// A share of the scene's diagonal: without an end, what is in a closed room would be black.
constexpr double kAmbientShare = 0.05;

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
bool decorates(const gltf::Material& m) { return m.emissiveTexture && m.emissiveStrength <= 1.0f; }

bool hasLamps(const Scene& scene, const PosedScene& posed) {
    return std::any_of(posed.materialOf.begin(), posed.materialOf.end(),
                       [&](uint32_t material) { return lampBrightness(scene.materials[material]) > 0.0f; });
}

double areaOf(const Triangle& t) {
    const dvec3 a(t.a);
    return 0.5 * glm::length(glm::cross(dvec3(t.b) - a, dvec3(t.c) - a));
}

// Power is brightness times area. Triangles without an area, or that are not finite, are in no tree: no ray meets them.
void addEmitters(Lighting& lighting, const Scene& scene, const PosedScene& posed) {
    std::vector<double> powers;
    std::vector<uint32_t> triangles;
    double all = 0.0;
    for (uint32_t i = 0; i < posed.triangles.size(); ++i) {
        const float brightness = lampBrightness(scene.materials[posed.materialOf[i]]);
        if (!(brightness > 0.0f)) continue;
        const double power = areaOf(posed.triangles[i]) * double{brightness};
        if (!(power > 0.0) || !std::isfinite(power)) continue;
        powers.push_back(power);
        triangles.push_back(i);
        all += power;
    }
    const auto scale = static_cast<float>(1.0 / std::sqrt(all));
    // Beyond what floats hold, surfaces are found by chance alone, as light is that nobody looks for.
    if (triangles.empty() || !(scale >= kSmallestNormal) || !std::isfinite(scale)) return;
    lighting.emitterTable = aliasTable(powers, triangles);
    lighting.emitters = {static_cast<uint32_t>(lighting.emitterTable.size()), scale};
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

float lampBrightness(const gltf::Material& material) {
    if (material.unlit || decorates(material)) return 0.0f;
    return std::min(brightnessOf(material.emissive * material.emissiveStrength), kLargestFloat);
}

Lighting lightingOf(const Scene& scene, const PosedScene& posed) {
    Lighting lighting;
    for (const PlacedLight& placed : posed.lights)
        lighting.lights.push_back(sourceOf(scene.lights[placed.light], placed));
    if (lighting.lights.empty() && !hasLamps(scene, posed)) {
        lighting.sky = kDaySky;
        lighting.lights.push_back(sun());
    }
    addEmitters(lighting, scene, posed);
    return lighting;
}

float ambientReachOf(const Box& bounds) {
    return static_cast<float>(kAmbientShare * glm::length(dvec3(bounds.hi) - dvec3(bounds.lo)));
}

}  // namespace cleave
