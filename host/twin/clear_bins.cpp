#include "twin/passes.h"

namespace cleave::twin {

void clearBins(BuildArrays& a, uint32_t depth) {
    std::fill_n(a.bins.begin(), a.state.level[depth].chunkCount * kBinWords, 0u);
}

}  // namespace cleave::twin
