// Threads that work beside the window give way to it.
#pragma once

#include <sys/resource.h>

namespace cleave {

// Of the calling thread and those that it starts, a driver's on the CPU among them, whose devices are opened by it. On
// Linux niceness is a thread's own. Where it cannot be had, the window waits a little more often.
inline void giveWay(int niceness) { (void)setpriority(PRIO_PROCESS, 0, niceness); }

}  // namespace cleave
