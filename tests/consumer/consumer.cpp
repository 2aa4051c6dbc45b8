// A program that has Vulkan open already: in one command buffer it builds a tree over triangles, and traces rays with
// cmdTrace() and with a kernel of its own. Both must agree with a loop over all triangles, and validation be silent.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "own_trace.spv.h"
#include "own_vulkan.h"

namespace {

constexpr uint32_t kTriangles = 3000, kRays = 2000, kNone = 0xFFFFFFFF;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Triangle {
    float a[3], b[3], c[3];
};

struct Push {  // of own_trace.comp
    VkDeviceAddress tree, rays, hits, occluded, surfaces;
    uint32_t count;
};

struct Surfaces {  // of one ray
    int32_t oneByOne, counted, leaving;
};

float unit(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

void fill(Triangle& t, std::mt19937& random) {
    for (int i = 0; i < 3; i++) {
        t.a[i] = unit(random);
        t.b[i] = t.a[i] + 0.1f * unit(random);
        t.c[i] = t.a[i] - 0.1f * unit(random);
    }
}

void fill(cleave::TraceRay& r, std::mt19937& random) {
    for (int i = 0; i < 3; i++) {
        r.origin[i] = 3.0f * unit(random) - 1.0f;
        r.direction[i] = unit(random) - r.origin[i];
    }
    r.tMax = static_cast<float>(kInfinity);
}

double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void cross(const double* a, const double* b, double* to) {
    for (int i = 0; i < 3; i++) to[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

// The t of the ray's hit with a triangle (Moeller and Trumbore), or infinity.
double intersect(const cleave::TraceRay& ray, const Triangle& triangle) {
    double d[3], e1[3], e2[3], s[3], p[3], q[3];
    for (int i = 0; i < 3; i++) {
        d[i] = ray.direction[i];
        e1[i] = double(triangle.b[i]) - triangle.a[i];
        e2[i] = double(triangle.c[i]) - triangle.a[i];
        s[i] = double(ray.origin[i]) - triangle.a[i];
    }
    cross(d, e2, p);
    cross(s, e1, q);
    const double det = dot(e1, p), u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= ray.tMin && t <= ray.tMax ? t : kInfinity;
}

// Whether the ray leaves through the triangle's back.
bool facesAlong(const Triangle& triangle, const cleave::TraceRay& ray) {
    double e1[3], e2[3], n[3], d[3];
    for (int i = 0; i < 3; i++) {
        e1[i] = double(triangle.b[i]) - triangle.a[i];
        e2[i] = double(triangle.c[i]) - triangle.a[i];
        d[i] = ray.direction[i];
    }
    cross(e1, e2, n);
    return dot(n, d) > 0;
}

template <class T>
T at(const Memory& memory, uint32_t i) {
    return reinterpret_cast<const T*>(memory.mapped)[i];
}

}  // namespace

int main() {
    const OwnVulkan vulkan;
    std::mt19937 random(1);
    std::vector<Triangle> triangles(kTriangles);
    std::vector<cleave::TraceRay> rays(kRays);
    for (Triangle& t : triangles) fill(t, random);
    for (cleave::TraceRay& r : rays) fill(r, random);

    cleave::ContextInfo contextInfo;
    contextInfo.instance = vulkan.instance;
    contextInfo.physicalDevice = vulkan.physicalDevice;
    contextInfo.device = vulkan.device;
    contextInfo.getInstanceProcAddr = vkGetInstanceProcAddr;
    const cleave::NewContext made = cleave::createContext(contextInfo);
    require(made.context != nullptr, made.failed);

    cleave::Geometry geometry;
    geometry.vertexCount = 3 * kTriangles;
    geometry.triangleCount = kTriangles;
    cleave::BuildInfo build;
    build.geometries = &geometry;
    build.geometryCount = 1;
    const cleave::BuildSizes sizes = cleave::buildSizes(build);
    require(sizes.tree > 0 && sizes.scratchCount == 1, "buildSizes");
    const Memory tree = vulkan.allocate(sizes.tree, sizes.usage);
    const Memory scratch = vulkan.allocate(sizes.scratch[0], sizes.usage);
    const Memory vertices = vulkan.allocate(sizeof(Triangle) * kTriangles);
    const Memory rayMemory = vulkan.allocate(sizeof(cleave::TraceRay) * kRays);
    const Memory hits = vulkan.allocate(sizeof(cleave::TraceHit) * kRays);
    const Memory anyHits = vulkan.allocate(sizeof(cleave::TraceHit) * kRays);
    const Memory ownHits = vulkan.allocate(sizeof(cleave::TraceHit) * kRays);
    const Memory occluded = vulkan.allocate(sizeof(uint32_t) * kRays);
    const Memory surfaces = vulkan.allocate(sizeof(Surfaces) * kRays);
    std::memcpy(vertices.mapped, triangles.data(), sizeof(Triangle) * kTriangles);
    std::memcpy(rayMemory.mapped, rays.data(), sizeof(cleave::TraceRay) * kRays);
    geometry.vertices = vertices.range.address;

    const VkCommandBuffer commands = vulkan.begin();
    cleave::cmdBuild(commands, *made.context, build, tree.range, &scratch.range);
    barrier(commands);
    cleave::TraceInfo trace;
    trace.tree = tree.range.address;
    trace.rays = rayMemory.range.address;
    trace.hits = hits.range.address;
    trace.count = kRays;
    cleave::cmdTrace(commands, *made.context, trace);
    trace.mode.query = cleave::Query::any;
    trace.hits = anyHits.range.address;
    cleave::cmdTrace(commands, *made.context, trace);
    const Push push{trace.tree, trace.rays, ownHits.range.address, occluded.range.address, surfaces.range.address,
                    kRays};
    vulkan.dispatch(commands, kOwnTrace, push, (kRays + 63) / 64);
    barrier(commands);
    vulkan.run(commands);

    const auto& header = *reinterpret_cast<const cleave::TreeHeader*>(tree.mapped);
    require(header.magic == cleave::TreeHeader::kMagic && header.format == cleave::kTreeFormat && header.status == 0 &&
                header.triangleCount == kTriangles && header.nodeCount > kTriangles && header.bytes <= sizes.tree,
            "the tree's header");
    uint32_t hitCount = 0;
    for (uint32_t i = 0; i < kRays; i++) {
        const auto hit = at<cleave::TraceHit>(hits, i), own = at<cleave::TraceHit>(ownHits, i);
        double nearest = kInfinity;
        int32_t crossed = 0, leaving = 0;
        for (const Triangle& t : triangles) {
            const double distance = intersect(rays[i], t);
            nearest = std::min(nearest, distance);
            if (distance == kInfinity) continue;
            crossed++;
            leaving += facesAlong(t, rays[i]) ? 1 : -1;
        }
        const auto through = at<Surfaces>(surfaces, i);
        require(through.oneByOne == crossed && through.counted == crossed, "cleaveFirst, cleaveNext, cleaveCount");
        require(through.leaving == leaving, "cleaveWinding");
        const bool hitsAny = nearest < kInfinity;
        require(hitsAny == (hit.prim != kNone) && hitsAny == std::isfinite(hit.t), "hit or miss");
        require(!hitsAny || std::fabs(hit.t - nearest) <= 1e-6 * nearest, "t of the closest hit");
        require(!hitsAny || std::fabs(intersect(rays[i], triangles[hit.prim]) - nearest) <= 1e-12, "the triangle");
        require(hitsAny == (at<cleave::TraceHit>(anyHits, i).prim != kNone), "any hit");
        require(hit.t == own.t && hit.prim == own.prim && hit.u == own.u && hit.v == own.v, "cleaveTrace");
        require(hitsAny == (at<uint32_t>(occluded, i) != 0), "cleaveOccluded");
        hitCount += hitsAny;
    }
    require(hitCount > kRays / 4 && hitCount < kRays, "rays of both kinds");
    require(validationMessages == 0, "validation is silent");
    std::printf("%u of %u rays hit, %u nodes\n", hitCount, kRays, header.nodeCount);
}
