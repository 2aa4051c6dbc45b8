// What must hold of a glTF document before anyone follows its indices; tinygltf checks almost none of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cleave {

// A member that is an array of objects, empty where it is missing. Throws if it is something else.
const nlohmann::json& objectsOf(const nlohmann::json& object, const char* member);

// Throws Error unless: the version is 2; every required extension is known; every index that the loader may follow is a
// whole number within its array; counts and offsets are whole and not negative; transforms have their number of
// entries; and nodes form a forest (no cycle, one parent, scenes list roots, each once).
void checkGltf(const nlohmann::json& document);

}  // namespace cleave
