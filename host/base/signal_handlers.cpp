#include "base/signal_handlers.h"

namespace cleave {

SignalHandlers::SignalHandlers(std::span<const int> signals, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    before_.reserve(signals.size());
    for (const int signal : signals) {
        struct sigaction& before = before_.emplace_back(signal, (struct sigaction){}).second;
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

SignalHandlers::~SignalHandlers() {
    for (const auto& [signal, before] : before_) sigaction(signal, &before, nullptr);
}

}  // namespace cleave
