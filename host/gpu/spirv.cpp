#include "gpu/spirv.h"

#include <map>

#include "base/error.h"

namespace cleave {

namespace {
// A function's static, since entries of other files may register before this file's statics exist.
std::map<std::string, std::span<const uint32_t>>& table() {
    static std::map<std::string, std::span<const uint32_t>> kernels;
    return kernels;
}
}  // namespace

SpirvEntry::SpirvEntry(const char* name, std::span<const uint32_t> words) { table()[name] = words; }

std::span<const uint32_t> spirv(const std::string& name) {
    auto it = table().find(name);
    if (it == table().end()) throw Error("kernel " + name + " is not part of this program; rebuild it");
    return it->second;
}

}  // namespace cleave
