#include <cmath>

#include "stability/cases.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

using Triangles = std::vector<Triangle>;

// A solid, a grid and loose triangles: something of everything, about 1 across.
Triangles mixture(Random& random) {
    Triangles triangles = trianglesOf(moved(icosphere(2), dvec3(0.3), dvec3(0.4, 0.5, 0.6)));
    append(triangles, trianglesOf(moved(cube(4), dvec3(0.25), dvec3(0.25, 0.75, 0.25))));
    append(triangles, looseTriangles(random, 200, 0.1));
    return triangles;
}

Triangles placed(Triangles triangles, double factor, double offset) {
    for (Triangle& t : triangles)
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = vec3(dvec3(*v) * factor + dvec3(offset, -offset, offset));
    return triangles;
}

// 100 across, 10^exponent away: at 1e7 the floats are 1 apart, and everything lies on integers.
template <int exponent>
Triangles farAway(Random& random, bool) {
    return placed(mixture(random), 100.0, std::pow(10.0, exponent));
}
template <int exponent>
Triangles scaled(Random& random, bool) {
    return placed(mixture(random), std::pow(10.0, exponent), 0.0);
}

// A dense little thing somewhere in a large simple one.
Triangles teapotInStadium(Random&, bool) {
    Triangles triangles = trianglesOf(moved(cube(6), dvec3(1.0, 0.3, 1.0), dvec3(0.0)));
    append(triangles, trianglesOf(moved(torusKnot(60, 8), dvec3(1e-6), dvec3(0.3, -0.1, 0.2))));
    return triangles;
}

// A mixture about the origin and the same, 10^exponent times smaller, beside its middle.
template <int exponent>
Triangles farApart(Random& random, bool) {
    Triangles triangles = placed(mixture(random), 1.0, -0.5);
    append(triangles, placed(placed(mixture(random), 1.0, -0.5), std::pow(10.0, -exponent), 0.0));
    return triangles;
}

// Triangles at powers of two, each half of the one before it, towards both sides of the origin: halving cells never
// parts them, and coordinates go down to 2^-100.
Triangles powers(Random& random, bool) {
    Triangles triangles;
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 3; ++k) {
            const double s = std::ldexp(1.0, -i) * random.sign();
            dvec3 a(s), b(s), c(s);
            a[k] *= 2.0;
            b[(k + 1) % 3] *= 2.0;
            c[(k + 2) % 3] *= 2.0;
            triangles.push_back({vec3(a), vec3(b), vec3(c)});
        }
    return triangles;
}

constexpr StabilityCase kCases[] = {
    {"offset-1e5", "100 across, at a distance of 1e5", farAway<5>},
    {"offset-1e6", "at a distance of 1e6", farAway<6>},
    {"offset-1e7", "at a distance of 1e7", farAway<7>},
    {"scale-1e-36", "1e-36 across, just above denormals", scaled<-36>},
    {"scale-1e-30", "1e-30 across", scaled<-30>},
    {"scale-1e-7", "1e-7 across", scaled<-7>},
    {"scale-1e7", "1e7 across", scaled<7>},
    {"scale-1e18", "1e18 across", scaled<18>},
    {"scale-1e37", "1e37 across, just below infinity", scaled<37>},
    {"teapot-in-stadium", "a knot a million times smaller than the room", teapotInStadium},
    {"scales-1e12", "two scales 1e12 apart", farApart<12>},
    {"scales-1e24", "two scales 1e24 apart", farApart<24>},
    {"powers", "triangles halving 100 times towards the origin", powers},
};

}  // namespace

std::span<const StabilityCase> scaleCases() { return kCases; }

}  // namespace cleave
