#include "app/interrupt.h"

#include <signal.h>

#include <array>

namespace cleave {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};

volatile sig_atomic_t noted = 0;
std::array<struct sigaction, kSignals.size()> before;

void note(int) { noted = 1; }

}  // namespace

Interrupt::Interrupt() {
    noted = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before[i]);
        // A signal that is ignored (nohup) stays ignored.
        if (before[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
}

Interrupt::~Interrupt() {
    for (size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

bool Interrupt::happened() const { return noted != 0; }

}  // namespace cleave
