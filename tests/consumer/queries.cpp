// Asks a scene the queries beside closest and any hits, as docs/queries.md shows them.
#include <cleave/scene.hpp>
#include <cstdio>
#include <limits>

namespace {

void require(bool isTrue, const char* what) {
    if (!isTrue) throw std::runtime_error(what);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return std::fprintf(stderr, "usage: queries FILE\n"), 2;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::vector<cleave::TraceRay> rays{{{0, 50, 0}, 0, {0, -1, 0}, kInfinity}};
    const std::vector<cleave::scene::Point> points{{0, 0.25f, 0}, {0, 50, 0}};
    const std::vector<cleave::scene::Box> boxes{{{-1, -1, -1}, {1, 1, 1}}};

    cleave::scene::Device device;
    cleave::scene::Mesh mesh(device, cleave::scene::GltfFile(argv[1]).pose().triangles);
    cleave::scene::Tree tree = mesh.build();
    const cleave::scene::AllHits all = tree.all(rays, 8);      // 8 per ray, front to back; misses fill up
    const cleave::scene::Counts counts = tree.count(rays);     // how many there are
    const cleave::scene::Nearest near = tree.nearest(points);  // t is the distance
    const cleave::scene::Overlaps met = tree.overlaps(boxes);  // pairs of a box and a triangle
    try {
        const cleave::scene::SignedDistances signedOnes = tree.signedDistance(points);  // negative inside
        require(signedOnes.distances.size() == points.size(), "a distance per point");
    } catch (const cleave::scene::NotClosed& open) {
        std::printf("%llu open edges\n", static_cast<unsigned long long>(open.openEdges));
    }
    tree = mesh.load(tree.save());  // bytes for a file of yours

    size_t hits = 0;
    while (hits < 8 && all.hits[hits].t < kInfinity) hits++;
    require(hits > 0 && (hits == 8 || counts.counts[0] == static_cast<int32_t>(hits)), "all and count agree");
    require(tree.all(rays, 8).hits[0].prim == all.hits[0].prim, "the loaded tree answers alike");
    require(near.hits[0].t < near.hits[1].t && !met.pairs.empty(), "the scene is about the origin");
    const cleave::scene::Twin twin = mesh.twin();
    require(twin.count(rays).counts == counts.counts, "the twin counts alike");
    std::printf("%zu hits, %g to the nearest triangle, %zu in the box\n", hits, near.hits[0].t, met.pairs.size());
    return 0;
} catch (const std::exception& error) {
    return std::fprintf(stderr, "error: %s\n", error.what()), 1;
}
