#include "peers/peers.h"

#include <gtest/gtest.h>

#include "builders/builders.h"
#include "gpu/commands.h"
#include "judge/oracle.h"
#include "peers/embree.h"
#include "peers/stack_walk.h"
#include "record/recorder.h"
#include "run/device_tree.h"
#include "shared/peer_trace.h"
#include "support/device.h"
#include "support/scenes.h"

namespace cleave {
std::span<const Spirv> peerTestKernels() noexcept;
}

namespace cleave::test {
namespace {

// Triangles, rays from all around through them, and the answers of brute force.
struct Case {
    explicit Case(uint32_t seed) : world(mixedTriangles(2000, seed)) {
        world[7].b = world[7].a;  // no area: it stays out, and numbers behind it must not shift
        set = makeTriangleSet(world);
        tree = buildExact(set, {});
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(0.0f, 1.0f);
        for (int i = 0; i < 3000; i++) {
            const vec3 from(3.0f * unit(random) - 1.0f, 3.0f * unit(random) - 1.0f, 3.0f * unit(random) - 1.0f);
            const vec3 to(unit(random), unit(random), unit(random));
            rays.push_back({from, 0.0f, to - from, i % 2 == 0 ? infinity() : 0.7f});
        }
        for (const Query query : {Query::closest, Query::any}) {
            std::vector<Hit>& hits = query == Query::any ? anyHits : closestHits;
            for (const Ray& ray : rays) hits.push_back(bruteForce(set, ray, query));
        }
    }
    PeerScene scene() const { return {world, set, tree, 0.0, 2}; }
    const std::vector<Hit>& hits(Query query) const { return query == Query::any ? anyHits : closestHits; }

