// Where the invocations of a workgroup wait for each other.
#ifndef CLEAVE_LIB_MEET
#define CLEAVE_LIB_MEET

// True where a workgroup runs in lockstep, so that nobody has to wait. A barrier is expensive on CPUs even if it is
// free: lavapipe makes a coroutine of a kernel that has one, with all its variables in memory.
layout(constant_id = 1) const bool kLockstep = false;

// What was written to shared memory before is seen by all after.
void meet() {
    memoryBarrierShared();
    if (!kLockstep) barrier();
}
// What was written to any memory.
void meetInMemory() {
    memoryBarrierBuffer();
    meet();
}
#endif
