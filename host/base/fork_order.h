// What the thread sanitizer must be told of tasks that a library starts and waits for, since it does not see into
// libraries that were compiled without it: all before fork() comes before each task, and each task before all after
// join(). It says nothing of tasks among each other: those races it still finds. In other builds this is empty.
#pragma once

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#define CLEAVE_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CLEAVE_THREAD_SANITIZER
#endif
#endif

#ifdef CLEAVE_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#define CLEAVE_NO_THREAD_SANITIZER __attribute__((no_sanitize("thread")))
#else
#define CLEAVE_NO_THREAD_SANITIZER
#endif

namespace cleave {

class ForkOrder {
  public:
    // Calls body(i) as one of the tasks. How the task comes by its arguments is the library's business, and not
    // watched.
    template <class Body>
    struct Task {
        ForkOrder* order;
        const Body* body;
        CLEAVE_NO_THREAD_SANITIZER void operator()(size_t i) const {
            order->begin();
            (*body)(i);
            order->end();
        }
    };

#ifdef CLEAVE_THREAD_SANITIZER
    void fork() { __tsan_release(&forked_); }
    void begin() { __tsan_acquire(&forked_); }
    void end() { __tsan_release(&ended_); }
    void join() { __tsan_acquire(&ended_); }

  private:
    char forked_ = 0, ended_ = 0;
#else
    void fork() {}
    void begin() {}
    void end() {}
    void join() {}
#endif
};

}  // namespace cleave
