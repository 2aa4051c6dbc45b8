// What signals do for a while.
#pragma once

#include <csignal>
#include <span>
#include <utility>
#include <vector>

namespace cleave {

// During its lifetime `handler` is called at these signals. One that is ignored (nohup) stays ignored.
class SignalHandlers {
  public:
    SignalHandlers(std::span<const int> signals, void (*handler)(int), int flags = 0);
    ~SignalHandlers();
    SignalHandlers(const SignalHandlers&) = delete;
    SignalHandlers& operator=(const SignalHandlers&) = delete;

  private:
    std::vector<std::pair<int, struct sigaction>> before_;
};

}  // namespace cleave
