#include "tree/open_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cleave {
namespace {

// A tetrahedron.
std::vector<Triangle> tetrahedron() {
    const vec3 v[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return {{v[0], v[2], v[1]}, {v[0], v[1], v[3]}, {v[1], v[2], v[3]}, {v[2], v[0], v[3]}};
}

TEST(OpenEdges, AreThoseOfAnOddNumberOfTriangles) {
    std::vector<Triangle> faces = tetrahedron();
    EXPECT_EQ(openEdges(faces), 0u);
    std::swap(faces[1].a, faces[1].b);
    EXPECT_EQ(openEdges(faces), 0u) << "it may face either way";
    faces[2].a = vec3(1.0f, -0.0f, 0.0f);
    EXPECT_EQ(openEdges(faces), 0u) << "-0 is 0";
    faces.push_back(faces[0]);
    EXPECT_EQ(openEdges(faces), 3u) << "a face twice";
    faces.resize(3);
    EXPECT_EQ(openEdges(faces), 3u) << "a hole";
    EXPECT_EQ(openEdges({}), 0u);
}

// Two of four faces meet in a vertex that splits an edge of a third: a flat triangle between closes it.
TEST(OpenEdges, CountThoseOfTrianglesWithoutArea) {
    std::vector<Triangle> faces = tetrahedron();
    const vec3 a = faces[0].c, b = faces[0].b, middle = 0.5f * (a + b);  // of the edge that faces 0 and 2 share
    faces[0] = {vec3(0.0f), b, middle};
    faces.push_back({vec3(0.0f), middle, a});
    EXPECT_EQ(openEdges(faces), 3u);
    faces.push_back({a, middle, b});
    EXPECT_EQ(openEdges(faces), 0u);
    faces.push_back({a, a, b});
    EXPECT_EQ(openEdges(faces), 0u) << "an edge there and back";
    faces[0].a.x = std::nanf("");
    EXPECT_EQ(openEdges(faces), 3u);
}

}  // namespace
}  // namespace cleave
