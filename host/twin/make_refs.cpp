#include "twin/passes.h"

namespace cleave::twin {

void makeRefs(BuildArrays& a) {
    for (size_t i = 0; i < a.set->included.size(); i++) {
        const uint32_t prim = a.set->included[i];
        const Box b = triangleBox(a.set->triangles[prim]);
        a.refs[0][i] = PrimRef{b.lo, prim, b.hi, 0};
    }
}

}  // namespace cleave::twin
