// Ctrl-C as a wish: long work ends at the next chance and keeps what it has.
#pragma once

namespace cleave {

// During its lifetime SIGINT and SIGTERM are noted instead of ending the program; a second one does end it. One at a
// time.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool happened() const;
};

}  // namespace cleave
