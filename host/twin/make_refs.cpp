#include "twin/passes.h"

namespace cleave::twin {

void makeRefs(BuildArrays& a, uint32_t) {
    size_t next = 0;
    for (uint32_t i = 0; i < a.args.triangleCount; i++) {
        if (a.sides[i] == 0) continue;
        const Box b = triangleBox(withoutNumber(a.triangles[i]));
        a.refs0[next++] = PrimRef{b.lo, i, b.hi, 0};
    }
}

}  // namespace cleave::twin
