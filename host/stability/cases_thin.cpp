#include <cmath>
#include <numbers>

#include "stability/cases.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

using Triangles = std::vector<Triangle>;

// Long triangles of the given length to width.
Triangles needles(Random& random, uint32_t count, double ratio) {
    Triangles triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const dvec3 a = random.inBox(dvec3(0.0), dvec3(1.0)), b = random.inBox(dvec3(0.0), dvec3(1.0));
        const dvec3 side = glm::cross(b - a, random.direction());
        const dvec3 wide = side * (glm::length(b - a) / ratio / std::max(glm::length(side), 1e-3));
        triangles.push_back({vec3(a), vec3(a + wide), vec3(b)});
    }
    return triangles;
}
Triangles needles6(Random& random, bool) { return needles(random, 300, 1e6); }
Triangles needles7(Random& random, bool) { return needles(random, 300, 1e7); }

// Strands of a few thin quads, all rooted in one ball.
Triangles hair(Random& random, bool quick) {
    Triangles triangles;
    for (int strand = 0; strand < (quick ? 150 : 1500); ++strand) {
        const dvec3 out = glm::normalize(random.direction() + dvec3(0.0, 0.1, 0.0));
        const dvec3 wide = 2e-4 * glm::normalize(glm::cross(out, dvec3(0.3, 1.0, 0.2)));
        dvec3 from = out;
        for (int i = 1; i <= 6; ++i) {
            const dvec3 to = out * (1.0 + 0.2 * i) + dvec3(0.0, -0.02 * i * i, 0.0);
            append(triangles,
                   {{vec3(from), vec3(from + wide), vec3(to + wide)}, {vec3(from), vec3(to + wide), vec3(to)}});
            from = to;
        }
    }
    return triangles;
}

// Blades on a flat ground: tall, narrow, all with a vertex or two in the plane y = 0.
Triangles grass(Random& random, bool quick) {
    Triangles triangles = trianglesOf(moved(sheet(4), dvec3(10.0), dvec3(0.0)));
    for (int i = 0; i < (quick ? 1000 : 10000); ++i) {
        const dvec3 root(random.between(-10.0, 10.0), 0.0, random.between(-10.0, 10.0));
        const dvec3 wide(random.between(-0.02, 0.02), 0.0, random.between(-0.02, 0.02));
        const dvec3 tip = root + dvec3(random.between(-0.2, 0.2), random.between(0.3, 1.0), random.between(-0.2, 0.2));
        triangles.push_back({vec3(root), vec3(root + wide), vec3(tip)});
    }
    return triangles;
}

// Ten thousand triangles that share a vertex, like an umbrella.
Triangles fan(Random&, bool quick) {
    Triangles triangles;
    const int count = quick ? 2000 : 10000;
    const auto rim = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * (i % count) / count;
        return vec3(dvec3(std::cos(angle), 0.3 + 0.05 * std::cos(5.0 * angle), std::sin(angle)));
    };
    for (int i = 0; i < count; ++i) triangles.push_back({vec3(0.1f, 0.7f, -0.2f), rim(i), rim(i + 1)});
    return triangles;
}

Triangles shells(Random&, bool) {
    Triangles triangles;
    for (int i = 0; i < 8; ++i) append(triangles, trianglesOf(moved(icosphere(2), dvec3(1.0 + 1e-7 * i), dvec3(0.0))));
    return triangles;
}

// A sheet of which each square is cut into slivers by vertices on its rim: T-junctions, angles below a degree.
Triangles slivers(Random& random, bool) {
    Triangles triangles;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            const dvec3 at(i, 0.3 * random.unit(), j);
            for (int k = 0; k < 16; ++k)
                triangles.push_back(
                    {vec3(at), vec3(at + dvec3(1.0, 0.0, k / 16.0)), vec3(at + dvec3(1.0, 0.0, (k + 1) / 16.0))});
            triangles.push_back({vec3(at), vec3(at + dvec3(1, 0, 1)), vec3(at + dvec3(0, 0, 1))});
        }
    return triangles;
}

constexpr StabilityCase kCases[] = {
    {"needles-1e6", "triangles a million times as long as wide", needles6},
    {"needles-1e7", "ten million times", needles7},
    {"hair", "thin strands on a ball", hair},
    {"grass", "narrow blades on a flat ground", grass},
    {"fan", "thousands of triangles at one vertex", fan},
    {"shells", "eight spheres inside each other, 1e-7 apart", shells},
    {"slivers", "squares cut into slivers, with T-junctions", slivers},
};

}  // namespace

std::span<const StabilityCase> thinCases() { return kCases; }

}  // namespace cleave
