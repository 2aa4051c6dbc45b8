#include "twin/passes.h"

namespace cleave::twin {

namespace {

void include(SceneState& scene, const Triangle& t) {
    const Box b = triangleBox(t);
    for (int axis = 0; axis < 3; axis++) {
        scene.boundsBits[axis] = std::max(scene.boundsBits[axis], ~orderedBits(b.lo[axis]));
        scene.boundsBits[3 + axis] = std::max(scene.boundsBits[3 + axis], orderedBits(b.hi[axis]));
    }
}

}  // namespace

void loadTriangles(BuildArrays& a, uint32_t) {
    SceneState& scene = a.state.scene;
    const int exponent = sceneExponent(scene.largest);
    std::fill_n(a.blockSums.begin(), ceilDiv(a.args.triangleCount, kBlock), glm::uvec4(0));
    for (uint32_t i = 0; i < a.args.triangleCount; i++) {
        const uint32_t number = triangleNumber(a, i);
        const bool finite = isFiniteTriangle(a.world[number]);
        const Triangle t = finite ? scaledTriangle(a.world[number], -exponent) : Triangle{};
        const bool included = finite && !liesOnALine(t);
        if (!finite)
            scene.nonFinite++;
        else if (!included)
            scene.noArea++;
        else
            include(scene, t);
        a.triangles[i] = treeTriangle(included ? t : Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)}, number);
        a.sides[i] = included ? 1 : 0;
        a.blockSums[i / kBlock].x += a.sides[i];
    }
}

}  // namespace cleave::twin
