// Every builder's tree, through the device's traversal, for one random scene and its rays; three judges.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gpu/device.h"
#include "support/query_case.h"

namespace cleave::test {

// Tells what went wrong first, as text and as code to replay it.
struct QueryFailure {
    size_t ray = 0;
    std::string what;
};

class QueryCheck {
  public:
    explicit QueryCheck(Device& device);
    ~QueryCheck();

    // Closest hits must equal bruteForce's bit for bit, for trees of the GPU builder, of its twin and of every CPU
    // builder; any-hits must be hits where there are some; the exact Reference must agree with bruteForce; invalid rays
    // are misses and counted; no ray is given up; every tree is valid and the twin's tree is the GPU's.
    std::optional<QueryFailure> firstFailure(const QueryCase& c);

    // A smaller case that fails, too: triangles and rays are taken away as long as it does.
    QueryCase shrunk(const QueryCase& failing);

    struct Counts {
        uint64_t scenes = 0;
        uint64_t pairs = 0;      // rays summed over scenes, each shot through every tree
        uint64_t hits = 0;       // of bruteForce
        uint64_t traced = 0;     // rays answered by the device
        uint64_t undecided = 0;  // pairs that the Reference does not decide: a hit at an end of the interval
    };
    const Counts& counts() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave::test
