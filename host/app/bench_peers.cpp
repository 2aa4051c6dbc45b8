#include "app/bench_peers.h"

#include "base/error.h"
#include "base/warm_up.h"
#include "peers/peers.h"

namespace cleave {
namespace {

constexpr size_t kRaysOfSlowPeers = 65536;

PeerSetFigures measure(Peer& peer, const RaySet& set, size_t most, uint32_t runs) {
    PeerSetFigures figures;
    if (set.rays.empty()) return figures;
    const std::vector<Ray> rays = sampleOfTiles(std::span(set.rays), most);
    const std::vector<Hit> ours = sampleOfTiles(std::span(set.hits), most);
    figures.rays = rays.size();
    figures.disagreements = disagreements(ours, peer.trace(rays, set.query).hits, set.query);
    if (!figures.isWrong()) figures.runs = peer.time(rays, set.query, runs);
    return figures;
}

void measureAll(Run& run, const PeerOffer& offer, const PeerScene& scene, const RaySets& sets, PeerFigures& figures) {
    const std::string phase = offer.name + " (" + figures.order + ")";
    run.progress.phase("building for " + phase);
    const std::unique_ptr<Peer> peer = offer.make(run.device.device(), scene);
    warmUp([&] { peer->build(); });
    for (uint32_t i = 0; i < run.options.runs; ++i) figures.buildRuns.push_back(peer->build());
    run.progress.phase("timing " + phase);
    for (size_t i = 0; i < sets.size(); ++i)
        figures.sets[i] =
            measure(*peer, sets[i], offer.isSlow ? kRaysOfSlowPeers : sets[i].rays.size(), run.options.runs);
}

}  // namespace

std::vector<PeerFigures> benchPeers(Run& run, const Session& session, const BuiltTree& built, const RaySets& sets) {
    const PeerScene scene{session.posed().triangles, session.set(), built.tree, built.ms, run.options.settings.threads};
    std::vector<PeerFigures> all;
    for (const PeerOffer& offer : peersOn(run.device.device())) {
        PeerFigures figures;
        figures.name = offer.name;
        figures.order = offer.order == TriangleOrder::file ? "file" : "morton";
        figures.missing = offer.missing;
        if (figures.missing.empty() && session.set().included.empty()) figures.missing = "the scene has no triangle";
        try {
            if (figures.missing.empty()) measureAll(run, offer, scene, sets, figures);
        } catch (const Error& error) {  // a peer that fails here is a finding, not the end of ours
            figures = {offer.name, figures.order, error.what(), {}, {}};
        }
        all.push_back(std::move(figures));
    }
    run.progress.clear();
    return all;
}

}  // namespace cleave
