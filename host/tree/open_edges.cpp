#include "tree/open_edges.h"

#include <algorithm>
#include <array>
#include <vector>

#include "shared/geometry.h"

namespace cleave {
namespace {

using Edge = std::array<uint32_t, 6>;  // the bits of its ends, the lesser first

std::array<uint32_t, 3> bitsOf(const vec3& v) {
    // -0 is where +0 is.
    return {floatBitsToUint(v.x + 0.0f), floatBitsToUint(v.y + 0.0f), floatBitsToUint(v.z + 0.0f)};
}

}  // namespace

uint64_t openEdges(std::span<const Triangle> triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        if (!isFiniteTriangle(t)) continue;
        const std::array<uint32_t, 3> corners[3] = {bitsOf(t.a), bitsOf(t.b), bitsOf(t.c)};
        for (int i = 0; i < 3; ++i) {
            const auto& from = std::min(corners[i], corners[(i + 1) % 3]);
            const auto& to = std::max(corners[i], corners[(i + 1) % 3]);
            if (from == to) continue;
            edges.push_back({from[0], from[1], from[2], to[0], to[1], to[2]});
        }
    }
    std::sort(edges.begin(), edges.end());
    uint64_t open = 0;
    for (size_t first = 0, end = 0; first < edges.size(); first = end) {
        while (end < edges.size() && edges[end] == edges[first]) ++end;
        open += (end - first) % 2;
    }
    return open;
}

}  // namespace cleave
