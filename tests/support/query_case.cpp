#include "support/query_case.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace cleave::test {
namespace {

class Maker {
  public:
    Maker(uint32_t seed, uint64_t scene) {
        std::seed_seq numbers{seed, static_cast<uint32_t>(scene), static_cast<uint32_t>(scene >> 32)};
        random_.seed(numbers);
        side_ = 1 + below(6);
        chooseTransform();
        chooseSettings();
    }

    QueryCase make(size_t rayCount) {
        const uint32_t count = oneIn(3) ? 1 + below(4) : 1 + below(60);
        for (uint32_t i = 0; i < count; ++i) grid_.push_back(triangle());
        for (const Triangle& t : grid_) case_.triangles.push_back({placed(t.a), placed(t.b), placed(t.c)});
        while (case_.rays.size() < rayCount) case_.rays.push_back(ray());
        return std::move(case_);
    }

  private:
    // No distributions of the standard library: they differ between machines.
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    bool oneIn(uint32_t n) { return below(n) == 0; }
    int within(int lo, int hi) { return lo + static_cast<int>(below(static_cast<uint32_t>(hi - lo + 1))); }
    template <typename T>
    const T& oneOf(const std::vector<T>& all) {
        return all[below(static_cast<uint32_t>(all.size()))];
    }

    void chooseTransform() {
        if (oneIn(3)) exponent_ = within(-60, 60);
        if (oneIn(4))
            for (int k = 0; k < 3; ++k) offset_[k] = static_cast<float>(within(-4, 4) << within(0, 16));
        const uint32_t kind = below(8);
        isThirds_ = kind == 0;
        isJittered_ = kind == 1;
    }

    void chooseSettings() {
        BuildSettings& s = case_.settings;
        s.exactUpTo = oneOf<uint32_t>({0, 2, 8, kExactBelow});
        s.bins = oneOf<uint32_t>({2, 5, kBins});
        s.leafSize = 1 + below(4);
        s.clip = !oneIn(4);
        s.axes = oneOf<AxisChoice>({AxisChoice::all, AxisChoice::widest, AxisChoice::cycle});
        if (oneIn(4)) s.maxDepth = oneOf<uint32_t>({1, 3, 40, kMaxDepth});
    }

    vec3 gridPoint(int margin) {
        vec3 p(0.0f);
        for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(within(-margin, static_cast<int>(side_) + margin));
        return p;
    }
    vec3 unitStep(bool alongAxis) {
        vec3 d(0.0f);
        if (alongAxis)
            d[within(0, 2)] = oneIn(2) ? 1.0f : -1.0f;
        else
            for (int k = 0; k < 3; ++k) d[k] = static_cast<float>(within(-1, 1));
        return d;
    }
    vec3 corner(const Triangle& t) { return oneOf<vec3>({t.a, t.b, t.c}); }
    vec3 edgeMiddle(const Triangle& t) {
        return oneOf<vec3>({0.5f * (t.a + t.b), 0.5f * (t.b + t.c), 0.5f * (t.c + t.a)});
    }

    // Anywhere, or in a relation to an earlier one: the same, at its edge, at its vertex, moved by a step.
    Triangle triangle() {
        Triangle t{gridPoint(0), gridPoint(0), gridPoint(0)};
        if (oneIn(3)) {  // in a plane of the grid
            const int axis = within(0, 2);
            t.b[axis] = t.c[axis] = t.a[axis];
        }
        if (grid_.empty()) return t;
        const Triangle other = oneOf(grid_);
        const uint32_t relation = below(12);
        if (relation == 0) return other;
        if (relation == 1) return {other.b, other.a, other.c};
        if (relation <= 4) return {other.b, other.a, t.c};
        if (relation <= 6) return {other.a, t.b, t.c};
        if (relation == 7) {
            const vec3 step = unitStep(true);
            return {other.a + step, other.b + step, other.c + step};
        }
        return t;
    }

    float placed(float x, int axis, bool jitter) {
        const float moved = (isThirds_ ? x / 3.0f : x) + offset_[axis];
        const float scaled = std::ldexp(moved, exponent_);
        if (!jitter || scaled == 0.0f || !oneIn(4)) return scaled;
        constexpr float kFar = std::numeric_limits<float>::infinity();
        return std::nextafter(scaled, oneIn(2) ? kFar : -kFar);
    }
    vec3 placed(const vec3& p, bool jitter) {
        const float x = placed(p.x, 0, jitter), y = placed(p.y, 1, jitter);
        return vec3(x, y, placed(p.z, 2, jitter));
    }
    vec3 placed(const vec3& p) { return placed(p, isJittered_); }
    // With the scene's scale, so that t counts steps of the grid in every scene.
    vec3 placedDirection(const vec3& d) const {
        return vec3(std::ldexp(d.x, exponent_), std::ldexp(d.y, exponent_), std::ldexp(d.z, exponent_));
    }

