// Ctrl-C as a wish: long work ends at the next chance and keeps what it has.
#pragma once

#include "base/signal_handlers.h"

namespace cleave {

// During its lifetime SIGINT and SIGTERM are noted instead of ending the program; a second one does end it. One at a
// time.
class Interrupt {
  public:
    Interrupt();
    bool happened() const;

  private:
    SignalHandlers handlers_;
};

}  // namespace cleave
