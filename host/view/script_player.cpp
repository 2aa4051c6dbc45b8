#include "view/script_player.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/text.h"
#include "facade/host_builders.h"
#include "formats/png.h"
#include "formats/write_file.h"
#include "scene/not_found.h"

namespace cleave {
namespace {

constexpr int kDragFrames = 12;
constexpr uint32_t kMostSizeTries = 200;  // frames until a window should have taken a size

bool isWhole(double number, double least, double most) {
    return number >= least && number <= most && number == static_cast<double>(static_cast<uint64_t>(number));
}

}  // namespace

void ScriptPlayer::fail(const ScriptStep& step, const std::string& why) const {
    throw Error(name_ + ", line " + std::to_string(step.line) + ": " + why);
}

void ScriptPlayer::play(Viewing& viewing, Window& window) {
    bool changed = false;
    while (!ended_ && framesLeft_ == 0 && gesture_.empty() && !screenshot_) {
        if (next_ == steps_.size()) {
            ended_ = true;
            if (!viewing.facts().error.empty()) throw Error(viewing.facts().error);
            return;
        }
        const ScriptStep& step = steps_[next_];
        // What steps have changed is looked at, and asked for, after this.
        const bool isOfState = step.verb == Verb::waitIdle || step.verb == Verb::expectError;
        if ((changed && isOfState) || waits(step, viewing, window)) return;
        ++next_;
        perform(step, viewing, window);
        changed = true;
    }
    if (gesture_.empty()) return;
    viewing.handle(gesture_.front());
    gesture_.pop_front();
    framesLeft_ = std::max<uint64_t>(framesLeft_, 1);
}

void ScriptPlayer::framePresented() {
    if (framesLeft_ > 0) --framesLeft_;
}

// What a step needs before it is performed.
bool ScriptPlayer::waits(const ScriptStep& step, Viewing& viewing, Window& window) {
    const bool hasScene = viewing.facts().staged != nullptr;
    switch (step.verb) {
        case Verb::waitIdle:
            return !viewing.isIdle();
        case Verb::expectError:
            return viewing.facts().error.empty() && (!hasScene || !viewing.isStaged());
        case Verb::size:
            if (!wantedSize_) {
                if (!isWhole(step.numbers[0], 1, 16384) || !isWhole(step.numbers[1], 1, 16384))
                    fail(step, "a window has 1 to 16384 pixels a side");
                wantedSize_ = glm::uvec2(step.numbers[0], step.numbers[1]);
                sizeTries_ = 0;
                window.resize(*wantedSize_);
            }
            if (window.size() == *wantedSize_) return false;
            if (++sizeTries_ > kMostSizeTries) fail(step, "the window does not take this size");
            return true;
        case Verb::quit:
        case Verb::panels:
            return false;
        default:
            return !hasScene;  // which the first scene's camera would be lost on
    }
}

template <class Table>
auto ScriptPlayer::named(const ScriptStep& step, const Table& table) const {
    std::string names;
    for (const auto& [name, value] : table) {
        if (step.text == name) return value;
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    fail(step, "'" + oneLine(step.text) + "' is not known; there is: " + names);
}

void ScriptPlayer::drag(const ScriptStep& step) {
    static constexpr std::array<std::pair<const char*, int>, 3> kButtons = {{{"left", 0}, {"right", 1}, {"middle", 2}}};
    const int button = named(step, kButtons);
    const glm::dvec2 from(step.numbers[0], step.numbers[1]), to(step.numbers[2], step.numbers[3]);
    gesture_.emplace_back(CursorEvent{from});
    gesture_.emplace_back(ButtonEvent{button, true, from});
    for (int i = 1; i <= kDragFrames; ++i)
        gesture_.emplace_back(CursorEvent{glm::mix(from, to, static_cast<double>(i) / kDragFrames)});
    gesture_.emplace_back(ButtonEvent{button, false, to});
}

void ScriptPlayer::perform(const ScriptStep& step, Viewing& viewing, Window&) {
    const glm::dvec3 point(step.numbers[0], step.numbers[1], step.numbers[2]);
    Controls& controls = viewing.controls;
    switch (step.verb) {
        case Verb::size:
            wantedSize_.reset();
            break;
        case Verb::eye:
            viewing.place(point, std::nullopt);
            break;
        case Verb::look:
            viewing.place(std::nullopt, point);
            break;
        case Verb::camera:
            try {
                viewing.chooseCamera(step.text);
            } catch (const NotFound& none) {
                fail(step, none.what());
            }
            break;
        case Verb::view:
            controls.view = named(step, kViews);
            controls.compares = false;
            break;
        case Verb::builder: {
            std::string names;
            bool known = false;
            for (const auto& [name, description] : allBuilders()) {
                if (name == step.text) {
                    controls.stage.builder = {name};
                    known = true;
                }
                names += (names.empty() ? "" : ", ") + std::string(name);
            }
            if (!known) fail(step, "'" + oneLine(step.text) + "' is not known; there is: " + names);
            break;
        }
        case Verb::traversal:
            controls.traversal = named(step, kTraversals);
            break;
        case Verb::key: {
            const std::optional<int> key = keyNamed(step.text);
            if (!key)
                fail(step, "there is no key '" + oneLine(step.text) + "'; a letter, a digit, space, escape, [ or ]");
            gesture_.emplace_back(KeyEvent{*key, true});
            gesture_.emplace_back(KeyEvent{*key, false});
            break;
        }
        case Verb::drag:
            drag(step);
            break;
        case Verb::doubleClick:
            for (const bool isDown : {true, false, true, false})
                viewing.handle(ButtonEvent{0, isDown, glm::dvec2(point)});
            break;
        case Verb::hover:
            gesture_.emplace_back(CursorEvent{glm::dvec2(point)});
            break;
        case Verb::scroll:
            viewing.handle(ScrollEvent{step.numbers[0]});
            break;
        case Verb::drop:
            viewing.handle(DropEvent{step.text});
            break;
        case Verb::time:
            controls.plays = false;
            controls.stage.time = step.numbers[0];
            break;
        case Verb::play:
            controls.plays = true;
            break;
        case Verb::pause:
            controls.plays = false;
            break;
        case Verb::panels:
            panels_ = step.numbers[0] != 0.0;
            break;
        case Verb::overlay:
            if (!isWhole(step.numbers[0], 0, 16)) fail(step, "cells are drawn down to levels 0 to 16");
            controls.overlayLevel = static_cast<uint32_t>(step.numbers[0]);
            break;
        case Verb::waitFrames:
            if (!isWhole(step.numbers[0], 0, 1e9)) fail(step, "a number of frames is whole");
            framesLeft_ = static_cast<uint64_t>(step.numbers[0]);
            break;
        case Verb::waitIdle:
            break;
        case Verb::screenshot:
            screenshot_ = step.text;
            break;
        case Verb::expectError:
            if (viewing.facts().error.empty()) fail(step, "an error was expected, and there is none");
            viewing.forgetError();
            break;
        case Verb::quit:
            ended_ = true;
            if (!viewing.facts().error.empty()) fail(step, "there was an error: " + viewing.facts().error);
            break;
    }
}

void ScriptPlayer::keep(const Pixels& shown) {
    const std::string file = *screenshot_;
    screenshot_.reset();
    try {
        writeFile(file, pngOf(shown.width, shown.height, shown.values));
    } catch (const Error& error) {
        fail(steps_[next_ - 1], error.what());
    }
}

}  // namespace cleave
