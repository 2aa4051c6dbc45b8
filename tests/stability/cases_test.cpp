// The cases are what they say, the same for the same seed, and the closed meshes are closed.
#include "stability/cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "stability/closed_meshes.h"
#include "stability/shapes.h"
#include "tree/triangle_set.h"

namespace cleave {
namespace {

constexpr uint64_t kSeed = 1;

std::vector<Triangle> made(std::string_view name, uint64_t seed = kSeed) {
    for (const StabilityCase& c : stabilityCases())
        if (c.name == name) {
            Random random(seedFor(seed, name));
            return c.make(random, true);
        }
    ADD_FAILURE() << "no case " << name;
    return {};
}

bool isSame(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Triangle)) == 0;
}

TEST(StabilityCases, HaveNamesOfTheirOwnAndDependOnTheSeedOnly) {
    std::set<std::string_view> names;
    for (const StabilityCase& c : stabilityCases()) {
        SCOPED_TRACE(c.name);
        EXPECT_TRUE(names.insert(c.name).second);
        EXPECT_TRUE(isSame(made(c.name), made(c.name)));
    }
    EXPECT_GE(names.size(), 49u);
    EXPECT_FALSE(isSame(made("loose"), made("loose", 2)));
}

TEST(StabilityCases, LeaveOutWhatTheySay) {
    const auto set = [](std::string_view name) { return makeTriangleSet(made(name)); };
    EXPECT_TRUE(set("empty").triangles.empty());
    EXPECT_EQ(set("degenerate").noArea, 100u);
    EXPECT_EQ(set("degenerate").included.size(), 0u);
    EXPECT_EQ(set("nan").nonFinite, 3u);
    EXPECT_EQ(set("infinite").nonFinite, 3u);
    EXPECT_EQ(set("infinite").included.size(), 197u);
    EXPECT_EQ(set("degenerate-among").included.size(), 200u);
    for (const StabilityCase& c : stabilityCases()) {
        if (c.name == "empty" || c.name == "degenerate") continue;
        EXPECT_GT(set(c.name).included.size(), 0u) << c.name;
    }
}

TEST(StabilityCases, HaveTheExtentsTheySay) {
    for (const auto& [name, axis] : {std::pair("flat-x", 0), {"flat-y", 1}, {"flat-z", 2}})
        for (const Triangle& t : made(name)) {
            EXPECT_EQ(t.a[axis], 0.3f);
            EXPECT_EQ(t.b[axis], 0.3f);
            EXPECT_EQ(t.c[axis], 0.3f);
        }
    for (const Triangle& t : made("offset-1e7")) EXPECT_EQ(t.a, glm::round(t.a)) << "floats are whole there";
    for (const Triangle& t : made("integer-soup")) EXPECT_EQ(t.b, glm::round(t.b));
    for (const auto& [name, exponent] : {std::pair("scale-1e-30", -30), {"scale-1e18", 18}, {"scale-1e37", 37}}) {
        float largest = 0.0f;
        for (const Triangle& t : made(name)) largest = std::max(largest, largestComponent(t.a));
        EXPECT_EQ(std::lround(std::log10(largest)), exponent) << name;
    }
}

TEST(StabilityCases, NeedlesAreAsThinAsTheySay) {
    for (const auto& [name, ratio] : {std::pair("needles-1e6", 1e6), {"needles-1e7", 1e7}}) {
        int thin = 0;
        for (const Triangle& t : made(name)) {
            const double length = glm::length(dvec3(t.c) - dvec3(t.a)), width = glm::length(dvec3(t.b) - dvec3(t.a));
            // Rounding to float moves vertices by 1e-7: what is thinner is as thin as floats can say.
            EXPECT_LE(width, length / ratio + 2e-7);
            thin += width < 3e-6 * length ? 1 : 0;
        }
        EXPECT_GT(thin, 250) << name;
    }
}

