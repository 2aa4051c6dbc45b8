#include "app/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/png.h"
#include "support/program.h"

namespace cleave::test {
namespace {

constexpr uint64_t kEnough = 1 << 20;

// A triangle whose material is given, with texture coordinates 0 and whatever textures, images and samplers are named.
std::string texturedScene(const std::string& material, const std::string& rest) {
    std::string text = triangleScene();
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace(R"("attributes":{"POSITION":0})", R"("material":0,"attributes":{"POSITION":0,"TEXCOORD_0":1})");
    replace(R"("min":[-1,-1,0],"max":[3,3,0]})",
            R"("min":[-1,-1,0],"max":[3,3,0]},{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})");
    replace(R"("scene":0)", R"("scene":0,"materials":[{)" + material + "}]," + rest);
    return text;
}

struct Loaded {
    SurfaceData data;
    std::vector<std::string> warnings;
    Needs needs;

    Material material() const { return data.materials.at(0); }
    TextureMap map(uint32_t number) const { return data.maps.at(number); }
};

class SurfacesTest : public testing::Test {
  protected:
    TemporaryFolder folder;

    void image(const std::string& name, uint32_t width, uint32_t height, uint32_t pixel = 0xFF3366CCu) {
        const std::vector<std::byte> png = pngOf(width, height, std::vector<uint32_t>(size_t{width} * height, pixel));
        put(folder / name, {reinterpret_cast<const char*>(png.data()), png.size()});
    }

    Loaded load(const std::string& material, const std::string& rest, View view = View::path,
                uint64_t mostBytes = kEnough) {
        put(folder / "scene.gltf", texturedScene(material, rest));
        const Scene scene = loadGltf(folder / "scene.gltf");
        Loaded loaded;
        loaded.data = surfacesOf(
            scene, pose(scene, {}, kMostTriangles, Detail::corners), view, mostBytes,
            [&](const std::string& w) { loaded.warnings.push_back(w); }, loaded.needs);
        return loaded;
    }
};

const char* const kBase = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
const char* const kOneImage = R"("textures":[{"source":0}],"images":[{"uri":"a.png"}])";

TEST_F(SurfacesTest, DecodesAnImageOnceForAllThatUseIt) {
    image("a.png", 3, 2);
    const Loaded loaded = load(std::string(kBase) + R"(,"emissiveFactor":[1,1,1],"emissiveTexture":{"index":1})",
                               R"("textures":[{"source":0},{"source":0}],"images":[{"uri":"a.png"}])");
    EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
    EXPECT_EQ(loaded.data.parts, kPartTextures);
    EXPECT_EQ(loaded.data.texels, std::vector<uint32_t>(6, 0xFF3366CCu));
    const TextureMap map = loaded.map(loaded.material().baseColourMap);
    EXPECT_EQ(map.width, 3u);
    EXPECT_EQ(map.height, 2u);
    EXPECT_EQ(map.flags, kMapSrgb);
    EXPECT_EQ(loaded.map(loaded.material().emissionMap).first, map.first);
    EXPECT_EQ(loaded.material().normalMap, kNone);
    EXPECT_EQ(loaded.data.texCoords0.size(), 3u);
}

TEST_F(SurfacesTest, ReadsNoImageThatTheViewDoesNotShow) {
    const std::string material = R"("occlusionTexture":{"index":0},"emissiveTexture":{"index":0})";
    EXPECT_EQ(load(material, kOneImage).warnings.size(), 0u) << "the file is not there, but black does not shine";
    EXPECT_EQ(load(material, kOneImage, View::shaded).warnings.size(), 1u);
    EXPECT_EQ(load(kBase, kOneImage, View::depth).warnings.size(), 0u);
}

TEST_F(SurfacesTest, ShowsChecksInThePlaceOfAMissingImage) {
    const Loaded loaded = load(kBase, kOneImage);
    ASSERT_EQ(loaded.warnings.size(), 1u);
    for (const char* part : {"images[0]", "a.png", "magenta checks"})
        EXPECT_NE(loaded.warnings[0].find(part), std::string::npos) << loaded.warnings[0];
    const TextureMap map = loaded.map(loaded.material().baseColourMap);
    EXPECT_EQ(map.flags, kMapSrgb | kMapNearest);
    EXPECT_EQ(loaded.data.texels[map.first], 0xFFFF00FFu);
    EXPECT_EQ(load(R"("normalTexture":{"index":0})", kOneImage).material().normalMap, kNone);
    EXPECT_EQ(load(kBase, R"("textures":[{}])").warnings.size(), 1u) << "a texture without an image";
}

TEST_F(SurfacesTest, RefusesDamagedImagesAndTellsWhich) {
    image("a.png", 40, 40);
    std::string bytes = contentOf(folder / "a.png");
    bytes.resize(bytes.size() - 20);
    put(folder / "a.png", bytes);
    const Loaded loaded = load(kBase, kOneImage);
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_NE(loaded.warnings[0].find("images[0]"), std::string::npos) << loaded.warnings[0];
}

TEST_F(SurfacesTest, KeepsToItsMemory) {
    image("a.png", 16, 16);
    EXPECT_EQ(load(kBase, kOneImage, View::path, 16 * 16 * 4).warnings.size(), 0u);
    const Loaded loaded = load(kBase, kOneImage, View::path, 16 * 16 * 4 - 1);
    ASSERT_EQ(loaded.warnings.size(), 1u);
    for (const char* part : {"images[0]", "16 x 16", "--memory"})
        EXPECT_NE(loaded.warnings[0].find(part), std::string::npos) << loaded.warnings[0];
}

TEST_F(SurfacesTest, SamplersSayHowImagesContinue) {
    image("a.png", 2, 2);
    const Loaded loaded = load(kBase, R"("textures":[{"source":0,"sampler":0}],"images":[{"uri":"a.png"}],
        "samplers":[{"magFilter":9728,"wrapS":33071,"wrapT":33648}])");
    EXPECT_EQ(loaded.map(0).flags, kMapSrgb | kMapNearest | kMapClampS | kMapMirrorT);
}

// By a quarter turn of KHR_texture_transform what was to the right of the origin, along u, is above it, along -v.
TEST_F(SurfacesTest, TurnsCoordinatesCounterclockwise) {
    image("a.png", 2, 2);
    const Loaded loaded = load(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1,"extensions":
        {"KHR_texture_transform":{"texCoord":0,"offset":[0.5,0.25],"rotation":1.57079632679,"scale":[2,3]}}}})",
                               kOneImage);
    const TextureMap map = loaded.map(0);
    EXPECT_NEAR(map.turn.x, 0, 1e-6f);
    EXPECT_NEAR(map.turn.y, 3, 1e-6f);
    EXPECT_NEAR(map.turn.z, -2, 1e-6f);
    EXPECT_NEAR(map.turn.w, 0, 1e-6f);
    EXPECT_EQ(map.offset, vec2(0.5f, 0.25f));
    EXPECT_EQ(map.flags, kMapSrgb) << "coordinates 0, as the extension says";
}

