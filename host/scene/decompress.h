// Decompresses what a scene holds compressed; afterwards its bufferViews and accessors hold plain data.
#pragma once

#include <cstddef>

#include "scene/shown_parts.h"

namespace cleave {

// The bytes that compressed data may still become. A small file can ask for any amount.
struct DecompressionBudget {
    size_t bytes = 0;
};

// Throws Error if compressed data is broken, does not match what the document says of it, or would become more than
// `mostTriangles` have use for. Only what is to be read, and is there, is decompressed.
void decompress(Scene& scene, const ShownParts& read, size_t mostTriangles);

// The parts of decompress.
void decompressMeshopt(Scene& scene, const ShownParts& read, DecompressionBudget& budget);
void decompressDraco(Scene& scene, const ShownParts& read, DecompressionBudget& budget);

// Throws Error if `bytes` are more than what is left; `where` names what asks for them.
void spend(DecompressionBudget& budget, size_t bytes, const std::string& where);

}  // namespace cleave
