#include "stability/plane_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleave {
namespace {

// Steps along an axis are a power of two, so that the floats about a triangle are points of whole numbers. With edges
// e1 and e2 a point q, seen from the first vertex, lies at the height q . (e1 x e2), which is a whole multiple of the
// greatest common divisor of the normal's components. Points of one height are a lattice in a plane.
__extension__ typedef __int128 Whole;
using Point = std::array<Whole, 3>;
using Reals = std::array<long double, 3>;

constexpr int kFinerBits = 6;           // steps below the last place of the largest coordinate
constexpr double kMostHeight = 0x1p10;  // double's error is some 2^17 for vertices of 24 bits
constexpr int kTries = 8;

Point minus(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Point plus(const Point& p, const Point& q, Whole times) {
    return {p[0] + times * q[0], p[1] + times * q[1], p[2] + times * q[2]};
}
Point cross(const Point& p, const Point& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
Reals realOf(const Point& p) {
    return {static_cast<long double>(p[0]), static_cast<long double>(p[1]), static_cast<long double>(p[2])};
}
long double dot(const Reals& p, const Reals& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Whole nearestWhole(long double x) { return static_cast<Whole>(std::round(x)); }

// divisor = ofA a + ofB b, the greatest common one.
struct Bezout {
    Whole divisor, ofA, ofB;
};
Bezout bezout(Whole a, Whole b) {
    Bezout at{a, 1, 0}, next{b, 0, 1};
    while (next.divisor != 0) {
        const Whole times = at.divisor / next.divisor;
        const Bezout rest{at.divisor - times * next.divisor, at.ofA - times * next.ofA, at.ofB - times * next.ofB};
        at = next;
        next = rest;
    }
    return at;
}

// Where the point of the plane is nearest to x * p + y * q.
struct Along {
    long double x, y;
};
Along along(const Reals& p, const Reals& q, const Reals& point) {
    const long double pp = dot(p, p), pq = dot(p, q), qq = dot(q, q), p0 = dot(p, point), q0 = dot(q, point);
    const long double det = pp * qq - pq * pq;
    return {(p0 * qq - q0 * pq) / det, (q0 * pp - p0 * pq) / det};
}

struct Grid {
    std::array<int, 3> exponents;  // of the steps
    std::array<Point, 3> corners;
};

// Nothing where vertices need finer steps than large coordinates can have.
std::optional<Grid> gridOf(const Triangle& t) {
    Grid grid;
    const std::array<vec3, 3> corners{t.a, t.b, t.c};
    const float size = std::max({largestComponent(t.a), largestComponent(t.b), largestComponent(t.c)});
    for (int axis = 0; axis < 3; ++axis) {
        float largest = 0.0f;
        for (const vec3& v : corners) largest = std::max(largest, std::fabs(v[axis]));
        const int coarsest = std::max(binaryExponent(largest > 0.0f ? largest : size) - 23, -149);
        int e = coarsest;
        const auto isWhole = [&](float x) {
            return std::ldexp(double{x}, -e) == std::round(std::ldexp(double{x}, -e));
        };
        while (!(isWhole(t.a[axis]) && isWhole(t.b[axis]) && isWhole(t.c[axis])))
            if (--e < coarsest - kFinerBits) return std::nullopt;
        grid.exponents[static_cast<size_t>(axis)] = e;
        for (size_t i = 0; i < 3; ++i)
            grid.corners[i][static_cast<size_t>(axis)] = static_cast<Whole>(std::ldexp(double{corners[i][axis]}, -e));
    }
    return grid;
}

std::optional<vec3> floatsAt(const Grid& grid, const Point& p) {
    vec3 v;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<size_t>(axis);
        const double exact = std::ldexp(static_cast<double>(p[i]), grid.exponents[i]);
        v[axis] = static_cast<float>(exact);
        if (double{v[axis]} != exact) return std::nullopt;
    }
    return v;
}

class PlaneLattice {
  public:
    PlaneLattice(const Grid& grid) : grid_(grid) {
        e1_ = minus(grid.corners[1], grid.corners[0]);
        e2_ = minus(grid.corners[2], grid.corners[0]);
        Point n = cross(e1_, e2_);
        const Bezout two = bezout(n[0], n[1]), three = bezout(two.divisor, n[2]);
        divisor_ = three.divisor;
        if (divisor_ == 0) return;
        for (Whole& component : n) component /= divisor_;
        if (n[0] == 0 && n[1] == 0) {
            x_ = {1, 0, 0};
            y_ = {0, 1, 0};
            up_ = {0, 0, n[2]};
            return;
        }
        const Whole common = two.divisor / divisor_;
        x_ = {-n[1] / common, n[0] / common, 0};
        y_ = {-n[2] * two.ofA, -n[2] * two.ofB, common};
        up_ = {two.ofA * three.ofA, two.ofB * three.ofA, three.ofB};
        reduce();
    }

    bool hasArea() const { return divisor_ != 0; }
    // Steps that stay within a unit of the plane.
    uint64_t mostSteps() const {
        const Reals n = realOf(cross(e1_, e2_));
        const double most = std::min(kMostHeight, static_cast<double>(std::sqrt(dot(n, n))));
        return static_cast<uint64_t>(std::max(most / std::fabs(static_cast<double>(divisor_)), 1.0));
    }

    // The point at so many steps of height that is nearest to u of the one edge and v of the other.
    std::optional<vec3> nearest(double u, double v, Whole steps) const {
        Point q{steps * up_[0], steps * up_[1], steps * up_[2]};
        for (int i = 0; i < 3; ++i) {  // once would do but for rounding
            const Reals e1 = realOf(e1_), e2 = realOf(e2_), at = realOf(q);
            Reals way;
            for (size_t k = 0; k < 3; ++k) way[k] = u * e1[k] + v * e2[k] - at[k];
            const Along to = along(realOf(x_), realOf(y_), way);
            q = plus(plus(q, x_, nearestWhole(to.x)), y_, nearestWhole(to.y));
        }
        const Along in = along(realOf(e1_), realOf(e2_), realOf(q));
        if (!(in.x > 0 && in.y > 0 && in.x + in.y < 1)) return std::nullopt;
        return floatsAt(grid_, plus(grid_.corners[0], q, 1));
    }

  private:
    // Lagrange's: the shorter vector is taken from the longer one as often as it fits, while that makes it shorter.
    void reduce() {
        long double before;
        do {
            if (squareOf(y_) < squareOf(x_)) std::swap(x_, y_);
            before = squareOf(y_);
            y_ = plus(y_, x_, nearestWhole(-dot(realOf(x_), realOf(y_)) / squareOf(x_)));
        } while (squareOf(y_) < before);
    }
    static long double squareOf(const Point& p) { return dot(realOf(p), realOf(p)); }

    Grid grid_;
    Point e1_{}, e2_{};
    Point x_{}, y_{};  // of the lattice at height 0
    Point up_{};       // leads a step higher
    Whole divisor_ = 0;
};

template <class Steps>
std::optional<vec3> anyPoint(const Triangle& triangle, Random& random, Steps steps) {
    const std::optional<Grid> grid = gridOf(triangle);
    if (!grid) return std::nullopt;
    const PlaneLattice lattice(*grid);
    for (int i = 0; lattice.hasArea() && i < kTries; ++i) {
        const double u = random.unit(), v = random.unit();
        const bool isBeyond = u + v > 1.0;
        const auto point = lattice.nearest(isBeyond ? 1.0 - u : u, isBeyond ? 1.0 - v : v, steps(lattice));
        if (point) return point;
    }
    return std::nullopt;
}

}  // namespace

std::optional<vec3> pointInPlane(const Triangle& triangle, Random& random) {
    return anyPoint(triangle, random, [](const PlaneLattice&) { return Whole(0); });
}

std::optional<vec3> pointBesidePlane(const Triangle& triangle, Random& random) {
    return anyPoint(triangle, random, [&random](const PlaneLattice& lattice) {
        const Whole steps = 1 + random.below(lattice.mostSteps());
        return random.below(2) == 0 ? steps : -steps;
    });
}

}  // namespace cleave
