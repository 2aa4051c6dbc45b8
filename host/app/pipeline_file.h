// Keeps compiled pipelines from run to run, in the user's cache folder.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace cleave {

// Nothing where there is no such file.
std::vector<char> loadPipelines(const std::string& key);
// Best effort: without a place to write, the next start compiles again.
void storePipelines(const std::string& key, std::span<const char> data);

}  // namespace cleave
