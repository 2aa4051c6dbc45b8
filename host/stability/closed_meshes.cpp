#include "stability/closed_meshes.h"

#include <cmath>
#include <functional>
#include <limits>

#include "stability/shapes.h"

namespace cleave {
namespace {

constexpr int kInside = 64;  // points per mesh

std::vector<vec3> points(const std::function<dvec3(int)>& point) {
    std::vector<vec3> inside;
    for (int i = 0; i < kInside; ++i) inside.push_back(vec3(point(i)));
    return inside;
}

// A sphere that is moved: points move with it. Half its radius is far inside of every face.
ClosedMesh ball(std::string_view name, uint32_t level, Random& random, const dvec3& radius, const dvec3& centre) {
    return {name, trianglesOf(moved(icosphere(level), radius, centre)),
            points([&](int) { return centre + 0.25 * random.direction() * radius; })};
}

// Vertices pushed in and out at random: needles all over, seen from the middle.
ClosedMesh star(Random& random) {
    const Mesh mesh = moved(icosphere(4), [&](const dvec3& v) { return v * random.between(0.3, 1.0); });
    return {"star", trianglesOf(mesh), points([&](int) { return 0.005 * random.direction(); })};
}

ClosedMesh knot(Random& random) {
    constexpr uint32_t kRings = 400;
    return {"knot", trianglesOf(torusKnot(kRings, 16)),
            points([&](int) { return knotCentre(random.below(kRings), kRings) + 0.05 * random.direction(); })};
}

// All coordinates are multiples of 1/8: rays pass exactly through vertices and along the planes of the tree.
ClosedMesh lattice(Random& random) {
    const auto step = [&] { return 0.125 * random.below(15) - 0.875; };
    return {"lattice", trianglesOf(cube(8)), points([&](int) {
                const double x = step(), y = step();
                return dvec3(x, y, step());
            })};
}

ClosedMesh fans(Random& random) {
    return {"fans", trianglesOf(fanCube(32)), points([&](int) { return 0.9 * random.direction(); })};
}

vec3 aimOf(const Triangle& t, uint64_t kind, Random& random) {
    if (kind < 2) return random.below(2) == 0 ? t.a : t.b;
    const double u = random.unit(), v = kind == 2 ? 0.0 : random.unit() * (1.0 - u);
    return vec3(dvec3(t.a) + u * (dvec3(t.b) - dvec3(t.a)) + v * (dvec3(t.c) - dvec3(t.a)));
}

ClosedMesh onLattice(std::string_view name, uint32_t level, double steps, Random& random) {
    const dvec3 size(random.between(0.5, 1.0), random.between(0.5, 1.0), random.between(0.5, 1.0));
    const Mesh mesh = moved(icosphere(level), [&](const dvec3& v) { return glm::round(v * size * steps) / steps; });
    return {name, trianglesOf(mesh), {}};
}

// The box's half diagonal and its middle.
struct Extent {
    dvec3 middle;
    double reach;
};
Extent extentOf(const ClosedMesh& mesh) {
    dvec3 lo(std::numeric_limits<double>::infinity()), hi = -lo;
    for (const Triangle& t : mesh.triangles)
        for (const vec3& v : {t.a, t.b, t.c}) {
            lo = glm::min(lo, dvec3(v));
            hi = glm::max(hi, dvec3(v));
        }
    return {0.5 * (lo + hi), 0.5 * glm::length(hi - lo)};
}

}  // namespace

std::vector<ClosedMesh> closedSlivers(uint64_t seed) {
    Random random(seedFor(seed, "slivers"));
    std::vector<ClosedMesh> meshes;
    meshes.push_back(onLattice("lattice-8", 3, 8.0, random));
    meshes.push_back(onLattice("lattice-32", 5, 32.0, random));
    return meshes;
}

std::vector<Ray> linesThrough(const ClosedMesh& mesh, uint64_t count, uint64_t seed) {
    Random random(seed);
    const Extent extent = extentOf(mesh);
    const auto any = [&] { return mesh.triangles[random.below(mesh.triangles.size())]; };
    std::vector<Ray> lines;
    lines.reserve(count);
    while (lines.size() < count) {
        const vec3 at = aimOf(any(), lines.size() % 4, random);
        dvec3 along = random.direction();
        if (lines.size() / 4 % 4 == 1) {
            along = dvec3(0.0);
            along[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -1.0;
        }
        if (lines.size() / 4 % 4 == 2) along = dvec3(any().a) - dvec3(at);
        const double length = glm::length(along);
        if (!(length > 0.0)) continue;
        // Rounded once, the line still passes the vertex exactly where it is along an axis or on a coarse lattice.
        const vec3 direction(along);
        const double way = (3.0 * extent.reach + glm::length(dvec3(at) - extent.middle)) / length;
        const vec3 from(dvec3(at) - std::exp2(std::ceil(std::log2(way))) * dvec3(direction));
        lines.push_back({from, 0.0f, direction, infinity()});
    }
    return lines;
}

void addParity(Parity& parity, std::span<const Ray> lines, std::span<const int32_t> counts) {
    for (size_t i = 0; i < lines.size(); ++i) {
        if (counts[i] == 0) continue;
        parity.odd += (counts[i] & 1) != 0 ? 1 : 0;
        if (parity.uneven++ == 0) parity.first = lines[i];
    }
    parity.lines += lines.size();
}

std::vector<ClosedMesh> closedMeshes(uint64_t seed) {
    Random random(seed);
    std::vector<ClosedMesh> meshes;
    meshes.push_back(ball("icosahedron", 0, random, dvec3(1.0), dvec3(0.0)));
    meshes.push_back(ball("sphere", 5, random, dvec3(1.0), dvec3(0.3, -0.2, 0.1)));
    meshes.push_back(ball("needle", 4, random, dvec3(1.0, 1e-3, 1e-6), dvec3(0.0)));
    meshes.push_back(ball("offset-1e6", 3, random, dvec3(100.0), dvec3(1e6, -1e6, 1e6)));
    meshes.push_back(ball("scale-1e-30", 3, random, dvec3(1e-30), dvec3(1e-30)));
    meshes.push_back(ball("scale-1e18", 3, random, dvec3(1e18), dvec3(-1e18)));
    meshes.push_back(star(random));
    meshes.push_back(knot(random));
    meshes.push_back(lattice(random));
    meshes.push_back(fans(random));
    return meshes;
}

std::vector<Ray> leakRays(const ClosedMesh& mesh, uint64_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        const vec3& from = mesh.inside[random.below(mesh.inside.size())];
        const vec3 to = aimOf(mesh.triangles[random.below(mesh.triangles.size())], rays.size() % 4, random);
        rays.push_back({from, 0.0f, to - from, infinity()});
    }
    return rays;
}

void countLeaks(Leaks& leaks, std::span<const Ray> rays, std::span<const Hit> hits) {
    for (size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].prim != kNone) continue;
        if (leaks.leaks++ == 0) leaks.first = rays[i];
    }
    leaks.rays += rays.size();
}

}  // namespace cleave
