#include "stability/cases.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

using Triangles = std::vector<Triangle>;

// A sheet halfway between two equal crowds: the best plane is the sheet's own.
Triangles sheetInThePlane(Random& random, bool) {
    Triangles triangles = trianglesOf(sheet(8));
    const Triangles crowd = looseTriangles(random, 150, 0.1);
    for (const float side : {0.5f, -1.5f}) {
        for (Triangle t : crowd) {
            for (vec3* v : {&t.a, &t.b, &t.c}) *v = *v * vec3(2, 1, 2) + vec3(-1, side, -1);
            triangles.push_back(t);
        }
    }
    return triangles;
}

Triangles stack(Random&, bool) {
    Triangles triangles;
    for (int i = 0; i < 1000; ++i)
        append(triangles, trianglesOf(moved(sheet(1), dvec3(1.0), dvec3(0.0, 0.001 * i, 0.0))));
    return triangles;
}

// A thousand sheets in one and the same plane: no plane parts them.
Triangles coplanarStack(Random&, bool) {
    Triangles triangles;
    for (int i = 0; i < 250; ++i)
        append(triangles, trianglesOf(moved(sheet(1), dvec3(1.0 + i % 7), dvec3(i % 11, 2.0, i % 5))));
    return triangles;
}

Triangles stairs(Random&, bool) {
    Triangles triangles;
    for (int i = 0; i < 64; ++i) {
        const auto x = static_cast<float>(i), y = x, w = 8.0f;
        append(triangles, {{{x, y, 0}, {x + 1, y, 0}, {x + 1, y, w}}, {{x, y, 0}, {x + 1, y, w}, {x, y, w}}});
        append(triangles, {{{x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, w}},
                           {{x + 1, y, 0}, {x + 1, y + 1, w}, {x + 1, y, w}}});
    }
    return triangles;
}

// Walls on all integer planes of a box: every split plane is full of edges, every kd-corner a vertex.
Triangles integerGrid(Random&, bool) {
    Triangles triangles;
    constexpr int kSide = 5;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < kSide * kSide * kSide; ++i) {
            const vec3 at(i % kSide, i / kSide % kSide, i / (kSide * kSide));
            vec3 e1(0.0f), e2(0.0f);
            e1[(axis + 1) % 3] = e2[(axis + 2) % 3] = 1.0f;
            append(triangles, {{at, at + e1, at + e1 + e2}, {at, at + e1 + e2, at + e2}});
        }
    return triangles;
}

Triangles integerSoup(Random& random, bool) {
    Triangles triangles;
    const auto vertex = [&] { return vec3(random.below(9), random.below(9), random.below(9)); };
    for (int i = 0; i < 400; ++i) {
        const vec3 a = vertex(), b = vertex();
        triangles.push_back({a, b, vertex()});
    }
    return triangles;
}

// Cubes side by side on integers: faces coincide, with windings and diagonals of their own.
Triangles boxes(Random& random, bool) {
    Triangles triangles;
    for (int i = 0; i < 60; ++i) {
        const dvec3 at(random.below(5), random.below(5), random.below(5));
        append(triangles, trianglesOf(moved(cube(1), dvec3(0.5 * (1 + i % 2)), at)));
    }
    return triangles;
}

template <int axis>
Triangles flat(Random& random, bool) {
    Triangles triangles = looseTriangles(random, 300, 0.15);
    for (Triangle& t : triangles) t.a[axis] = t.b[axis] = t.c[axis] = 0.3f;
    return triangles;
}

// Flat across no axis: the boxes have volume, the scene has none.
Triangles slanted(Random&, bool) {
    return trianglesOf(moved(sheet(16), [](const dvec3& v) { return dvec3(v.x, 0.5 * v.x + 0.25 * v.z, v.z); }));
}

// Extents of an ulp or two along two axes: as close to a line as triangles with an area can be.
Triangles line(Random& random, bool) {
    Triangles triangles;
    constexpr float kUlp = 0x1p-23f;
    for (int i = 0; i < 200; ++i) {
        const auto x = static_cast<float>(random.between(0.0, 10.0));
        const auto step = [&] { return 1.0f + kUlp * static_cast<float>(random.below(3)); };
        const vec3 a(x, step(), step()), b(x + 0.1f, step(), step());
        triangles.push_back({a, b, vec3(x + 0.05f, step(), step())});
    }
    return triangles;
}

constexpr StabilityCase kCases[] = {
    {"sheet-in-plane", "a sheet in the plane that would split it", sheetInThePlane},
    {"stack", "1000 parallel sheets", stack},
    {"coplanar", "250 overlapping squares in one plane", coplanarStack},
    {"stairs", "64 steps", stairs},
    {"integer-grid", "walls on all integer planes of a box", integerGrid},
    {"integer-soup", "400 triangles with whole coordinates below 9", integerSoup},
    {"boxes", "60 cubes on integers, many faces twice", boxes},
    {"flat-x", "all triangles in one plane across x", flat<0>},
    {"flat-y", "all triangles in one plane across y", flat<1>},
    {"flat-z", "all triangles in one plane across z", flat<2>},
    {"slanted", "all triangles in one slanted plane", slanted},
    {"line", "two axes of an ulp or two", line},
};

}  // namespace

std::span<const StabilityCase> planarCases() { return kCases; }

}  // namespace cleave
