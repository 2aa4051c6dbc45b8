#include "app/surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "app/lighting.h"
#include "base/error.h"
#include "base/text.h"
#include "formats/decode_image.h"
#include "scene/image_file.h"

namespace cleave {
namespace {

// Decoded images, one after the other.
class Texels {
  public:
    Texels(const Scene& scene, uint64_t mostBytes, const std::function<void(const std::string&)>& warn)
        : scene_(scene), mostTexels_(std::min<uint64_t>(mostBytes / sizeof(uint32_t), UINT32_MAX)), warn_(warn) {}

    struct Image {
        uint32_t first = 0;
        uint32_t width = 0;
        uint32_t height = 0;
        bool opaque = true;
    };

    // Nothing if it cannot be had.
    const std::optional<Image>& image(uint32_t index) {
        const auto [at, isNew] = images_.try_emplace(index);
        if (!isNew) return at->second;
        try {
            at->second = decoded(index);
        } catch (const std::exception& e) {
            warn_(std::string(e.what()) + "; magenta checks stand in for it");
        }
        return at->second;
    }

    Image checks() {
        constexpr uint32_t kMagenta = 0xFFFF00FFu, kDark = 0xFF200020u;
        if (!checks_) checks_ = append({kMagenta, kDark, kDark, kMagenta}, 2, 2);
        return *checks_;
    }

    std::vector<uint32_t> take() { return std::move(all_); }

    size_t unused() const { return scene_.images.size() - images_.size(); }
    // Decodes them, too.
    void addUnused() {
        for (uint32_t i = 0; i < scene_.images.size(); ++i) image(i);
    }

  private:
    Image decoded(uint32_t index) {
        const ImageFile file = readImageFile(scene_, index);
        const std::string name = "images[" + std::to_string(index) + "] of '" + scene_.name + "'";
        const uint64_t count = uint64_t{file.head.width} * file.head.height;
        if (count > mostTexels_ - all_.size())
            throw Error("cannot keep " + name + ": with its " + std::to_string(file.head.width) + " x " +
                        std::to_string(file.head.height) + " pixels the images take more than " +
                        bytesText(mostTexels_ * sizeof(uint32_t)) + "; scale it, or raise --memory");
        try {
            return append(decodeImage(file.bytes, file.head.width, file.head.height), file.head.width,
                          file.head.height);
        } catch (const Error& e) {
            throw Error("cannot read " + name + ": " + e.what());
        }
    }

    Image append(const std::vector<uint32_t>& pixels, uint32_t width, uint32_t height) {
        const bool opaque = std::ranges::all_of(pixels, [](uint32_t p) { return p >> 24 == 255; });
        const auto first = static_cast<uint32_t>(all_.size());
        all_.insert(all_.end(), pixels.begin(), pixels.end());
        return {first, width, height, opaque};
    }

