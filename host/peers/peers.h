// All peers by name, and how their answers compare with ours.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "peers/peer.h"
#include "peers/triangle_order.h"

namespace cleave {

struct PeerOffer {
    std::string name;  // ray-query, ray-tracing-pipeline, embree, stack-walk-c++
    TriangleOrder order = TriangleOrder::file;
    std::string missing;  // why it is not here; empty: it is
    // Whether rays are so slow that a sample of them has to do.
    bool isSlow = false;
    // Of a scene with triangles that rays can hit. Throws Error.
    std::function<std::unique_ptr<Peer>(Device& device, const PeerScene& scene)> make;
};

// Every peer that cleave knows, those that are not here included.
std::vector<PeerOffer> peersOn(const Device& device);

// How many answers differ from ours: hit or miss, or for closest hits t by more than one in 10,000. Peers compute in
// float, so a few rays that graze an edge may.
uint64_t disagreements(std::span<const Hit> ours, std::span<const Hit> theirs, Query query);

// At most about `most` elements, in whole tiles of 64 that are spread evenly: neighbours stay neighbours.
template <class T>
std::vector<T> sampleOfTiles(std::span<const T> all, size_t most) {
    constexpr size_t kTile = 64;
    const size_t step = (all.size() + most - 1) / most;
    if (step <= 1) return {all.begin(), all.end()};
    std::vector<T> sample;
    for (size_t first = 0; first < all.size(); first += step * kTile)
        for (const T& one : all.subspan(first, std::min(kTile, all.size() - first))) sample.push_back(one);
    return sample;
}

}  // namespace cleave
