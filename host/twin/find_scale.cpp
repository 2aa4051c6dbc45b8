#include "twin/passes.h"

namespace cleave::twin {

uint32_t triangleNumber(const BuildArrays& a, uint32_t index) { return a.list.empty() ? index : a.list[index]; }

void findScale(BuildArrays& a, uint32_t) {
    for (uint32_t i = 0; i < a.args.triangleCount; i++) {
        const Triangle& t = a.world[triangleNumber(a, i)];
        for (const vec3& v : {t.a, t.b, t.c}) a.state.scene.largest = std::max(a.state.scene.largest, reachOf(v));
    }
}

}  // namespace cleave::twin
