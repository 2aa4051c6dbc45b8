#include "support/picture.h"

#include "gpu/commands.h"
#include "render/albedo_table.h"
#include "shared/tree.h"

namespace cleave::test {

namespace {

PictureKernels& kernels() {
    static std::unique_ptr<PictureKernels> made;
    if (!made) {
        made = std::make_unique<PictureKernels>(pipelineHome());
        beforeClose([] { made.reset(); });
    }
    return *made;
}

ImageCamera cameraOf(uint32_t width, uint32_t height, uint32_t seed) {
    ImageCamera c{};
    c.eye = {0.3, -0.2, 5.0};
    c.forward = glm::normalize(glm::dvec3(0.1, 0.2, -1.0));
    c.right = glm::normalize(glm::cross(c.forward, glm::dvec3(0, 1, 0)));
    c.up = glm::cross(c.right, c.forward);
    c.pixel = 1.0 / height;
    c.width = width;
    c.height = height;
    c.orthographic = seed % 3 == 0 ? 1 : 0;
    c.tMax = 1e30f;
    return c;
}

// Images of odd sizes, one after the other, picked from in every way.
void addTextures(SurfaceData& data, std::mt19937& random) {
    std::uniform_real_distribution<float> wide(-3.0f, 3.0f);
    const uint32_t sizes[][2] = {{1, 1}, {7, 3}, {2, 16}, {5, 5}};
    for (const auto& [width, height] : sizes) {
        TextureMap map{};
        map.first = static_cast<uint32_t>(data.texels.size());
        map.width = width;
        map.height = height;
        map.turn = {wide(random), wide(random), wide(random), wide(random)};
        map.offset = {wide(random), wide(random)};
        for (const uint32_t flags : {0u, kMapSrgb | kMapClampS | kMapMirrorT, kMapNearest | kMapSecondSet | kMapMirrorS,
                                     kMapAtOrigin | kMapSrgb | kMapClampT}) {
            map.flags = flags;
            data.maps.push_back(map);
        }
        for (uint32_t i = 0; i < width * height; i++) data.texels.push_back(static_cast<uint32_t>(random()));
    }
    const auto any = [&] { return random() % 4 == 0 ? kNone : static_cast<uint32_t>(random() % data.maps.size()); };
    for (Material& m : data.materials) {
        m.baseColourMap = any();
        m.metallicRoughnessMap = any();
        m.normalMap = any();
        m.occlusionMap = any();
        m.emissionMap = any();
    }
}

SurfaceData surfacesFor(size_t triangles, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f), wide(-3.0f, 3.0f);
    SurfaceData data;
    data.parts = seed % kPartVariants;
    for (uint32_t i = 0; i < triangles; i++) data.surfaceOf.push_back(i % 3 | (random() % 2 == 0 ? kMirrored : 0u));
    data.materials = {plainMaterial({1.0f, 0.5f, 0.25f, 1.0f}, vec3(0.0f), 0.0f, 0.9f, 0),
                      plainMaterial({0.0f, 0.8f, 0.1f, 1.0f}, {0.5f, 2.0f, 0.0f}, 0.7f, 0.3f, 0),
                      plainMaterial(vec4(0.3f), vec3(0.0f), 1.0f, 0.5f, seed % 2 * kMaterialUnlit)};
    if (data.parts & kPartTextures) addTextures(data, random);
    for (size_t i = 0; i < 3 * triangles; i++) {
        const bool hasNormal = i / 3 % 5 != 0;
        const vec3 normal = glm::normalize(vec3(wide(random), wide(random), wide(random)));
        if (data.parts & kPartNormals) data.normals.push_back(hasNormal ? normal : vec3(0.0f));
        if (data.parts & kPartColours) data.colours.emplace_back(unit(random), unit(random), unit(random), 1.0f);
        if ((data.parts & kPartTextures) == 0) continue;
        data.texCoords0.emplace_back(wide(random), wide(random));
        data.texCoords1.emplace_back(wide(random), wide(random));
    }
    return data;
}

}  // namespace

