// A script that drives the window: a line a step.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave {

enum class Verb {
    size,         // W H: of the picture, in pixels
    eye,          // x y z: look from here
    look,         // x y z: look at this point
    camera,       // NAME
    view,         // NAME
    builder,      // NAME
    traversal,    // NAME
    key,          // K: presses and releases it
    drag,         // BUTTON x0 y0 x1 y1: left, right or middle, in pixels of the picture
    doubleClick,  // x y
    hover,        // x y: moves the cursor there
    scroll,       // N: steps of the wheel, away from the user
    drop,         // FILE: as if it were dropped on the window
    time,         // S: the animation's
    play,
    pause,
    panels,       // on|off: whether screenshots show them
    overlay,      // N: the tree's cells down to that level; 0: none
    waitFrames,   // wait frames N: until so many more are presented
    waitIdle,     // wait idle: until the picture is as good as `cleave render` makes it
    screenshot,   // FILE.png
    expectError,  // expect error: fails unless an error is shown, and takes it away
    quit
};

struct ScriptStep {
    Verb verb{};
    uint32_t line = 0;  // from 1
    std::string text;   // a name or a file
    std::array<double, 4> numbers{};
};

// Throws Error, which names the line, for what is no step.
std::vector<ScriptStep> parseScript(const std::string& text, const std::string& name);
std::vector<ScriptStep> readScript(const std::filesystem::path& file);

}  // namespace cleave
