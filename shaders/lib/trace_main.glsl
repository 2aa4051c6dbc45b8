// The body of a trace kernel, whichever traverse() it has included.

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    Ray ray = push.rays.at[i];
    StepCount steps = StepCount(0u, 0u, 0u, 0u, 0u, 0u);
    Hit hit = missedHit();
    if (isValidRay(ray)) {
        ScaledRay scaled = scaledRay(ray, push.exponent);
        bool capped;
        hit = worldHit(traverse(scaled, steps, capped), scaled.tExponent);
        if (capped) atomicAdd(push.counters.at.cappedRays, 1u);
    } else {
        atomicAdd(push.counters.at.invalidRays, 1u);
    }
    push.hits.at[i] = hit;
    if (kCountSteps) push.steps.at[i] = steps;
}
