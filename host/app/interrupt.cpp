#include "app/interrupt.h"

#include <array>

namespace cleave {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};

volatile std::sig_atomic_t noted = 0;

void note(int) { noted = 1; }

// What was noted before is forgotten before the handlers are there, so that no signal is lost.
void (*notingAnew())(int) {
    noted = 0;
    return note;
}

}  // namespace

Interrupt::Interrupt() : handlers_(kSignals, notingAnew(), static_cast<int>(SA_RESETHAND)) {}

bool Interrupt::happened() const { return noted != 0; }

}  // namespace cleave