    std::vector<Triangle> world;
    TriangleSet set;
    KdTree tree;
    std::vector<Ray> rays;
    std::vector<Hit> closestHits, anyHits;
};

DeviceOptions withRayTracing() {
    DeviceOptions options;
    options.rayTracing = true;
    return options;
}

}  // namespace

TEST(Peers, AnswerLikeBruteForce) {
    const std::unique_ptr<Device> device = openTestDevice(withRayTracing());
    const Case c(1);
    uint32_t present = 0;
    for (const PeerOffer& offer : peersOn(*device)) {
        SCOPED_TRACE(offer.name + (offer.order == TriangleOrder::file ? ", file" : ", morton"));
        if (!offer.missing.empty()) continue;
        present++;
        const std::unique_ptr<Peer> peer = offer.make(*device, c.scene());
        EXPECT_GE(peer->build(), 0.0);
        for (const Query query : {Query::closest, Query::any}) {
            const Peer::Traced traced = peer->trace(c.rays, query);
            ASSERT_EQ(traced.hits.size(), c.rays.size());
            // In float, rays that graze an edge may go either way.
            EXPECT_LE(disagreements(c.hits(query), traced.hits, query), 6u);
            if (query == Query::any) continue;
            uint32_t others = 0;
            for (size_t i = 0; i < c.rays.size(); i++) others += traced.hits[i].prim != c.closestHits[i].prim;
            EXPECT_LE(others, 12u) << "numbers are the scene's";
        }
    }
    EXPECT_GE(present, 1u);
}

// It computes with the shared triangle function, so nothing may differ.
TEST(Peers, StackWalkEqualsBruteForce) {
    for (uint32_t seed = 2; seed < 5; seed++) {
        const Case c(seed);
        const std::unique_ptr<Peer> walk = makeStackWalk(c.scene());
        walk->build();
        const std::vector<Hit> hits = walk->trace(c.rays, Query::closest).hits;
        for (size_t i = 0; i < hits.size(); i++) {
            ASSERT_EQ(hits[i].t, c.closestHits[i].t) << "seed " << seed << ", ray " << i;
            ASSERT_EQ(hits[i].prim, c.closestHits[i].prim) << "seed " << seed << ", ray " << i;
        }
        EXPECT_EQ(disagreements(c.anyHits, walk->trace(c.rays, Query::any).hits, Query::any), 0u);
    }
}

// cleave_ray_query.glsl: the shader that asks the driver (shaders/lib/peer_query.glsl) asks a tree of ours, and gets
// what the tracer answers, bit for bit.
TEST(RayQueryNames, AnswerLikeOurTracer) {
    const Case c(7);
    const auto tree = uploadTree(device(), c.set, c.tree);
    const Buffer rays = uploaded(device(), std::span<const Ray>(c.rays));
    const Buffer hits(device(), c.rays.size() * sizeof(Hit));
    Functions functions;
    ASSERT_EQ(functions.load(vkGetInstanceProcAddr, device().instance(), device().handle()), nullptr);
    for (const Query query : {Query::closest, Query::any}) {
        const uint32_t anyHit = query == Query::any ? 1 : 0;
        const PipelineHome home{&functions, device().handle(), device().pipelineCache(), nullptr};
        Kernel kernel;
        ASSERT_EQ(
            kernel.create(home, findSpirv(peerTestKernels(), "cleave_names"), sizeof(PeerTracePush), {&anyHit, 1}),
            VK_SUCCESS);
        PeerTracePush push{};
        push.scene = tree->address();
        push.rays = rays.address();
        push.hits = hits.address();
        push.rayCount = static_cast<uint32_t>(c.rays.size());
        Commands commands(device());
        commands.begin();
        Recorder(functions, commands.handle()).dispatch(kernel, push, ceilDiv(push.rayCount, kGroup));
        commands.run();
        const std::vector<Hit> found = hits.download<Hit>(c.rays.size());
        for (size_t i = 0; i < found.size(); i++) {
            const Hit& expected = c.hits(query)[i];
            ASSERT_EQ(found[i].prim == kNone, expected.prim == kNone) << "ray " << i;
            if (query == Query::any) continue;
            ASSERT_EQ(found[i].t, expected.t) << "ray " << i;
            ASSERT_EQ(found[i].prim, expected.prim) << "ray " << i;
            ASSERT_EQ(found[i].u, expected.u) << "ray " << i;
            ASSERT_EQ(found[i].v, expected.v) << "ray " << i;
        }
    }
}

TEST(Peers, SayWhatIsMissing) {
    const std::vector<PeerOffer> offers = peersOn(device());  // opened without ray tracing
    ASSERT_EQ(offers.size(), 6u);
    for (const PeerOffer& offer : offers) {
        const bool ofTheDriver = offer.name.starts_with("ray-"), isEmbree = offer.name == "embree";
        EXPECT_EQ(offer.missing.empty(), isEmbree ? hasEmbree() : !ofTheDriver) << offer.name;
        EXPECT_EQ(offer.missing.find("VK_KHR_ray_") != std::string::npos, ofTheDriver) << offer.name;
    }
}

TEST(Peers, CountDisagreements) {
    const Hit hit{2.0f, 5, 0, 0}, near{2.0001f, 5, 0, 0}, far{2.001f, 5, 0, 0}, other{2.0f, 6, 0, 0};
    const Hit miss = missedHit();
    const auto of = [](Hit ours, Hit theirs, Query query) { return disagreements({&ours, 1}, {&theirs, 1}, query); };
    EXPECT_EQ(of(hit, hit, Query::closest), 0u);
    EXPECT_EQ(of(hit, near, Query::closest), 0u);
    EXPECT_EQ(of(hit, other, Query::closest), 0u) << "which of two that meet";
    EXPECT_EQ(of(hit, far, Query::closest), 1u);
    EXPECT_EQ(of(hit, far, Query::any), 0u);
    EXPECT_EQ(of(hit, miss, Query::any), 1u);
    EXPECT_EQ(of(miss, hit, Query::closest), 1u);
    EXPECT_EQ(of(miss, miss, Query::closest), 0u);
}

TEST(Peers, SamplesWholeTiles) {
    std::vector<uint32_t> all(10000);
    for (uint32_t i = 0; i < all.size(); i++) all[i] = i;
    const std::span<const uint32_t> view(all);
    EXPECT_EQ(sampleOfTiles(view, 10000), all);
    EXPECT_EQ(sampleOfTiles(view, 1000000), all);
    const std::vector<uint32_t> some = sampleOfTiles(view, 1000);
    EXPECT_LE(some.size(), 1024u);
    EXPECT_GE(some.size(), 900u);
    for (size_t i = 0; i < some.size(); i++) EXPECT_EQ(some[i] % 64, i % 64) << "neighbours stay neighbours";
}

TEST(TriangleOrder, MortonIsAPermutationThatKeepsNeighboursTogether) {
    const TriangleSet set = mixedSet(5000, 3);
    const std::vector<uint32_t> file = numbersInOrder(set, TriangleOrder::file);
    std::vector<uint32_t> morton = numbersInOrder(set, TriangleOrder::morton);
    EXPECT_EQ(file, set.included);
    const auto steps = [&](const std::vector<uint32_t>& order) {
        double sum = 0.0;
        for (size_t i = 1; i < order.size(); i++)
            sum += glm::distance(set.triangles[order[i]].a, set.triangles[order[i - 1]].a);
        return sum;
    };
    EXPECT_LT(steps(morton), 0.3 * steps(file));
    std::sort(morton.begin(), morton.end());
    EXPECT_EQ(morton, file);
    const Box box{{0, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(mortonCode({0, 0, 0}, box), 0u);
    EXPECT_EQ(mortonCode({1, 1, 1}, box), (1u << 30) - 1);
    EXPECT_EQ(mortonCode({0.5f, 0, 0}, box), 1u << 27);
    EXPECT_EQ(mortonCode({0, 0.5f, 0}, box), 1u << 28);
    EXPECT_EQ(mortonCode({0, 0, 0.5f}, box), 1u << 29);
}

}  // namespace cleave::test