    struct Line {
        vec3 origin;
        vec3 direction;
    };
    // On the grid: from anywhere, or from something of a triangle; along an axis, a diagonal, an edge, or at something.
    Line line() {
        const Triangle t = oneOf(grid_);
        const uint32_t kind = below(10);
        if (kind == 0) {  // along the line of an edge, from one of its points
            const vec3 edge = t.b - t.a;
            return {t.a + edge * (0.5f * static_cast<float>(within(-4, 4))), oneIn(2) ? edge : -edge};
        }
        const vec3 origin = kind == 1   ? corner(t)
                            : kind == 2 ? edgeMiddle(t)
                            : kind == 3 ? 0.5f * gridPoint(4)
                                        : gridPoint(2);
        const Triangle aim = oneOf(grid_);
        switch (below(6)) {
            case 0:
                return {origin, unitStep(true)};
            case 1:
                return {origin, unitStep(false)};
            case 2:
                return {origin, corner(aim) - origin};
            case 3:
                return {origin, edgeMiddle(aim) - origin};
            case 4:
                return {origin, gridPoint(2) - origin};
            default:
                return {origin, vec3(static_cast<float>(within(-99, 99)), static_cast<float>(within(-99, 99)),
                                     static_cast<float>(within(-99, 99))) /
                                    64.0f};
        }
    }

    // t counts steps of the direction, so that its ends fall onto hits.
    void chooseInterval(Ray& r) {
        const auto step = [&] { return 0.5f * static_cast<float>(below(7)); };
        r.tMin = oneIn(4) ? step() : 0.0f;
        r.tMax = oneIn(4) ? r.tMin + step() : infinity();
    }

    void spoil(Ray& r) {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const int axis = within(0, 2);
        switch (below(8)) {
            case 0:
                r.origin[axis] = nan;
                return;
            case 1:
                r.direction[axis] = nan;
                return;
            case 2:
                r.origin[axis] = -infinity();
                return;
            case 3:
                r.direction[axis] = infinity();
                return;
            case 4:
                r.direction = vec3(0.0f, -0.0f, 0.0f);
                return;
            case 5:
                r.tMin = oneIn(2) ? nan : -1.0f;
                return;
            case 6:
                r.tMax = oneIn(2) ? nan : r.tMin - 1.0f;
                return;
            default:
                r.tMin = infinity();
                r.tMax = infinity();
        }
    }

    Ray ray() {
        const Line l = line();
        Ray r{placed(l.origin), 0.0f, placedDirection(l.direction), 0.0f};
        if (isThirds_ && oneIn(2))
            r.direction = placed(l.origin + l.direction, false) - r.origin;  // at what was rounded
        chooseInterval(r);
        const int length = oneIn(4) ? within(-30, 30) : oneIn(20) ? within(-150, 120) : 0;
        for (int k = 0; k < 3; ++k) {
            if (r.direction[k] == 0.0f && oneIn(3)) r.direction[k] = -0.0f;
            r.direction[k] = std::ldexp(r.direction[k], length);
        }
        r.tMin = std::ldexp(r.tMin, -length);
        r.tMax = std::ldexp(r.tMax, -length);
        if (oneIn(64)) spoil(r);
        return r;
    }

    std::mt19937 random_;
    uint32_t side_ = 1;
    int exponent_ = 0;
    vec3 offset_{0.0f};
    bool isThirds_ = false;
    bool isJittered_ = false;
    std::vector<Triangle> grid_;  // in steps, before they are placed
    QueryCase case_;
};

std::string codeOf(const vec3& v) {
    char text[120];
    std::snprintf(text, sizeof text, "{%af, %af, %af}", double{v.x}, double{v.y}, double{v.z});
    return text;
}

std::string codeOf(float x) {
    char text[40];
    std::snprintf(text, sizeof text, "%af", double{x});
    return std::isfinite(x) ? text : x > 0.0f ? "infinity()" : x < 0.0f ? "-infinity()" : "nan";
}

}  // namespace

QueryCase queryCase(uint32_t seed, uint64_t scene, size_t rayCount) { return Maker(seed, scene).make(rayCount); }

std::string codeOf(const Triangle& t) { return "{" + codeOf(t.a) + ", " + codeOf(t.b) + ", " + codeOf(t.c) + "},"; }

std::string codeOf(const Ray& r) {
    return "{" + codeOf(r.origin) + ", " + codeOf(r.tMin) + ", " + codeOf(r.direction) + ", " + codeOf(r.tMax) + "}";
}

}  // namespace cleave::test
