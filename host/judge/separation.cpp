#include "judge/separation.h"

#include <algorithm>
#include <cmath>

#include "tree/exact_sum.h"

namespace cleave {
namespace {

int signOf(double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

// Sign of (b - a) x (p - q) in the plane of axes i and j. The filter is that of Shewchuk's ORIENT2D (1997,
// section 4.1); products of floats are exact in double, so eight of them give the exact sum.
int crossSign(const vec3& a, const vec3& b, const vec3& p, const vec3& q, int i, int j) {
    const double ax = a[i], ay = a[j], bx = b[i], by = b[j], px = p[i], py = p[j], qx = q[i], qy = q[j];
    const double left = (bx - ax) * (py - qy);
    const double right = (by - ay) * (px - qx);
    constexpr double kBound = 3.4e-16;  // (3 + 16 u) u with u = 2^-53
    if (std::fabs(left - right) > kBound * (std::fabs(left) + std::fabs(right))) return signOf(left - right);
    ExactSum sum;
    for (const double x : {bx * py, -(bx * qy), -(ax * py), ax * qy, -(by * px), by * qx, ay * px, -(ay * qx)})
        sum.add(x);
    return sum.sign();
}

// Sign of the normal of the triangle times (p - a): det(p - a, b - a, c - a). The filter is that of ORIENT3D.
int planeSign(const Triangle& t, const vec3& p) {
    const dvec3 u = dvec3(t.b) - dvec3(t.a), v = dvec3(t.c) - dvec3(t.a), w = dvec3(p) - dvec3(t.a);
    double det = 0.0, magnitude = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double left = u[j] * v[k], right = u[k] * v[j];
        det += w[i] * (left - right);
        magnitude += std::fabs(w[i]) * (std::fabs(left) + std::fabs(right));
    }
    constexpr double kBound = 1e-15;  // above (7 + 56 u) u with u = 2^-53
    if (std::fabs(det) > kBound * magnitude + 1e-290) return signOf(det);
    // det(p, b, c) - det(a, b, c) - det(p, a, c) - det(p, b, a)
    ExactSum sum;
    addDeterminant(sum, p, t.b, t.c, 1.0);
    addDeterminant(sum, t.a, t.b, t.c, -1.0);
    addDeterminant(sum, p, t.a, t.c, -1.0);
    addDeterminant(sum, p, t.b, t.a, -1.0);
    return sum.sign();
}

vec3 corner(const Box& box, int bits) {
    return vec3((bits & 1) != 0 ? box.hi.x : box.lo.x, (bits & 2) != 0 ? box.hi.y : box.lo.y,
                (bits & 4) != 0 ? box.hi.z : box.lo.z);
}

// Is the whole box on one side of the triangle's plane? Touching it is allowed for the open box only.
bool planeSeparates(const Triangle& t, const Box& box, Contact contact) {
    const dvec3 n = preciseCross(dvec3(t.b) - dvec3(t.a), dvec3(t.c) - dvec3(t.a));
    const int likely = (n.x > 0.0 ? 1 : 0) | (n.y > 0.0 ? 2 : 0) | (n.z > 0.0 ? 4 : 0);
    if (planeSign(t, corner(box, likely)) > 0 && planeSign(t, corner(box, 7 - likely)) < 0) return false;
    int lowest = 1, highest = -1;
    for (int bits = 0; bits < 8; ++bits) {
        const int sign = planeSign(t, corner(box, bits));
        lowest = std::min(lowest, sign);
        highest = std::max(highest, sign);
    }
    return contact == Contact::interior ? lowest >= 0 || highest <= 0 : lowest > 0 || highest < 0;
}

// Does the line through the edge a, b (c is the third vertex), seen along the axis that is neither i nor j, have the
// triangle on one side and the box on the other? The axis is the edge's normal in that plane, (a_j - b_j, b_i - a_i).
bool edgeSeparates(const vec3& a, const vec3& b, const vec3& c, const Box& box, int i, int j, Contact contact) {
    if (a[i] == b[i] && a[j] == b[j]) return false;
    vec3 low(0.0f), high(0.0f);  // the box's corners that lie lowest and highest along the normal
    low[i] = a[j] > b[j] ? box.lo[i] : box.hi[i];
    low[j] = b[i] > a[i] ? box.lo[j] : box.hi[j];
    high[i] = a[j] > b[j] ? box.hi[i] : box.lo[i];
    high[j] = b[i] > a[i] ? box.hi[j] : box.lo[j];
    const int limit = contact == Contact::interior ? 0 : 1;
    return (crossSign(a, b, low, a, i, j) >= limit && crossSign(a, b, low, c, i, j) >= limit) ||
           (crossSign(a, b, high, a, i, j) <= -limit && crossSign(a, b, high, c, i, j) <= -limit);
}

bool anyEdgeSeparates(const Triangle& t, const Box& box, int i, int j, Contact contact) {
    return edgeSeparates(t.a, t.b, t.c, box, i, j, contact) || edgeSeparates(t.b, t.c, t.a, box, i, j, contact) ||
           edgeSeparates(t.c, t.a, t.b, box, i, j, contact);
}

bool axisSeparates(const Triangle& t, const Box& box, int axis, Contact contact) {
    const float lo = std::min({t.a[axis], t.b[axis], t.c[axis]});
    const float hi = std::max({t.a[axis], t.b[axis], t.c[axis]});
    if (contact == Contact::interior) return hi <= box.lo[axis] || lo >= box.hi[axis];
    return hi < box.lo[axis] || lo > box.hi[axis];
}

}  // namespace

bool meets(const Triangle& t, const Box& box, Contact contact) {
    for (int axis = 0; axis < 3; ++axis)
        if (axisSeparates(t, box, axis, contact)) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (anyEdgeSeparates(t, box, (axis + 1) % 3, (axis + 2) % 3, contact)) return false;
    return !planeSeparates(t, box, contact);
}

bool meetsRectangle(const Triangle& t, const Box& box, int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return !axisSeparates(t, box, i, Contact::interior) && !axisSeparates(t, box, j, Contact::interior) &&
           !anyEdgeSeparates(t, box, i, j, Contact::interior);
}

}  // namespace cleave
