#include <cmath>

#include "stability/cases.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

using Triangles = std::vector<Triangle>;

Triangles loose(Random& random, bool quick) { return looseTriangles(random, quick ? 2000 : 20000, 0.03); }
Triangles sphere(Random&, bool quick) { return trianglesOf(icosphere(quick ? 4 : 6)); }
Triangles knot(Random&, bool quick) { return trianglesOf(quick ? torusKnot(150, 12) : torusKnot(1200, 32)); }

// One triangle over a sheet of bumps; a million of them in a full run.
Triangles hugeOverTiny(Random& random, bool quick) {
    Triangles triangles = trianglesOf(
        moved(sheet(quick ? 100 : 707), [&](const dvec3& v) { return dvec3(v.x, 1e-3 * random.unit(), v.z); }));
    triangles.push_back({{-3, 0.0005f, -3}, {5, 0.0007f, -3}, {-3, 0.002f, 5}});
    return triangles;
}

// Bundles of long triangles that all cross in one small place: no plane parts them, and cells shrink to nothing.
Triangles crossing(Random& random, bool) {
    Triangles triangles;
    for (int i = 0; i < 600; ++i) {
        const dvec3 way = glm::normalize(random.direction() + dvec3(1e-3)), middle = 1e-5 * random.direction();
        const dvec3 wide = 1e-3 * random.direction();
        triangles.push_back({vec3(middle - way), vec3(middle + way), vec3(middle + way + wide)});
    }
    return triangles;
}

// Crowds in crowds, each a 60th of the one around it, at a corner of it: SAH splits are used up long before the
// triangles are parted.
Triangles depthCap(Random& random, bool) {
    Triangles triangles;
    double size = 1.0;
    for (int level = 0; level < 16; ++level, size /= 60.0)
        for (Triangle t : looseTriangles(random, 12, 0.3)) {
            for (vec3* v : {&t.a, &t.b, &t.c}) *v = vec3(dvec3(*v) * size);
            triangles.push_back(t);
        }
    return triangles;
}

constexpr StabilityCase kCases[] = {
    {"loose", "small triangles, evenly spread", loose},
    {"sphere", "a closed sphere", sphere},
    {"knot", "a closed tube around a torus knot", knot},
    {"huge-over-tiny", "one triangle over a sheet of tiny ones", hugeOverTiny},
    {"crossing", "600 long triangles that cross in one place", crossing},
    {"depth-cap", "crowds within crowds, to the tree's depth cap", depthCap},
};

}  // namespace

std::span<const StabilityCase> denseCases() { return kCases; }

}  // namespace cleave
