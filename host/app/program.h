// The program from its arguments to its exit status.
#pragma once

namespace cleave {

// 0: done. 1: failed, with one line "error: what, where, what to do" on stderr. 2: wrong use, also told in one line.
int runProgram(int argc, const char* const* argv);

}  // namespace cleave
