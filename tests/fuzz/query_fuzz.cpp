// Random scenes with coincidences against the exact reference and brute force, for as many scene-ray pairs as wanted:
//
//   query_fuzz [--pairs N] [--seed S] [--rays R] [--scene K]
//
// Scene K of seed S is always the same one; R rays each (500). Exit status 1 and the smallest scene found, as code, if
// an answer is wrong.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "support/query_check.h"

namespace {

using namespace cleave;
using namespace cleave::test;

struct Arguments {
    uint64_t pairs = 1'000'000;
    uint32_t seed = 1;
    size_t rays = 500;
    std::optional<uint64_t> scene;
};

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        const uint64_t value = i + 1 < argc ? std::stoull(argv[i + 1]) : throw std::invalid_argument(name);
        if (name == "--pairs")
            arguments.pairs = value;
        else if (name == "--seed")
            arguments.seed = static_cast<uint32_t>(value);
        else if (name == "--rays" && value > 0)
            arguments.rays = value;
        else if (name == "--scene")
            arguments.scene = value;
        else
            throw std::invalid_argument(name);
    }
    return arguments;
}

void print(const QueryCase& c, const QueryFailure& failure) {
    std::printf("%s\n", failure.what.c_str());
    for (const Triangle& triangle : c.triangles) std::printf("    %s\n", codeOf(triangle).c_str());
    std::printf("  ray %zu:\n    %s\n", failure.ray, codeOf(c.rays[failure.ray]).c_str());
    const BuildSettings& s = c.settings;
    std::printf("  bins %u, exactUpTo %u, maxDepth %u, leafSize %u, clip %d, axes %d\n", s.bins, s.exactUpTo,
                s.maxDepth, s.leafSize, s.clip, static_cast<int>(s.axes));
}

bool passes(QueryCheck& check, const Arguments& arguments, uint64_t scene) {
    const QueryCase c = queryCase(arguments.seed, scene, arguments.rays);
    const std::optional<QueryFailure> failure = check.firstFailure(c);
    if (!failure) return true;
    std::printf("FAILED: query_fuzz --seed %u --scene %llu --rays %zu: %zu triangles\n", arguments.seed,
                static_cast<unsigned long long>(scene), arguments.rays, c.triangles.size());
    print(c, *failure);
    const QueryCase small = check.shrunk(c);
    if (const std::optional<QueryFailure> same = check.firstFailure(small)) {
        std::printf("smaller, %zu triangles: ", small.triangles.size());
        print(small, *same);
    }
    return false;
}

}  // namespace

int main(int argc, char** argv) try {
    const Arguments arguments = parse(argc, argv);
    const ContextPointer context =
        openDevice(std::getenv("CLEAVE_TEST_DEVICE") ? std::getenv("CLEAVE_TEST_DEVICE") : "");
    QueryCheck check(*context);
    std::printf("seed %u, %zu rays per scene, %s\n", arguments.seed, arguments.rays, deviceName(*context).c_str());
    if (arguments.scene) return passes(check, arguments, *arguments.scene) ? 0 : 1;
    for (uint64_t scene = 0; check.counts().pairs < arguments.pairs; ++scene)
        if (!passes(check, arguments, scene)) return 1;
    const QueryCheck::Counts& n = check.counts();
    std::printf(
        "%llu scenes, %llu scene-ray pairs, %llu of them hits, %llu answers of the device, %llu undecided by the "
        "reference: all as they should be\n",
        static_cast<unsigned long long>(n.scenes), static_cast<unsigned long long>(n.pairs),
        static_cast<unsigned long long>(n.hits), static_cast<unsigned long long>(n.traced),
        static_cast<unsigned long long>(n.undecided));
    return 0;
} catch (const std::invalid_argument& wrong) {
    std::fprintf(stderr, "error: %s is not understood; use query_fuzz [--pairs N] [--seed S] [--rays R] [--scene K]\n",
                 wrong.what());
    return 2;
} catch (const std::exception& failed) {
    std::fprintf(stderr, "error: %s\n", failed.what());
    return 1;
}