    const Scene& scene_;
    uint64_t mostTexels_;
    const std::function<void(const std::string&)>& warn_;
    std::vector<uint32_t> all_;
    std::map<uint32_t, std::optional<Image>> images_;
    std::optional<Image> checks_;
};

uint32_t wrapFlags(gltf::Wrap s, gltf::Wrap t) {
    return (s == gltf::Wrap::clampToEdge      ? kMapClampS
            : s == gltf::Wrap::mirroredRepeat ? kMapMirrorS
                                              : 0u) |
           (t == gltf::Wrap::clampToEdge      ? kMapClampT
            : t == gltf::Wrap::mirroredRepeat ? kMapMirrorT
                                              : 0u);
}

// KHR_texture_transform: scaled, then turned, then moved. Angles are counterclockwise in a plane whose y points up;
// that of texture coordinates points down.
void transform(TextureMap& map, const gltf::TextureUse& use) {
    const double c = std::cos(use.rotation), s = std::sin(use.rotation);
    map.turn = vec4(glm::dvec4(c * use.scale.x, s * use.scale.y, -s * use.scale.x, c * use.scale.y));
    map.offset = vec2(use.offset);
}

// Where normals point to the back of a triangle, the file may mean either side.
uint32_t sidesOf(const PosedScene& posed, size_t triangle) {
    const uint32_t sides = posed.sides[triangle];
    const std::vector<vec3>& normals = posed.corners.normals;
    if (normals.empty()) return sides;
    const Triangle& t = posed.triangles[triangle];
    const glm::dvec3 a(t.a), front = glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a);
    const vec3* n = &normals[3 * triangle];
    const double along = glm::dot(front, glm::dvec3(n[0]) + glm::dvec3(n[1]) + glm::dvec3(n[2]));
    return sides | (((sides & kMirrored) != 0 ? along > 0.0 : along < 0.0) ? kNoBack : 0u);
}

template <typename Value>
std::vector<Value> some(const std::vector<Value>& all, size_t first, size_t count) {
    if (all.empty()) return {};
    return {all.begin() + ptrdiff_t(first), all.begin() + ptrdiff_t(first + count)};
}

SurfaceData surfacesAsPosed(const PosedScene& posed, const TriangleRun& run) {
    SurfaceData data;
    data.surfaceOf = some(posed.materialOf, run.first, run.count);
    if (!posed.sides.empty())
        for (size_t i = 0; i < run.count; ++i) data.surfaceOf[i] |= sidesOf(posed, run.first + i);
    data.normals = some(posed.corners.normals, 3 * run.first, 3 * run.count);
    return data;
}

TriangleRun allOf(const PosedScene& posed) { return {0, posed.triangles.size()}; }

// Makes the materials of a scene, and the maps that they need.
class Surfaces {
  public:
    Surfaces(const Scene& scene, const PosedScene& posed, View view, uint64_t mostBytes,
             const std::function<void(const std::string&)>& warn, Needs& needs)
        : scene_(scene),
          posed_(posed),
          view_(view),
          shown_(shownMaps(view)),
          texels_(scene, mostBytes, warn),
          warn_(warn),
          needs_(needs) {}

    SurfaceData run() {
        data_ = surfacesAsPosed(posed_, allOf(posed_));
        coloursHaveAlpha_ = std::ranges::any_of(posed_.corners.colours, [](const vec4& c) { return c.w < 1.0f; });
        std::vector<bool> used(scene_.materials.size());
        for (const uint32_t material : posed_.materialOf) used[material] = true;
        for (size_t i = 0; i < scene_.materials.size(); ++i) addMaterial(scene_.materials[i], used[i]);
        addCorners();
        findInSurfaces(needs_, data_, view_);
        keepInSurfaces(needs_, data_);
        if (texels_.unused() > 0) needs_.leaveOut(Need::unusedImages, texels_.unused());
        if (needs_.keeps(Need::unusedImages)) texels_.addUnused();
        data_.texels = texels_.take();
        return std::move(data_);
    }

  private:
    static constexpr bool kColour = true, kNumbers = false;

    void addMaterial(const gltf::Material& m, bool used) {
        Material made = plainMaterial(m.baseColour, m.emissive * m.emissiveStrength, m.metallic, m.roughness, 0);
        made.normalScale = m.normalScale;
        made.occlusionStrength = m.occlusionStrength;
        made.alphaCutoff = m.alphaCutoff;
        const auto map = [&](bool shown, const std::optional<gltf::TextureUse>& use, bool colour) {
            return used && shown && use ? addMap(*use, colour) : kNone;
        };
        made.baseColourMap = map(shown_.baseColour, m.baseColourTexture, kColour);
        made.metallicRoughnessMap = map(shown_.metallicRoughness, m.metallicRoughnessTexture, kNumbers);
        made.normalMap = map(shown_.normal, m.normalTexture, kNumbers);
        made.occlusionMap = map(shown_.occlusion, m.occlusionTexture, kNumbers);
        made.emissionMap = map(shown_.emission && m.emissive != glm::vec3(0.0f), m.emissiveTexture, kColour);
        made.brightness = lampBrightness(m);
        made.flags = (m.unlit ? kMaterialUnlit : 0u) | (m.doubleSided ? 0u : kMaterialSingleSided) | alphaFlags(m);
        data_.hasAlpha = data_.hasAlpha || (used && !isOpaque(made));
        data_.singleSided = data_.singleSided || (used && !m.doubleSided);
        data_.materials.push_back(made);
    }