TEST_F(SurfacesTest, CoordinatesThatTheSceneLacksAreZero) {
    image("a.png", 2, 2);
    for (const char* set : {"1", "7"}) {
        const Loaded loaded =
            load(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":)" + std::string(set) + "}}",
                 kOneImage);
        EXPECT_EQ(loaded.map(0).flags, kMapSrgb | kMapAtOrigin);
    }
}

// Normals that point to the back of a triangle: the file may mean either side, and both are shown.
TEST_F(SurfacesTest, NormalsThatContradictTheWindingMakeATriangleTwoSided) {
    put(folder / "scene.gltf", triangleScene());
    const Scene scene = loadGltf(folder / "scene.gltf");
    PosedScene posed = pose(scene, {}, kMostTriangles, Detail::corners);
    const auto surface = [&](const vec3& normal, bool mirrored) {
        posed.corners.normals.assign(3, normal);
        posed.sides = {mirrored ? kMirrored : 0u};
        Needs needs;
        return surfacesOf(
                   scene, posed, View::path, kEnough, [](const std::string&) {}, needs)
            .surfaceOf.at(0);
    };
    EXPECT_EQ(surface({0, 0, 1}, false), 0u);
    EXPECT_EQ(surface({0, 0, -1}, false), kNoBack);
    EXPECT_EQ(surface({0, 0, -1}, true), kMirrored);
    EXPECT_EQ(surface({0, 0, 1}, true), kMirrored | kNoBack);
    EXPECT_EQ(surface(vec3(0.0f), false), 0u) << "no normals say nothing";
}

TEST_F(SurfacesTest, AlphaThatIsOneEverywhereIsOpaque) {
    image("a.png", 2, 2);
    const auto flagsOf = [&](const std::string& material) {
        const Loaded loaded = load(material + R"(,"doubleSided":true)", kOneImage);
        EXPECT_EQ(loaded.data.hasAlpha, !isOpaque(loaded.material()));
        EXPECT_FALSE(loaded.data.singleSided);
        return loaded.material().flags;
    };
    EXPECT_EQ(flagsOf(std::string(kBase) + R"(,"alphaMode":"BLEND")"), 0u);
    EXPECT_EQ(flagsOf(std::string(kBase) + R"(,"alphaMode":"MASK")"), 0u);
    const std::string glass = R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5]})";
    EXPECT_EQ(flagsOf(glass + R"(,"alphaMode":"BLEND")"), kMaterialBlend);
    EXPECT_EQ(flagsOf(glass + R"(,"alphaMode":"MASK")"), kMaterialMask);
    EXPECT_EQ(flagsOf(glass), 0u);
    EXPECT_EQ(flagsOf(R"("alphaMode":"MASK","alphaCutoff":1.5)"), kMaterialMask);
    EXPECT_TRUE(load(glass, kOneImage).data.singleSided);
}

}  // namespace
}  // namespace cleave::test
