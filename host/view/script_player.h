// Plays a script in a window, step by step, between its frames.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "view/presenter.h"
#include "view/script.h"
#include "view/viewing.h"
#include "view/window.h"

namespace cleave {

class ScriptPlayer {
  public:
    ScriptPlayer(std::vector<ScriptStep> steps, std::string name) : steps_(std::move(steps)), name_(std::move(name)) {}

    // Goes on until a step waits for a frame or for the picture. Throws Error, with the line, where one fails.
    void play(Viewing& viewing, Window& window);
    // True when the last step is done, or it was to quit.
    bool hasEnded() const { return ended_; }
    // True while a step waits for frames: they are to be presented though nothing changes.
    bool needsFrames() const { return framesLeft_ > 0 || !gesture_.empty() || screenshot_; }
    // After each frame that was presented.
    void framePresented();

    // Where the next frame is to go, as a picture; nothing: it is not wanted.
    const std::optional<std::string>& screenshot() const { return screenshot_; }
    bool screenshotsPanels() const { return panels_; }
    // Writes it.
    void keep(const Pixels& shown);

  private:
    std::vector<ScriptStep> steps_;
    std::string name_;
    size_t next_ = 0;
    uint64_t framesLeft_ = 0;
    std::deque<WindowEvent> gesture_;  // an event a frame
    std::optional<std::string> screenshot_;
    std::optional<glm::uvec2> wantedSize_;
    uint32_t sizeTries_ = 0;
    bool panels_ = false;
    bool ended_ = false;

    [[noreturn]] void fail(const ScriptStep& step, const std::string& why) const;
    bool waits(const ScriptStep& step, Viewing& viewing, Window& window);
    void perform(const ScriptStep& step, Viewing& viewing, Window& window);
    void drag(const ScriptStep& step);
    template <class Table>
    auto named(const ScriptStep& step, const Table& table) const;
};

}  // namespace cleave
