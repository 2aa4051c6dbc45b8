#include "twin/passes.h"

namespace cleave::twin {

void offsets(BuildArrays& a, uint32_t depth) {
    const uint32_t count = a.state.level[depth].refCount;
    glm::uvec2 before(0);
    for (uint32_t i = 0; i < count; i++) {
        a.offsets[i] = before;
        before.x += (a.sides[i] & kLeft) ? 1 : 0;
        before.y += (a.sides[i] & kRight) ? 1 : 0;
    }
    if (count > 0) a.offsets[count] = before;
}

}  // namespace cleave::twin
