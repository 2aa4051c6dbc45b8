#include "judge/reference_triangle.h"

#include <algorithm>
#include <cmath>

#include "shared/scale.h"
#include "tree/exact_sum.h"

namespace cleave {
namespace {

// A determinant in double and the sum of its terms' magnitudes. With vectors that are differences of floats, rounded
// once, its error is below kBound * magnitude: the filter of Shewchuk's ORIENT3D, (7 + 56 u) u with u = 2^-53.
struct Estimate {
    double value = 0.0;
    double magnitude = 0.0;
    bool isSignCertain() const { return std::fabs(value) > kBound * magnitude; }
    bool isPrecise() const { return kBound * magnitude < 1e-9 * std::fabs(value); }
    static constexpr double kBound = 1e-15;
};

Estimate determinant(const dvec3& a, const dvec3& b, const dvec3& c) {
    Estimate e;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double left = b[j] * c[k], right = b[k] * c[j];
        e.value += a[i] * (left - right);
        e.magnitude += std::fabs(a[i]) * (std::fabs(left) + std::fabs(right));
    }
    return e;
}

// Adds det(d, p - o, q - o) = det(d, p, q) - det(d, p, o) - det(d, o, q).
void addEdge(ExactSum& sum, const Ray& ray, const vec3& p, const vec3& q) {
    addDeterminant(sum, ray.direction, p, q, 1.0);
    addDeterminant(sum, ray.direction, p, ray.origin, -1.0);
    addDeterminant(sum, ray.direction, ray.origin, q, -1.0);
}

int edgeSign(const Estimate& e, const Ray& ray, const vec3& p, const vec3& q) {
    if (e.isSignCertain()) return e.value > 0.0 ? 1 : -1;
    ExactSum sum;
    addEdge(sum, ray, p, q);
    return sum.sign();
}

// det(a - o, b - o, c - o): the triangle's normal times the way from the origin to its plane.
ExactSum exactHeight(const Ray& ray, const Triangle& t) {
    ExactSum sum;
    addDeterminant(sum, t.a, t.b, t.c, 1.0);
    addDeterminant(sum, ray.origin, t.b, t.c, -1.0);
    addDeterminant(sum, t.a, ray.origin, t.c, -1.0);
    addDeterminant(sum, t.a, t.b, ray.origin, -1.0);
    return sum;
}

// The normal times the direction, which is the sum of the three edges' determinants.
ExactSum exactSlope(const Ray& ray, const Triangle& t) {
    ExactSum sum;
    addEdge(sum, ray, t.b, t.c);
    addEdge(sum, ray, t.c, t.a);
    addEdge(sum, ray, t.a, t.b);
    return sum;
}

// The distance from the origin to the segment from p to q, in the plane across the unit vector d.
double distanceAcross(const dvec3& d, const dvec3& p, const dvec3& q) {
    const dvec3 from = p - glm::dot(p, d) * d, to = q - glm::dot(q, d) * d;
    const dvec3 way = to - from;
    const double length2 = glm::dot(way, way);
    const double part = length2 > 0.0 ? std::clamp(-glm::dot(from, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(from + part * way);
}

}  // namespace

LineHit intersectLine(const Ray& ray, const Triangle& t) {
    const dvec3 o(ray.origin), d(ray.direction);
    const dvec3 a = dvec3(t.a) - o, b = dvec3(t.b) - o, c = dvec3(t.c) - o;
    const Estimate atA = determinant(d, b, c), atB = determinant(d, c, a), atC = determinant(d, a, b);
    const int signA = edgeSign(atA, ray, t.b, t.c), signB = edgeSign(atB, ray, t.c, t.a);
    if (signA * signB < 0) return {};
    const int signC = edgeSign(atC, ray, t.a, t.b);
    if (signA * signC < 0 || signB * signC < 0 || (signA == 0 && signB == 0 && signC == 0)) return {};

    const Estimate height = determinant(a, b, c);
    const Estimate slope{atA.value + atB.value + atC.value, atA.magnitude + atB.magnitude + atC.magnitude};
    const double numerator = height.isPrecise() ? height.value : exactHeight(ray, t).value();
    const double denominator = slope.isPrecise() ? slope.value : exactSlope(ray, t).value();
    return {true, numerator / denominator, 10.0 * Estimate::kBound * height.magnitude / std::fabs(denominator)};
}

PreciseT preciseT(const Ray& ray, const Triangle& t) {
    ExactSum residual = exactHeight(ray, t);
    const ExactSum slope = exactSlope(ray, t);
    const double denominator = slope.value();
    const double high = residual.value() / denominator;
    residual.addMultiple(slope, -high);
    return {high, residual.value() / denominator};
}

bool passesNearEdge(const Ray& ray, const Triangle& t, double ulps) {
    // Directions of any length become unit vectors: largest component first, so that squares stay in range.
    const dvec3 direction(ray.direction);
    const dvec3 scaled = direction / double{largestComponent(ray.direction)};
    const dvec3 d = scaled / glm::length(scaled), o(ray.origin);
    const vec3* corners[] = {&t.a, &t.b, &t.c};
    for (int i = 0; i < 3; ++i) {
        const vec3 &p = *corners[i], &q = *corners[(i + 1) % 3];
        const float largest = std::max({largestComponent(p), largestComponent(q), kSmallestNormal});
        const double ulp = std::ldexp(1.0, binaryExponent(largest) - 23);
        if (distanceAcross(d, dvec3(p) - o, dvec3(q) - o) <= ulps * ulp) return true;
    }
    return false;
}

}  // namespace cleave