PicturePair::PicturePair(uint32_t width, uint32_t height, View view, uint32_t seed, uint32_t samples) {
    const uint32_t pixels = width * height;
    std::vector<Triangle> world = mixedTriangles(100, seed);
    for (Triangle& t : world)
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = *v * 100.0f;
    const TriangleSet set = makeTriangleSet(world);  // hits are on triangles with an area only
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
    arrays.triangles = world;
    arrays.bounds = set.bounds;
    arrays.exponent = set.exponent;
    arrays.surfaces = surfacesFor(world.size(), seed);
    arrays.lights = {
        {{0.0f, 3.0f, 0.0f}, kLightPoint, {0.0f, -1.0f, 0.0f}, 0.0f, {5.0f, 4.0f, 3.0f}, infinity(), 0, 0},
        {{30.0f, 0.0f, 9.0f}, kLightSpot, {0.0f, 0.0f, -1.0f}, 0.0f, {9.0f, 9.0f, 9.0f}, 200.0f, 0.9f, 0.1f},
        {{}, kLightDirectional, {0.0f, -0.6f, 0.8f}, 0.01f, {1.0f, 1.0f, 0.5f}, 0.0f, 0, 0}};
    static const std::vector<SpecularAlbedo> kAlbedo = albedoTable();
    arrays.albedo = kAlbedo;
    for (const uint32_t prim : set.included)
        if (prim % 3 == 1) arrays.emitters.push_back({prim, set.included[below(7)], unit(random)});
    arrays.settings = {
        {{0.9f, 0.8f, 0.7f}, {0.2f, 0.3f, 0.9f}}, 3, {static_cast<uint32_t>(arrays.emitters.size()), 0.02f}, 4, seed};
    arrays.camera = cameraOf(width, height, seed);
    arrays.view = static_cast<uint32_t>(view);
    arrays.samples = samples;
    arrays.ambientReach = 30.0f;
    const bool steps = countsSteps(view), walks = view == View::path, shadows = walks || view == View::shaded;
    for (uint32_t i = 0; i < pixels; i++) {
        arrays.rays.push_back(
            {{unit(random), unit(random), unit(random)}, 0.0f, {unit(random) - 0.5f, unit(random) - 0.5f, 0.7f}, 9.0f});
        const bool found = unit(random) < 0.8f;
        const uint32_t prim = set.included[below(static_cast<uint32_t>(set.included.size()))];
        arrays.hits.push_back(found ? Hit{unit(random) * 50.0f, prim, 0.1f, 0.2f} : missedHit());
        // Counts of one to four bytes, so that every round of the selection sees several values.
        if (steps)
            arrays.steps.push_back({below(1u << (8 * (1 + i % 4) - 1)), below(10), below(30), 0, below(70000), 0});
    }
    const PictureCounts counts = pictureCounts(width, height, arrays.view, samples, partsOf(arrays.view));
    for (uint64_t i = 0; i < counts.shadowed; i++) {
        arrays.shadowHits.push_back(unit(random) < 0.5f ? arrays.hits[i % pixels] : missedHit());
        arrays.shadowRays.push_back(
            {vec3(0.0f), 0.0f, glm::normalize(vec3(unit(random) - 0.5f, unit(random), unit(random))), 9.0f});
    }
    for (uint32_t i = 0; i < pixels; i++) {
        arrays.radiance.emplace_back(unit(random), unit(random), unit(random));
        if (shadows) arrays.unlit.emplace_back(unit(random), unit(random), unit(random), below(3));
        if (!walks) continue;
        arrays.throughput.emplace_back(unit(random), unit(random), unit(random));
        arrays.density.push_back(2.0f * unit(random));
        arrays.direct.emplace_back(unit(random), unit(random), unit(random));
        if (i % 7 == 6) arrays.rays[i] = noRay();
        // Each workgroup has its paths in some order; here the shadow rays' is reversed.
        const uint32_t begin = i - i % kGroup, last = std::min(begin + kGroup, pixels) - 1;
        arrays.paths.push_back(i == last ? begin : i + 1);
        arrays.shadowPaths.push_back(last - (i - begin));
    }
    arrays.pixels.resize(pixels);

    triangles_ = uploaded(device(), std::span<const Triangle>(arrays.triangles));
    surfaces_ = std::make_unique<DeviceSurfaces>(device(), arrays.surfaces);
    lights_ = uploaded(device(), std::span<const LightSource>(arrays.lights));
    emitters_ = uploaded(device(), std::span<const AliasSlot>(arrays.emitters));
    albedo_ = uploaded(device(), std::span<const SpecularAlbedo>(arrays.albedo));
    at_ = pictureLayout(counts, 0);
    const VkDeviceSize bytes = at_.ranges.size(0);
    scratch_.reserve(device(), {&bytes, 1});
}

