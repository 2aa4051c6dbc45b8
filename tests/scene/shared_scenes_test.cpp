// The tables of the scene collection that lies beside the checkout on some machines, and our own scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "scene/gltf_text.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(CLEAVE_SOURCE) / ".." / "shared";

// Rows of a table with a heading, as lists of fields.
std::vector<std::vector<std::string>> rowsOf(const fs::path& table) {
    std::ifstream stream(table);
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, '\t');) rows.back().push_back(field);
    }
    return rows;
}

std::string errorOf(const fs::path& file, PosedScene& scene) {
    try {
        scene = posed(loadGltf(file));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SharedScenes, haveTheirNumberOfTriangles) {
    const fs::path folder = kShared / "scenes";
    if (!fs::exists(folder / "SCENES.tsv")) GTEST_SKIP() << "no collection beside the checkout";
    for (const auto& row : rowsOf(folder / "SCENES.tsv")) {
        PosedScene scene;
        const std::string error = errorOf(folder / row.at(0), scene);
        EXPECT_EQ(error, "");
        EXPECT_EQ(scene.triangles.size(), std::stoul(row.at(3))) << row[0];
        EXPECT_EQ(scene.materialOf.size(), scene.triangles.size());
    }
}

TEST(SharedScenes, badFilesAreRefusedOrSurvived) {
    const fs::path folder = kShared / "bad";
    if (!fs::exists(folder / "expected.tsv")) GTEST_SKIP() << "no collection beside the checkout";
    for (const auto& row : rowsOf(folder / "expected.tsv")) {
        PosedScene scene;
        const std::string error = errorOf(folder / row.at(0), scene);
        EXPECT_EQ(error.empty(), row.at(1) == "survive") << row[0] << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
        EXPECT_EQ(scene.warnings.empty(), row.at(1) == "reject") << row[0];
    }
}

TEST(SharedScenes, validFilesLoadAndOthersDoNotCrash) {
    const fs::path folder = kShared / "bad" / "khronos_validator";
    if (!fs::exists(folder / "expected.tsv")) GTEST_SKIP() << "no collection beside the checkout";
    for (const auto& row : rowsOf(folder / "expected.tsv")) {
        PosedScene scene;
        const std::string error = errorOf(folder / row.at(0), scene);
        EXPECT_TRUE(error.empty() || row.at(1) != "valid") << row[0] << ": " << error;
    }
}

// A triangle's corners sorted, and the triangles sorted, coordinates rounded to 1e-5; those without area are left out,
// since strips have some.
std::vector<std::array<int, 9>> canonical(const PosedScene& scene) {
    std::vector<std::array<int, 9>> all;
    for (const Triangle& t : scene.triangles) {
        std::array<std::array<int, 3>, 3> corners;
        const vec3 vertices[3] = {t.a, t.b, t.c};
        for (size_t c = 0; c < 3; ++c)
            for (size_t axis = 0; axis < 3; ++axis)
                corners[c][axis] = int(std::lround(double(vertices[c][int(axis)]) * 1e5));
        std::sort(corners.begin(), corners.end());
        if (corners[0] == corners[1] || corners[1] == corners[2]) continue;
        std::array<int, 9> flat;
        for (size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
        all.push_back(flat);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// A coordinate on the border of two roundings may fall either way, so neighbours are equal too.
size_t differences(const std::vector<std::array<int, 9>>& a, const std::vector<std::array<int, 9>>& b, int tolerance) {
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const bool equal = std::any_of(b.begin(), b.end(), [&](const std::array<int, 9>& other) {
            for (size_t k = 0; k < 9; ++k)
                if (std::abs(a[i][k] - other[k]) > tolerance) return false;
            return true;
        });
        count += equal ? 0 : 1;
    }
    return count;
}

TEST(SharedScenes, oneSphereInManyEncodingsIsOneSphere) {
    const fs::path folder = kShared / "scenes" / "generated" / "equiv";
    if (!fs::exists(folder)) GTEST_SKIP() << "no collection beside the checkout";
    const auto sphere = canonical(pose(loadGltf(folder / "ico_idx32.glb")));
    EXPECT_EQ(sphere.size(), 320u);
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".bin") continue;
        const int tolerance = name == "ico_quantized" ? 4 : 1;  // 16 bits: half a step is 1.5e-5
        EXPECT_EQ(differences(canonical(pose(loadGltf(entry.path()))), sphere, tolerance), 0u) << name;
        ++files;
    }
    EXPECT_EQ(files, 17u);
}

TEST(OwnScenes, areAsTheirReadmeSays) {
    const fs::path folder = fs::path(CLEAVE_SOURCE) / "scenes";
    const std::vector<std::pair<const char*, size_t>> expected = {
        {"default.glb", 255510}, {"still_life.glb", 68016}, {"cornell.glb", 36},
        {"grid.glb", 480},       {"triangle.gltf", 1},      {"empty.gltf", 0},
        {"needles.glb", 128},    {"shells.glb", 96},        {"stack.glb", 1000}};
    for (const auto& [name, triangles] : expected) {
        const PosedScene scene = posed(loadGltf(folder / name));
        EXPECT_EQ(scene.triangles.size(), triangles) << name;
        EXPECT_TRUE(scene.warnings.empty()) << name;
    }
    for (const char* name : {"default.glb", "still_life.glb"})
        EXPECT_EQ(pose(loadGltf(folder / name)).cameras.at(0).name, "main") << name;
    for (const Triangle& t : pose(loadGltf(folder / "default.glb")).triangles) {
        const glm::dvec3 a(t.a);
        const glm::dvec3 n = glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a);
        ASSERT_GT(glm::dot(n, n), 0.0);
    }
}

TEST(OwnScenes, ofFeaturesAreReadWithoutWarnings) {
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(CLEAVE_SOURCE) / "scenes" / "features")) {
        SCOPED_TRACE(entry.path().filename());
        const Scene scene = loadGltf(entry.path());
        EXPECT_TRUE(scene.warnings.empty());
        const PosedScene start = posed(scene);
        EXPECT_TRUE(start.warnings.empty());
        EXPECT_FALSE(start.triangles.empty());
        ASSERT_EQ(start.cameras.size(), 1u);
        EXPECT_EQ(start.cameras[0].name, "main");
        ++files;
    }
    EXPECT_EQ(files, 13u);
}

}  // namespace
}  // namespace cleave::test
