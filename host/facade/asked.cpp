#include "facade/asked.h"

#include <cmath>

#include "base/error.h"
#include "base/text.h"

namespace cleave::scene {
namespace {

constexpr uint32_t kMostHitsPerRay = 1u << 20;

bool isBox(const Box& box) {
    for (size_t axis = 0; axis < 3; ++axis)
        if (!(box.lo[axis] <= box.hi[axis])) return false;
    return true;
}

bool isPoint(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

}  // namespace

void requireHitsPerRay(uint32_t hitsPerRay) {
    if (hitsPerRay < 1 || hitsPerRay > kMostHitsPerRay)
        throw Error("all hits: there is room for " + grouped(hitsPerRay) + " per ray; ask for 1 to " +
                    grouped(kMostHitsPerRay));
}

void requireWithin(float within) {
    if (!(within >= 0.0f)) throw Error("the farthest distance of nearest triangles must be 0 or more");
}

void requirePoints(std::span<const Point> points) {
    for (size_t i = 0; i < points.size(); ++i)
        if (!isPoint(points[i])) throw BadItem("point " + grouped(i) + " is not finite; leave it out", i);
}

void requireBoxes(std::span<const Box> boxes) {
    for (size_t i = 0; i < boxes.size(); ++i)
        if (!isBox(boxes[i]))
            throw BadItem("box " + grouped(i) + " has lo > hi, or a part that is no number; leave it out", i);
}

void requireNoOpenEdges(uint64_t openEdges) {
    if (openEdges == 0) return;
    throw NotClosed("cannot tell inside from outside: the surface is not closed, " + grouped(openEdges) +
                        (openEdges == 1 ? " edge belongs" : " edges belong") +
                        " to an odd number of triangles; close it, or ask for the nearest triangle",
                    openEdges);
}

std::vector<float> signedDistances(std::span<const TraceHit> nearest, std::span<const uint8_t> isInside) {
    std::vector<float> distances(nearest.size());
    for (size_t i = 0; i < nearest.size(); ++i)
        distances[i] = isInside[i] != 0 && nearest[i].t > 0.0f ? -nearest[i].t : nearest[i].t;
    return distances;
}

}  // namespace cleave::scene
