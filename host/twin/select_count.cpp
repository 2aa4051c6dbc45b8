#include "twin/render.h"

namespace cleave::twin {

void selectCount(PictureArrays& a, PassNumbers numbers) {
    PictureState& s = a.state;
    uint32_t total = 0;
    for (const uint32_t n : s.histogram) total += n;
    if (numbers.round == 0) s.rank = scaleRank(total);
    uint32_t byte = 0;
    while (byte < 255 && s.rank >= s.histogram[byte]) s.rank -= s.histogram[byte++];
    s.prefix = s.prefix << 8 | byte;
    std::fill(std::begin(s.histogram), std::end(s.histogram), 0u);
    if (numbers.round < 3 || total == 0) return;
    s.lowBits = ~orderedBits(0.0f);
    s.highBits = orderedBits(static_cast<float>(s.prefix));
}

}  // namespace cleave::twin