PictureArrays PicturePair::onDevice(PictureKernels::Pass pass, PassNumbers numbers) {
    Buffer& scratch = const_cast<Buffer&>(scratch_.buffer(0));
    PictureInfo info;
    info.bounds = arrays.bounds;
    info.exponent = arrays.exponent;
    info.triangles = triangles_.address();
    info.surfaces = surfaces_->addresses();
    info.lights = lights_.address();
    info.emitters = emitters_.address();
    info.albedo = albedo_.address();
    info.samples = arrays.samples;
    info.exposure = arrays.exposure;
    info.ambientReach = arrays.ambientReach;
    info.settings = arrays.settings;
    info.camera = arrays.camera;
    info.view = static_cast<View>(arrays.view);
    const PictureArgs args = pictureArgs(info, at_, scratch_.ranges());
    scratch.write(at_.args.offset, &args, sizeof(args));
    scratch.write(at_.state.offset, &arrays.state, sizeof(PictureState));
    const auto both = [&](auto& items, const Place& place, bool up) {
        const uint64_t bytes = items.size() * sizeof(items[0]);
        if (up)
            scratch.write(place.offset, items.data(), bytes);
        else
            scratch.read(place.offset, items.data(), bytes);
    };
    PictureArrays result = arrays;
    const auto all = [&](bool up) {
        both(result.rays, at_.rays, up);
        both(result.hits, at_.hits, up);
        both(result.steps, at_.steps, up);
        both(result.shadowRays, at_.shadowRays, up);
        both(result.shadowHits, at_.shadowHits, up);
        both(result.throughput, at_.throughput, up);
        both(result.density, at_.density, up);
        both(result.paths, at_.paths, up);
        both(result.shadowPaths, at_.shadowPaths, up);
        both(result.direct, at_.direct, up);
        both(result.radiance, at_.radiance, up);
        both(result.unlit, at_.unlit, up);
        both(result.pixels, at_.pixels, up);
    };
    all(true);
    kernels().prepare(info);
    Commands commands(device());
    commands.begin();
    const uint32_t count = args.camera.width * args.camera.height;
    const uint32_t groups = pass == PictureKernels::select_count ? 1 : ceilDiv(count, kGroup);
    kernels()
        .recorder(commands.handle())
        .dispatch(kernels().of(pass, info),
                  PicturePush{scratch.address() + at_.args.offset, numbers.round, numbers.path, 0, count}, groups);
    commands.run();
    all(false);
    scratch.read(at_.state.offset, &result.state, sizeof(PictureState));
    return result;
}

void PicturePair::onTwin(PictureKernels::Pass pass, PassNumbers numbers) {
    static constexpr void (*kTwins[])(PictureArrays&, PassNumbers) = {
#define CLEAVE_TWIN(kernel, twinOf) twin::twinOf,
        CLEAVE_PICTURE_PASSES(CLEAVE_TWIN)
#undef CLEAVE_TWIN
    };
    kTwins[pass](arrays, numbers);
}

}  // namespace cleave::test