TEST(StabilityCases, ClusterToTheDepthCap) {
    float smallest = 1.0f;
    for (const Triangle& t : made("powers")) smallest = std::min(smallest, std::fabs(t.a.x));
    EXPECT_EQ(smallest, 0x1p-99f);
}

// Edges as pairs of vertices, by their floats; each must belong to two faces.
void expectClosed(const std::vector<Triangle>& triangles) {
    using Point = std::array<float, 3>;
    const auto point = [](const vec3& v) { return Point{v.x, v.y, v.z}; };
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& t : triangles) {
        const Point p[3] = {point(t.a), point(t.b), point(t.c)};
        for (int i = 0; i < 3; ++i) {
            ASSERT_NE(p[i], p[(i + 1) % 3]) << "a face without area";
            ++edges[std::minmax(p[i], p[(i + 1) % 3])];
        }
    }
    for (const auto& [edge, faces] : edges) ASSERT_EQ(faces, 2);
}

// The solid angle under which a closed mesh is seen, over 4 pi: 0 from outside, else how often it winds around the
// point (van Oosterom and Strackee 1983). In units of the mesh, or extreme scales leave the range of double.
double windingNumber(const std::vector<Triangle>& triangles, const vec3& from, double unit) {
    double sum = 0.0;
    for (const Triangle& t : triangles) {
        const dvec3 a = (dvec3(t.a) - dvec3(from)) / unit, b = (dvec3(t.b) - dvec3(from)) / unit,
                    c = (dvec3(t.c) - dvec3(from)) / unit;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double height = glm::dot(a, glm::cross(b, c));
        sum += 2.0 * std::atan2(height, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (4.0 * std::acos(-1.0));
}

TEST(ClosedMeshes, AreClosedAroundTheirPoints) {
    for (const ClosedMesh& mesh : closedMeshes(kSeed)) {
        SCOPED_TRACE(mesh.name);
        expectClosed(mesh.triangles);
        EXPECT_EQ(makeTriangleSet(mesh.triangles).included.size(), mesh.triangles.size());
        double unit = 0.0;
        for (const Triangle& t : mesh.triangles) unit = std::max(unit, double{largestComponent(t.a)});
        EXPECT_EQ(mesh.inside.size(), 64u);
        for (const vec3& p : mesh.inside) ASSERT_NEAR(std::fabs(windingNumber(mesh.triangles, p, unit)), 1.0, 1e-3);
    }
}
TEST(ClosedMeshes, AnOpenOneIsFoundOut) {
    ClosedMesh mesh = closedMeshes(kSeed).front();
    EXPECT_NEAR(std::fabs(windingNumber(mesh.triangles, mesh.inside[0], 1.0)), 1.0, 1e-3);
    EXPECT_NEAR(windingNumber(mesh.triangles, vec3(7.0f), 1.0), 0.0, 1e-3);
    mesh.triangles.pop_back();
    EXPECT_LT(std::fabs(windingNumber(mesh.triangles, mesh.inside[0], 1.0)), 0.99);
}

TEST(ClosedMeshes, AreAimedAtVerticesAndEdges) {
    for (const ClosedMesh& mesh : closedMeshes(kSeed)) {
        std::set<std::array<float, 3>> vertices;
        for (const Triangle& t : mesh.triangles)
            for (const vec3& v : {t.a, t.b}) vertices.insert({v.x, v.y, v.z});
        const std::vector<Ray> rays = leakRays(mesh, 1000, kSeed);
        ASSERT_EQ(rays.size(), 1000u);
        size_t exact = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(isValidRay(rays[i]));
            const vec3 end = rays[i].origin + rays[i].direction;
            exact += vertices.contains({end.x, end.y, end.z}) ? 1 : 0;
        }
        EXPECT_GT(exact, 100u) << mesh.name << ": ways to a vertex that rounding left as they are";
    }
}

}  // namespace
}  // namespace cleave
