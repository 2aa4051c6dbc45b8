#include "shared/triangle.h"

#include <gtest/gtest.h>

#include <random>

namespace cleave {
namespace {

const Triangle kTriangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

Hit shot(const vec3& origin, const vec3& direction) { return intersectTriangle(origin, direction, kTriangle); }

void expectHit(const Hit& h, float t, float u, float v) {
    EXPECT_EQ(h.t, t);
    EXPECT_EQ(h.u, u);
    EXPECT_EQ(h.v, v);
}

TEST(Triangle, isHitInsideFromBothSides) {
    expectHit(shot({1, 1, 2}, {0, 0, -1}), 2, 0.25f, 0.25f);
    expectHit(shot({1, 1, -2}, {0, 0, 1}), 2, 0.25f, 0.25f);
    expectHit(shot({1, 1, 3}, {0, 0, -1.5f}), 2, 0.25f, 0.25f);
    expectHit(shot({2, 3, 1}, {-1, -1, -1}), 1, 0.25f, 0.5f);
}

TEST(Triangle, isHitBehindTheOriginForTheCallerToJudge) {
    expectHit(shot({1, 1, 2}, {0, 0, 1}), -2, 0.25f, 0.25f);
    expectHit(shot({1, 1, 0}, {0, 0, 1}), 0, 0.25f, 0.25f);
}

TEST(Triangle, includesEdgesAndVertices) {
    expectHit(shot({2, 0, 1}, {0, 0, -1}), 1, 0.5f, 0);
    expectHit(shot({0, 1, 1}, {0, 0, -1}), 1, 0, 0.25f);
    expectHit(shot({3, 1, 1}, {0, 0, -1}), 1, 0.75f, 0.25f);
    expectHit(shot({0, 0, 1}, {0, 0, -1}), 1, 0, 0);
    expectHit(shot({4, 0, 1}, {0, 0, -1}), 1, 1, 0);
    expectHit(shot({0, 4, 1}, {0, 0, -1}), 1, 0, 1);
}

TEST(Triangle, isMissedJustOutside) {
    for (const vec3& o :
         {vec3(2, -1e-6f, 1), vec3(-1e-6f, 1, 1), vec3(3, 1.000001f, 1), vec3(-1, -1, 1), vec3(5, 0, 1)})
        EXPECT_EQ(shot(o, {0, 0, -1}).t, infinity()) << o.x << " " << o.y;
}

TEST(Triangle, isMissedByParallelRays) {
    EXPECT_EQ(shot({1, 1, 1}, {1, 0.5f, 0}).t, infinity());
    EXPECT_EQ(shot({-1, 1, 0}, {1, 0, 0}).t, infinity()) << "in its plane, through it";
    EXPECT_EQ(shot({-1, 0, 0}, {1, 0, 0}).t, infinity()) << "in its plane, along an edge";
    EXPECT_EQ(shot({1, 1, 0}, {1, 0, 0}).t, infinity()) << "in its plane, from inside";
    const Triangle line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    EXPECT_EQ(intersectTriangle({0, 0, 1}, {1, 1, 0}, line).t, infinity()) << "no area";
}

TEST(Triangle, tiesGoToTheLowerNumber) {
    EXPECT_TRUE(isCloser({1, 5, 0, 0}, {2, 3, 0, 0}));
    EXPECT_TRUE(isCloser({1, 3, 0, 0}, {1, 5, 0, 0}));
    EXPECT_FALSE(isCloser({1, 5, 0, 0}, {1, 5, 0, 0}));
    EXPECT_FALSE(isCloser({1, 5, 0, 0}, {1, 3, 0, 0}));
    EXPECT_TRUE(isCloser({1, 5, 0, 0}, missedHit()));
}

// The judge: the same determinants with 113 bits.
using Wide = __float128;
struct WideVec {
    Wide x, y, z;
};
WideVec difference(const vec3& a, const vec3& b) {
    return {Wide(a.x) - Wide(b.x), Wide(a.y) - Wide(b.y), Wide(a.z) - Wide(b.z)};
}
Wide magnitude(Wide x) { return x < 0 ? -x : x; }
Wide dot(const WideVec& a, const WideVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
WideVec cross(const WideVec& a, const WideVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Judged {
    bool hits;     // edges included
    bool certain;  // the ray passes the edges at a distance that double resolves
    double t;
};
Judged judged(const vec3& o, const vec3& d, const Triangle& s) {
    const WideVec a = difference(s.a, o), b = difference(s.b, o), c = difference(s.c, o), w = difference(d, vec3(0));
    const Wide wa = dot(w, cross(b, c)), wb = dot(w, cross(c, a)), wc = dot(w, cross(a, b));
    const WideVec n = cross(difference(s.b, s.a), difference(s.c, s.a));
    const bool hits = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    const Wide closest = std::min(magnitude(wa), std::min(magnitude(wb), magnitude(wc)));
    const double reach = max(largestComponent(s.a - o), max(largestComponent(s.b - o), largestComponent(s.c - o)));
    const bool certain = closest > Wide(1e-13 * reach * reach);
    return {hits, certain, static_cast<double>(dot(n, a) / dot(n, w))};
}

vec3 anyVector(std::mt19937& random, float size) {
    std::uniform_real_distribution<float> unit(-size, size);
    return {unit(random), unit(random), unit(random)};
}

// Its largest component in [1, 2), as traversal has it; half of them along an axis or with few bits.
vec3 anyDirection(std::mt19937& random) {
    vec3 d = random() % 2 == 0 ? glm::round(anyVector(random, 1.49f)) : anyVector(random, 1.0f);
    const int k = static_cast<int>(random() % 3);
    d[k] = (d[k] < 0.0f ? -1.0f : 1.0f) + 0.5f * d[k];
    return d;
}

enum Part { kInside, kEdge, kVertex };

vec3 pointOf(const Triangle& t, Part part, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    if (part == kVertex) return random() % 2 == 0 ? t.b : t.c;
    const float u = unit(random), v = part == kEdge ? 0.0f : unit(random) * (1.0f - u);
    return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

TEST(Triangle, agreesWithWideArithmeticAtAllScales) {
    int hits = 0, misses = 0, filtered = 0, certain = 0;
    double worst = 0.0;
    for (uint seed = 0; seed < 60000; seed++) {
        std::mt19937 random(seed);
        const float size = std::ldexp(1.0f, -static_cast<int>(random() % 41));
        const vec3 place = random() % 2 == 0 ? vec3(0.0f) : anyVector(random, 8.0f * size);
        const Triangle t{place + anyVector(random, size), place + anyVector(random, size),
                         place + anyVector(random, size)};
        const vec3 d = anyDirection(random);
        const float way = min(1000.0f, size * std::ldexp(1.0f, static_cast<int>(random() % 50)));
        vec3 target = pointOf(t, static_cast<Part>(seed % 3), random);
        if (random() % 4 == 0) target += anyVector(random, size);
        const vec3 o = target - way * d;
        const Judged truth = judged(o, d, t);
        const bool clear = filterTriangle(o, d, t.a, t.b, t.c).misses;
        ASSERT_FALSE(clear && truth.hits) << "seed " << seed;
        const Hit h = intersectTriangle(o, d, t);
        (truth.hits ? hits : misses)++;
        filtered += clear ? 1 : 0;
        certain += truth.certain && truth.hits ? 1 : 0;
        ASSERT_TRUE(!truth.certain || truth.hits == (h.t != infinity())) << "seed " << seed;
        if (h.t == infinity()) continue;
        const double error = std::fabs(h.t - truth.t) / std::fabs(truth.t);
        ASSERT_LE(error, 0x1p-23) << "seed " << seed;
        worst = std::max(worst, error);
    }
    EXPECT_GT(hits, 15000);
    EXPECT_GT(misses, 5000);
    EXPECT_GT(filtered, 2000);
    EXPECT_GT(certain, 5000);
    EXPECT_GT(worst, 0.0);
    RecordProperty("worstError", std::to_string(worst * 0x1p24) + " units of 2^-24");
}

// What float arithmetic calls certain is so, and its interval holds the t that double arithmetic finds.
TEST(Triangle, filterNeverContradictsDouble) {
    int hits = 0, misses = 0, unsure = 0, narrow = 0, wide = 0;
    for (uint seed = 0; seed < 400000; seed++) {
        std::mt19937 random(seed);
        const bool extreme = seed % 8 == 0;
        const float size = std::ldexp(1.0f, -static_cast<int>(random() % (extreme ? 100 : 12)));
        const float reach = std::ldexp(size, static_cast<int>(random() % (extreme ? 30 : 6)));
        const vec3 place = anyVector(random, reach);
        const Triangle t{place + anyVector(random, size), place + anyVector(random, size),
                         place + anyVector(random, size)};
        const vec3 d = anyDirection(random);
        vec3 target = pointOf(t, static_cast<Part>(seed % 3), random);
        if (random() % 2 == 0) target += anyVector(random, size);
        const vec3 o = target - reach * anyVector(random, 1.0f).x * d;
        const FilteredHit f = filterTriangle(o, d, t.a, t.b, t.c);
        const Hit h = resolveTriangle(o, d, t.a, t.b, t.c);
        ASSERT_FALSE(f.misses && h.t != infinity()) << "seed " << seed;
        ASSERT_FALSE(f.hits && h.t == infinity()) << "seed " << seed;
        (f.misses ? misses : f.hits ? hits : unsure)++;
        if (h.t == infinity()) continue;
        ASSERT_LE(f.tLow, h.t) << "seed " << seed;
        ASSERT_GE(f.tHigh, h.t) << "seed " << seed;
        (f.tHigh - f.tLow <= 1e-3f * max(std::fabs(h.t), size) ? narrow : wide)++;
    }
    EXPECT_GT(hits, 50000);
    EXPECT_GT(misses, 50000);
    EXPECT_GT(unsure, 10000);
    EXPECT_GT(narrow, 50000);
    RecordProperty("wide", wide);
}

// The interval's bound is derived, not fitted: rays and triangles at which it is nearly taken up show that it has to be
// about so large.
TEST(Triangle, filterBoundIsNotIdle) {
    double most = 0.0;
    for (uint seed = 0; seed < 200000; seed++) {
        std::mt19937 random(seed);
        const Triangle t{anyVector(random, 1.0f), anyVector(random, 1.0f), anyVector(random, 1.0f)};
        const vec3 d = anyDirection(random);
        const vec3 o = pointOf(t, kInside, random) - 4.0f * d;
        const FilteredHit f = filterTriangle(o, d, t.a, t.b, t.c);
        const Hit h = resolveTriangle(o, d, t.a, t.b, t.c);
        if (!f.hits || h.t == infinity()) continue;
        const double middle = 0.5 * (double(f.tLow) + f.tHigh), half = 0.5 * (double(f.tHigh) - f.tLow);
        most = std::max(most, std::fabs(h.t - middle) / half);
    }
    EXPECT_GT(most, 0.02);
    EXPECT_LT(most, 1.0);
    RecordProperty("mostOfTheBound", std::to_string(most));
}

// A ray that starts at a vertex meets the triangle there, at 0 and not at a rounding error before or behind it. Found
// by random scenes: with the plane's height taken from the first vertex some were lost at tMin = 0.
TEST(Triangle, raysFromAVertexHitAtZero) {
    int hits = 0;
    for (uint seed = 0; seed < 20000; seed++) {
        std::mt19937 random(seed);
        const Triangle t{anyVector(random, 1.0f), anyVector(random, 1.0f), anyVector(random, 1.0f)};
        const vec3 d = anyDirection(random);
        for (const vec3& vertex : {t.a, t.b, t.c}) {
            const Hit h = intersectTriangle(vertex, d, t);
            if (h.t == infinity()) continue;
            hits++;
            ASSERT_EQ(h.t, 0.0f) << "seed " << seed;
        }
    }
    EXPECT_GT(hits, 1000);
}

bool sameSide(const Triangle& face, const vec3& p, const vec3& q) {
    const WideVec n = cross(difference(face.b, face.a), difference(face.c, face.a));
    return dot(n, difference(p, face.a)) * dot(n, difference(q, face.a)) > 0;
}

// From inside a tetrahedron no line gets out but through a face, ahead and behind.
void expectWatertight(Part part) {
    int shared = 0;
    for (uint seed = 0; seed < 20000; seed++) {
        std::mt19937 random(seed);
        const float size = std::ldexp(1.0f, -static_cast<int>(random() % 41));
        const vec3 place = random() % 2 == 0 ? vec3(0.0f) : anyVector(random, 1000.0f * size);
        vec3 v[4];
        for (vec3& p : v) p = place + anyVector(random, size);
        const Triangle faces[4] = {{v[0], v[1], v[2]}, {v[0], v[3], v[1]}, {v[1], v[3], v[2]}, {v[2], v[3], v[0]}};
        const vec3 o = 0.25f * (v[0] + v[1] + v[2] + v[3]);
        const bool inside = sameSide(faces[0], o, v[3]) && sameSide(faces[1], o, v[2]) && sameSide(faces[2], o, v[0]) &&
                            sameSide(faces[3], o, v[1]);
        if (!inside) continue;  // the tetrahedron is so flat that rounding put the origin outside
        const vec3 way = pointOf(faces[random() % 4], part, random) - o;
        const vec3 d = way * std::ldexp(1.0f, -std::ilogb(largestComponent(way)));
        int ahead = 0, behind = 0;
        for (const Triangle& face : faces) {
            const Hit h = intersectTriangle(o, d, face);
            if (h.t != infinity()) (h.t > 0.0f ? ahead : behind)++;
        }
        ASSERT_GE(ahead, 1) << "seed " << seed;
        ASSERT_GE(behind, 1) << "seed " << seed;
        shared += ahead > 1 ? 1 : 0;
    }
    EXPECT_TRUE(part != kVertex || shared > 1000) << "rays must meet vertices exactly, at times";
}

TEST(Triangle, facesAreWatertight) { expectWatertight(kInside); }
TEST(Triangle, edgesAreWatertight) { expectWatertight(kEdge); }
TEST(Triangle, verticesAreWatertight) { expectWatertight(kVertex); }

}  // namespace
}  // namespace cleave
