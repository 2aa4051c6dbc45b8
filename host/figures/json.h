// The figures of a run as JSON. Scripts rely on the keys.
#pragma once

#include <nlohmann/json.hpp>

#include "figures/built_tree.h"

namespace cleave {

using Json = nlohmann::ordered_json;

Json buildJson(const BuiltTree& built);
// Closest or any hits of `rays` rays in `ms` milliseconds.
Json traceJson(Traversal traversal, TriangleTest test, uint64_t rays, double ms, uint64_t invalidRays,
               uint64_t cappedRays);
Json checkJson(const CheckResult& result);

// A finite number, or null: JSON knows no infinity.
Json numberJson(double value);
Json numberJson(std::optional<double> value);

}  // namespace cleave
