// Shows the current phase of a long run on one line of the terminal, overwritten as it changes.
#pragma once

#include <string>

namespace cleave {

class Progress {
  public:
    // Shows nothing where stderr is no terminal, so that logs stay clean.
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void phase(const std::string& what);
    // What all phases are part of from now on; empty: nothing.
    void within(const std::string& whole) { whole_ = whole; }
    void clear();  // before anything else is printed

  private:
    bool shown_;
    std::string whole_;
};

}  // namespace cleave
