#include "scene/decompress.h"

#include "scene/refuse.h"

namespace cleave {
namespace {

// An index list takes 12 of them, and a vertex that no other triangle shares, with all of its attributes, about 40.
constexpr size_t kBytesPerTriangle = 128;

}  // namespace

void decompress(Scene& scene, const ShownParts& read, size_t mostTriangles) {
    DecompressionBudget budget{kBytesPerTriangle * mostTriangles};
    decompressMeshopt(scene, read, budget);
    decompressDraco(scene, read, budget);
}

void spend(DecompressionBudget& budget, size_t bytes, const std::string& where) {
    if (bytes > budget.bytes)
        refuseGltf(where + " would be decompressed to " + std::to_string(bytes) + " bytes, and " +
                       std::to_string(budget.bytes) + " is the most that is left for the scene",
                   "split it");
    budget.bytes -= bytes;
}

}  // namespace cleave
