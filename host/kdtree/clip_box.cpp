#include "kdtree/clip_box.h"

#include <cmath>

namespace cleave {
namespace {

// Clipping works in double, relative to the triangle's first vertex, in units of the triangle's extent per axis. Each
// of the six cuts moves a vertex off the triangle's true outline by at most a few 2^-52 of the extent. The cell is
// widened by kWiden, which is far more, so a cut never removes what belongs to the cell; and computed vertices are
// widened by kPad before they are rounded outward. Both are far below a place of float for coordinates as large as the
// extent.
constexpr double kWiden = 0x1p-44;
constexpr double kPad = 0x1p-46;

struct Corner {
    dvec3 at;
    const vec3* vertex;  // the triangle's own, exact; null for what a cut computed
};

// A triangle cut by six planes has at most nine corners.
struct Polygon {
    Corner corners[9];
    int size = 0;
    void add(const Corner& c) { corners[size++] = c; }
};

// Sutherland and Hodgman 1974: the part of the polygon with sign * x[axis] <= sign * plane.
Polygon cut(const Polygon& polygon, int axis, double plane, double sign) {
    Polygon kept;
    for (int i = 0; i < polygon.size; ++i) {
        const Corner& p = polygon.corners[i];
        const Corner& q = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
        const double dp = sign * (p.at[axis] - plane), dq = sign * (q.at[axis] - plane);
        if (dp <= 0.0) kept.add(p);
        if ((dp < 0.0 && dq > 0.0) || (dp > 0.0 && dq < 0.0)) {
            // From the inner corner, whichever way the edge is walked.
            const Corner& from = dp < 0.0 ? p : q;
            const Corner& to = dp < 0.0 ? q : p;
            const double part = (plane - from.at[axis]) / (to.at[axis] - from.at[axis]);
            Corner c{from.at + part * (to.at - from.at), nullptr};
            c.at[axis] = plane;
            kept.add(c);
        }
    }
    return kept;
}

float roundedDown(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) <= x ? f : nextFloat(f, false);
}
float roundedUp(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) >= x ? f : nextFloat(f, true);
}

// In single steps below the smallest normal number a coordinate would be flushed elsewhere: it counts as zero, outward.
float flushedDown(float x) { return x < 0.0f && x > -kSmallestNormal ? -kSmallestNormal : flushed(x); }
float flushedUp(float x) { return x > 0.0f && x < kSmallestNormal ? kSmallestNormal : flushed(x); }

Box boundsOf(const Polygon& polygon, const dvec3& origin, const dvec3& extent) {
    Box box = emptyBox();
    for (int i = 0; i < polygon.size; ++i) {
        const Corner& c = polygon.corners[i];
        if (c.vertex != nullptr) {
            box = including(box, *c.vertex);
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) {
            // The way back from the first vertex rounds, too: far from the origin by more than the pad.
            const double x = origin[axis] + c.at[axis];
            const double pad = kPad * extent[axis] + 0x1p-52 * std::fabs(x);
            box.lo[axis] = min(box.lo[axis], flushedDown(roundedDown(x - pad)));
            box.hi[axis] = max(box.hi[axis], flushedUp(roundedUp(x + pad)));
        }
    }
    return box;
}

}  // namespace

Box clippedBox(const Triangle& t, const Box& cell) {
    const Box own = including(including(including(emptyBox(), t.a), t.b), t.c);
    const Box limit = intersection(own, cell);
    if (isEmpty(limit)) return limit;
    const dvec3 origin(t.a), extent = dvec3(own.hi) - dvec3(own.lo);
    Polygon polygon;
    polygon.add({dvec3(0.0), &t.a});
    polygon.add({dvec3(t.b) - origin, &t.b});
    polygon.add({dvec3(t.c) - origin, &t.c});
    for (int axis = 0; axis < 3; ++axis) {
        const double widen = kWiden * extent[axis];
        if (own.lo[axis] < cell.lo[axis]) polygon = cut(polygon, axis, cell.lo[axis] - origin[axis] - widen, -1.0);
        if (own.hi[axis] > cell.hi[axis]) polygon = cut(polygon, axis, cell.hi[axis] - origin[axis] + widen, 1.0);
    }
    return intersection(boundsOf(polygon, origin, extent), limit);
}

}  // namespace cleave
