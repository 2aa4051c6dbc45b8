// Clips a triangle as suits the device; the boxes are the same.
#include "lib/clip_in_registers.glsl"
#include "lib/meet.glsl"

SplitBoxes partsOf(Triangle t, Box box, uint splitAxis, float split) {
    if (kLockstep) return splitBoxesInRegisters(t, box, splitAxis, split);
    return splitBoxes(t, box, splitAxis, split);
}
