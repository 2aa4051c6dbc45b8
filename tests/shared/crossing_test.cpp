// The rule "once" against exact integers, over closed surfaces; what each of its parts is for; and against the
// reference, on floats of all kinds.
#include "shared/crossing.h"

#include <gtest/gtest.h>

#include "judge/crossings.h"
#include "support/closed_surfaces.h"
#include "tree/exact_sum.h"

namespace cleave {
namespace {

struct Whole {
    int64_t x, y, z;
    int64_t operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
Whole whole(const vec3& v) { return {static_cast<int64_t>(v.x), static_cast<int64_t>(v.y), static_cast<int64_t>(v.z)}; }
int signOf(int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// The rule in integers, and ways to get it wrong.
enum class Rule { once, inclusive, exclusive, first, second, size };

int edgeSign(Rule rule, int64_t ax, int64_t ay, int64_t bx, int64_t by) {
    const int side = signOf(ax * by - ay * bx);
    if (side != 0 || rule == Rule::inclusive || rule == Rule::exclusive) return side;
    if (rule == Rule::second) return signOf(bx - ax);
    const int first = rule == Rule::size ? signOf((by - ay) * (by - ay)) : -signOf(by - ay);
    if (first != 0 || rule == Rule::first) return first;
    return signOf(bx - ax);
}

// 1 if the line leaves there, -1 if it enters, 0 if it misses.
int crossesInIntegers(Rule rule, const Ray& ray, const Triangle& t) {
    const Whole o = whole(ray.origin), d = whole(ray.direction);
    const vec3& f = ray.direction;
    int k = std::fabs(f.x) >= std::fabs(f.y) ? 0 : 1;
    if (std::fabs(f.z) > std::fabs(f[k])) k = 2;
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    int64_t x[3], y[3];
    const Whole vertices[3] = {whole(t.a), whole(t.b), whole(t.c)};
    for (int n = 0; n < 3; ++n) {
        x[n] = (vertices[n][i] - o[i]) * d[k] - (vertices[n][k] - o[k]) * d[i];
        y[n] = (vertices[n][j] - o[j]) * d[k] - (vertices[n][k] - o[k]) * d[j];
    }
    bool positive = true, negative = true, any = false;
    for (int n = 0; n < 3; ++n) {
        const int m = (n + 1) % 3, sign = edgeSign(rule, x[n], y[n], x[m], y[m]);
        const bool in = sign == 0 && rule == Rule::inclusive;
        positive = positive && (sign > 0 || in);
        negative = negative && (sign < 0 || in);
        any = any || sign != 0;
    }
    if (!any || positive == negative) return 0;
    return (positive ? 1 : -1) * (d[k] > 0 ? 1 : -1);
}

vec3 latticePoint(test::Random& random, int side) {
    const auto at = [&] {
        return static_cast<float>(random.below(static_cast<uint32_t>(2 * side + 1))) - static_cast<float>(side);
    };
    const float x = at(), y = at();
    return vec3(x, y, at());
}

// Lines through two points of the lattice, vertices among them, and along its axes.
Ray latticeLine(const std::vector<Triangle>& surface, test::Random& random, int side) {
    const auto vertex = [&] { return surface[random.below(static_cast<uint32_t>(surface.size()))].b; };
    vec3 from = latticePoint(random, 2 * side), to = vertex();
    if (random.below(3) == 0) {
        from = to;
        from[static_cast<int>(random.below(3))] += 1.0f;
    } else if (random.below(2) == 0) {
        from = vertex();
    }
    if (from == to) from.y += 1.0f;
    return {from, 0.0f, to - from, infinity()};
}

int sharedSide(const Ray& ray, const Triangle& t) {
    if (filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c).misses) return 0;
    return crossTriangle(ray.origin, ray.direction, t.a, t.b, t.c).side;
}

// As a tree has them: scaled by a power of two.
Ray scaledBy(const Ray& ray, int e) {
    const ScaledRay s = scaledRay(ray, e);
    return {s.origin, s.tMin, s.direction, s.tMax};
}

constexpr int kSide = 6;
constexpr int kScale = 4;

TEST(Crossing, equalsIntegersAndIsEvenOverClosedSurfaces) {
    int crossed = 0, grazed = 0;
    for (uint32_t seed = 0; seed < 400; ++seed) {
        const std::vector<Triangle> surface = test::latticeBlob(seed, 1 + static_cast<int>(seed % 4), kSide);
        test::Random random(seed);
        for (int i = 0; i < 120; ++i) {
            const Ray line = latticeLine(surface, random, kSide), scaled = scaledBy(line, kScale);
            int count = 0, sum = 0;
            for (const Triangle& t : surface) {
                const int want = crossesInIntegers(Rule::once, line, t);
                const float s = std::ldexp(1.0f, -kScale);
                ASSERT_EQ(sharedSide(scaled, {t.a * s, t.b * s, t.c * s}), want) << "seed " << seed << ", line " << i;
                ASSERT_EQ(crossesOnce(line, t), want) << "the reference; seed " << seed << ", line " << i;
                grazed += want == 0 && crossesInIntegers(Rule::inclusive, line, t) != 0 ? 1 : 0;
                count += want != 0 ? 1 : 0;
                sum += want;
            }
            ASSERT_EQ(count % 2, 0) << "seed " << seed << ", line " << i;
            ASSERT_EQ(sum, 0) << "seed " << seed << ", line " << i;
            crossed += count;
        }
    }
    EXPECT_GT(crossed, 50000);
    EXPECT_GT(grazed, 20000);
}

// Without one of its parts the rule counts odd. (With another sign of e or of e^2 it is another rule, as good; that the
// shared function is this one is seen above.)
TEST(Crossing, needsEachPartOfTheRule) {
    for (const Rule rule : {Rule::inclusive, Rule::exclusive, Rule::first, Rule::second, Rule::size}) {
        int odd = 0;
        for (uint32_t seed = 0; seed < 100; ++seed) {
            const std::vector<Triangle> surface = test::latticeBlob(seed, 1 + static_cast<int>(seed % 4), kSide);
            test::Random random(seed);
            for (int i = 0; i < 60; ++i) {
                const Ray line = latticeLine(surface, random, kSide);
                int count = 0;
                for (const Triangle& t : surface) count += crossesInIntegers(rule, line, t) != 0 ? 1 : 0;
                odd += count % 2;
            }
        }
        EXPECT_GT(odd, 10) << "mutation " << static_cast<int>(rule);
    }
}

// A million lines through vertices, edges and faces as floats have them, with slivers, from near and from far.
TEST(Crossing, isEvenOverSurfacesOfSlivers) {
    uint64_t lines = 0, crossed = 0;
    for (uint32_t seed = 0; seed < 200; ++seed) {
        std::vector<Triangle> surface = test::sliverStar(seed, 1 + static_cast<int>(seed % 3));
        const float shift = seed % 5 == 0 ? 1000.0f : 0.0f;
        for (Triangle& t : surface) t = {t.a + shift, t.b + shift, t.c + shift};
        const float scale = std::ldexp(1.0f, shift > 0.0f ? -10 : -1);
        for (Triangle& t : surface) t = {t.a * scale, t.b * scale, t.c * scale};
        test::Random random(seed);
        for (int i = 0; i < 5000; ++i, ++lines) {
            const float reach = std::ldexp(scale, i % 7 == 0 ? 20 : 1);
            const Ray line = scaledBy(test::aimedAt(surface, random, reach), 0);
            int count = 0, sum = 0;
            for (const Triangle& t : surface) {
                const int side = sharedSide(line, t);
                if (i % 64 == 0) {
                    ASSERT_EQ(side, crossesOnce(line, t)) << "seed " << seed << ", line " << i;
                }
                count += side != 0 ? 1 : 0;
                sum += side;
            }
            ASSERT_EQ(count % 2, 0) << "seed " << seed << ", line " << i;
            ASSERT_EQ(sum, 0) << "seed " << seed << ", line " << i;
            crossed += static_cast<uint64_t>(count);
        }
    }
    EXPECT_EQ(lines, 1000000u);
    EXPECT_GT(crossed, 1000000u);
}

// The filter in float, which decides most, says nothing else than the rule; t and weights are those of closest hits.
TEST(Crossing, agreesWithClosestHitsAwayFromEdges) {
    int hits = 0;
    for (uint32_t seed = 0; seed < 100000; ++seed) {
        test::Random random(seed);
        const Triangle t{random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const Ray ray = scaledBy({random.point(-2, 2), 0.0f, random.point(-1, 1), infinity()}, 0);
        const FilteredHit f = filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        const Crossing c = crossTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        ASSERT_FALSE(f.misses && c.side != 0) << "seed " << seed;
        ASSERT_FALSE(f.hits && c.side == 0) << "seed " << seed;
        if (c.side == 0) continue;
        const Hit h = resolveTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        ASSERT_EQ(c.t, h.t) << "seed " << seed;
        ASSERT_EQ(c.u, h.u) << "seed " << seed;
        ASSERT_EQ(c.v, h.v) << "seed " << seed;
        ASSERT_TRUE(f.tLow <= c.t && c.t <= f.tHigh) << "seed " << seed;
        hits++;
    }
    EXPECT_GT(hits, 2000);
}

// t has the exact sign, however near the origin is to the plane.
TEST(Crossing, tellsBeforeFromBehind) {
    int before = 0, behind = 0, on = 0;
    for (uint32_t seed = 0; seed < 20000; ++seed) {
        test::Random random(seed);
        const Triangle t{random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const float u = random.unit(), v = random.unit() * (1.0f - u);
        const vec3 point = seed % 3 == 0 ? t.b : t.a + u * (t.b - t.a) + v * (t.c - t.a);
        const Ray ray = scaledBy({point, 0.0f, random.point(-1, 1), infinity()}, 0);
        const Crossing c = crossTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        if (c.side == 0) continue;
        ExactSum height;  // det(a - o, b - o, c - o), times the side: positive where the plane is ahead
        addDeterminant(height, t.a, t.b, t.c, c.side);
        addDeterminant(height, ray.origin, t.b, t.c, -c.side);
        addDeterminant(height, t.a, ray.origin, t.c, -c.side);
        addDeterminant(height, t.a, t.b, ray.origin, -c.side);
        ASSERT_EQ(c.t < 0.0f, height.sign() < 0) << "seed " << seed;
        (height.sign() < 0 ? behind : height.sign() > 0 ? before : on)++;
    }
    EXPECT_GT(before, 1000);
    EXPECT_GT(behind, 1000);
    EXPECT_GT(on, 100);
}

}  // namespace
}  // namespace cleave
