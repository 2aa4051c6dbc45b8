// The point of a triangle that is nearest to a given one.
#ifndef CLEAVE_SHARED_NEAREST_POINT_H
#define CLEAVE_SHARED_NEAREST_POINT_H
#include "tree.h"

CLEAVE_BEGIN

struct NearPoint {
    double square;  // of the distance
    double u;       // weights of the second and third vertex
    double v;
};

CLEAVE_FN NearPoint nearPoint(dvec3 way, double u, double v) {
    NearPoint n;
    n.square = preciseDot(way, way);
    n.u = u;
    n.v = v;
    return n;
}

CLEAVE_FN bool comesBefore(vec3 a, vec3 b) {
    return a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)));
}

// How far along the edge from a to b the point nearest to 0 is, from 0 to 1. Both are as seen from the given point.
CLEAVE_FN double shareAlong(dvec3 a, dvec3 b) {
    dvec3 edge = b - a;
    double length = preciseDot(edge, edge);
    double along = -preciseDot(a, edge);
    if (!(along > 0.0) || length == 0.0) return 0.0;
    return along < length ? along / length : 1.0;
}

// The nearest of four points: on each edge, and the projection onto the plane where that is inside. Each is a mean of
// the vertices with weights of 0 to 1 and its distance is measured, so that rounding, of the thinnest triangles too,
// can only choose a point that is hardly farther. Edges are taken from their lesser end, so that the triangles at an
// edge find the same distance, bit for bit.
CLEAVE_FN NearPoint nearestPoint(dvec3 point, Triangle t) {
    vec3 corners[3];
    corners[0] = t.a;
    corners[1] = t.b;
    corners[2] = t.c;
    dvec3 ways[3];
    for (uint i = 0u; i < 3u; i++) ways[i] = dvec3(corners[i]) - point;
    NearPoint best = nearPoint(ways[0], 0.0, 0.0);
    for (uint i = 0u; i < 3u; i++) {
        uint next = (i + 1u) % 3u;
        bool swaps = comesBefore(corners[next], corners[i]);
        uint from = swaps ? next : i;
        uint to = swaps ? i : next;
        double share = shareAlong(ways[from], ways[to]);
        precise double rest = 1.0 - share;
        precise dvec3 head = rest * ways[from];
        precise dvec3 tail = share * ways[to];
        double u = (from == 1u ? rest : 0.0) + (to == 1u ? share : 0.0);
        double v = (from == 2u ? rest : 0.0) + (to == 2u ? share : 0.0);
        NearPoint n = nearPoint(head + tail, u, v);
        if (n.square < best.square) best = n;
    }
    dvec3 normal = preciseCross(ways[1] - ways[0], ways[2] - ways[0]);
    double wa = preciseDot(normal, preciseCross(ways[1], ways[2]));
    double wb = preciseDot(normal, preciseCross(ways[2], ways[0]));
    double wc = preciseDot(normal, preciseCross(ways[0], ways[1]));
    if (wa > 0.0 && wb > 0.0 && wc > 0.0) {
        precise double sum = wa + wb;
        sum = sum + wc;
        double u = wb / sum;
        double v = wc / sum;
        precise double w = wa / sum;
        precise dvec3 first = w * ways[0];
        precise dvec3 second = u * ways[1];
        precise dvec3 third = v * ways[2];
        precise dvec3 way = first + second;
        NearPoint n = nearPoint(way + third, u, v);
        if (n.square < best.square) best = n;
    }
    return best;
}

// What a query tells of it: the distance in the world, rounded once, where the triangle is scaled by 2^-exponent.
// Distances below the smallest normal number are 0. Ties of these go to the lower triangle number.
CLEAVE_FN float worldDistance(NearPoint n, int exponent) {
    double distance = sqrt(n.square) * powerOfTwo(exponent);
    return distance < double(kSmallestNormal) ? 0.0f : distance > double(kLargestFloat) ? infinity() : float(distance);
}

// A point of the world in a tree's space. In double, since a far point of a tiny scene is no float there.
CLEAVE_FN dvec3 scaledPoint(vec3 point, int exponent) {
    double scale = powerOfTwo(-exponent);
    return dvec3(double(point.x) * scale, double(point.y) * scale, double(point.z) * scale);
}

CLEAVE_END
#endif