    // A material that says that it is seen through, but has no alpha below 1, is opaque.
    uint32_t alphaFlags(const gltf::Material& m) {
        const bool hasAlpha = m.baseColour.a < 1.0f || coloursHaveAlpha_ || textureHasAlpha(m);
        const bool isMask = m.alphaMode == gltf::AlphaMode::mask;
        if (isMask && (hasAlpha || m.alphaCutoff > 1.0f)) return kMaterialMask;
        return m.alphaMode == gltf::AlphaMode::blend && hasAlpha ? kMaterialBlend : 0u;
    }

    bool textureHasAlpha(const gltf::Material& m) {
        if (!m.baseColourTexture || m.alphaMode == gltf::AlphaMode::opaque || !shown_.baseColour) return false;
        const gltf::Index image = scene_.textures[m.baseColourTexture->texture].image;
        return image && alphaOf_.contains(*image);
    }

    uint32_t addMap(const gltf::TextureUse& use, bool colour) {
        const gltf::Texture& texture = scene_.textures[use.texture];
        const gltf::Sampler sampler = texture.sampler ? scene_.samplers[*texture.sampler] : gltf::Sampler{};
        std::optional<Texels::Image> image;
        if (texture.image)
            image = texels_.image(*texture.image);
        else if (unread_.insert(use.texture).second)
            warn_("textures[" + std::to_string(use.texture) + "] of '" + scene_.name +
                  "' has no image that can be read; magenta checks stand in for it");
        TextureMap map{};
        map.flags = wrapFlags(sampler.wrapS, sampler.wrapT) | (colour ? kMapSrgb : 0u) |
                    (sampler.magFilter == gltf::Filter::nearest ? kMapNearest : 0u) | coordinateFlags(use.texCoord);
        transform(map, use);
        if (!image) {
            if (!colour) return kNone;
            image = texels_.checks();
            map.flags |= kMapNearest;
        } else if (!image->opaque) {
            alphaOf_.insert(*texture.image);
        }
        map.first = image->first;
        map.width = image->width;
        map.height = image->height;
        data_.maps.push_back(map);
        data_.parts |= kPartTextures;
        return static_cast<uint32_t>(data_.maps.size() - 1);
    }

    uint32_t coordinateFlags(uint32_t set) {
        if (set > 1 || posed_.corners.texCoords[set].empty()) return kMapAtOrigin;
        return set == 1 ? kMapSecondSet : 0u;
    }

    void addCorners() {
        const CornerAttributes& corners = posed_.corners;
        data_.colours = corners.colours;
        if (!corners.normals.empty()) data_.parts |= kPartNormals;
        if (!corners.colours.empty()) data_.parts |= kPartColours;
        if ((data_.parts & kPartTextures) == 0) return;
        data_.texCoords0 = corners.texCoords[0];
        data_.texCoords1 = corners.texCoords[1];
    }

    const Scene& scene_;
    const PosedScene& posed_;
    View view_;
    ShownMaps shown_;
    Texels texels_;
    const std::function<void(const std::string&)>& warn_;
    Needs& needs_;
    std::set<uint32_t> unread_;  // textures without an image
    bool coloursHaveAlpha_ = false;
    std::set<uint32_t> alphaOf_;  // images that are not opaque everywhere
    SurfaceData data_;
};

}  // namespace

ShownMaps shownMaps(View view) {
    ShownMaps shown;
    if (!showsSurfaces(view)) return shown;
    shown.baseColour = shown.normal = shown.emission = true;
    shown.metallicRoughness = view == View::path;
    shown.occlusion = view == View::shaded;  // paths find for themselves what light reaches a point
    return shown;
}

SurfaceData posedSurfaces(const PosedScene& posed, const Needs& needs) {
    return posedSurfaces(posed, allOf(posed), needs);
}

SurfaceData posedSurfaces(const PosedScene& posed, const TriangleRun& run, const Needs& needs) {
    SurfaceData data = surfacesAsPosed(posed, run);
    keepInSurfaces(needs, data);
    return data;
}

SurfaceData surfacesOf(const Scene& scene, const PosedScene& posed, View view, uint64_t mostBytes,
                       const std::function<void(const std::string&)>& warn, Needs& needs) {
    return Surfaces(scene, posed, view, mostBytes, warn, needs).run();
}

}  // namespace cleave
