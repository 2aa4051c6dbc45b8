// What is looked at, and how: the state of the window without the window. Events change it; it makes wishes of that to
// the stage and the painter, and takes what these have made.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/options.h"
#include "base/stopwatch.h"
#include "view/controls.h"
#include "view/navigation.h"
#include "view/window.h"

namespace cleave {

class Viewing {
  public:
    // `wake`: called by any thread when there is something new to take.
    Viewing(const Options& options, std::function<void()> wake);

    Controls controls;
    const Facts& facts() const { return facts_; }

    // What the user does where no panel takes it.
    void handle(const WindowEvent& event);
    // Takes what is new and asks for what is wanted, for a picture of `size`. Throws Error where the first scene cannot
    // be shown.
    void update(glm::uvec2 size);

    // The newest picture, once.
    std::shared_ptr<const Painted> takePicture();
    // True if the picture is as good as it gets, and of what is wanted.
    bool isIdle() const;
    // True while pictures at once are wanted.
    bool moves() const;
    // The number of what was asked of the painter last.
    uint64_t wished() const { return paintAsked_.number; }
    bool isStaged() const { return handled_ == stageAsked_.number; }

    // Throws NotFound if there is no such camera.
    void chooseCamera(const std::string& nameOrIndex);
    void place(const std::optional<glm::dvec3>& eye, const std::optional<glm::dvec3>& look);
    void open(const std::filesystem::path& file);
    void forgetError() { facts_.error.clear(); }
    // What a terminal takes to make this picture.
    std::string renderCommand() const;
    // A text for the clipboard, once.
    std::string takeCopied() { return std::exchange(copied_, {}); }

  private:
    const Options& options_;
    Facts facts_;
    Navigation navigation_;
    std::string camera_;  // of the scene, by name or index; empty: the first, or the default one
    glm::uvec2 size_{0};

    std::set<int> buttons_, keys_;  // that are down
    glm::dvec2 cursor_{0.0};
    Stopwatch clock_;
    double movedAt_ = -1e9;  // ms of the clock
    double updatedAt_ = 0.0;
    double notedAt_ = 0.0;
    double pressedAt_ = -1e9;
    double played_ = 0.0;  // seconds since the time was asked for
    glm::dvec2 pressedCursor_{-1e9};
    std::string copied_;

    StageWish stageAsked_;
    uint64_t handled_ = 0;  // of the stage's wishes, when it was looked at
    PaintWish paintAsked_;
    uint64_t picks_ = 0, picked_ = 0;  // asked for, answered
    std::shared_ptr<const Painted> fresh_;

    // Last, so that its threads end first.
    Stage stage_;
    Painter painter_;

    void note(const std::string& text);
    void press(const ButtonEvent& event);
    void dragTo(const glm::dvec2& at);
    void press(int key);
    void takeStaged();
    void takePainted();
    void fly(double seconds);
    void play(double seconds);
    void askStage();
    void askPainter();
    void lookFrom(const Camera& camera, const std::string& renderOptions);
    void resetCamera(const ViewOverrides& overrides);
    Ray rayAt(const glm::dvec2& at) const;
    std::vector<PassedLeaf> leavesUnderCursor(const Staged& staged) const;
    void pickAt(const glm::dvec2& at);
};

}  // namespace cleave
