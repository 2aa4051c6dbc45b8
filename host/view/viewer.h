// The interactive window: what the user or a script does goes to the viewing, and what that shows is presented.
#pragma once

namespace cleave {

// Until the window is closed, or its script ends. Returns the exit status, as runProgram() does: 1 for what fails
// before there is a scene to show, and for a step of the script that fails.
int runViewer(int argc, const char* const* argv);

}  // namespace cleave
