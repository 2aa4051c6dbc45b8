#include "view/viewing.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>

#include "app/option_values.h"
#include "base/error.h"
#include "base/text.h"
#include "scene/not_found.h"

namespace cleave {
namespace {

constexpr double kRestMs = 150.0;         // after the last motion, before a whole picture is made
constexpr double kDoubleClickMs = 350.0;  // between its clicks
constexpr double kNoteMs = 2500.0;
constexpr double kDiagonalsPerSecond = 0.25;
constexpr uint32_t kDeepestOverlay = 16;

bool sameCamera(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.forward == b.forward && a.up == b.up && a.orthographic == b.orthographic &&
           a.verticalFov == b.verticalFov && a.orthographicHeight == b.orthographicHeight;
}

bool sameScene(const std::shared_ptr<const Staged>& a, const std::shared_ptr<const Staged>& b) {
    return a && b && a->geometry == b->geometry && sameTrees(*a, *b) && a->surfaces == b->surfaces;
}

bool samePicture(const PaintWish& a, const PaintWish& b) {
    return sameScene(a.staged, b.staged) && sameCamera(a.camera, b.camera) && a.width == b.width &&
           a.height == b.height && a.view == b.view && a.samples == b.samples && a.bounces == b.bounces &&
           a.exposure == b.exposure && a.traversal == b.traversal && a.test == b.test && a.moves == b.moves &&
           a.compares == b.compares;
}

}  // namespace

Viewing::Viewing(const Options& options, std::function<void()> wake)
    : options_(options), camera_(options.camera), stage_(options.device, wake), painter_(options.device, wake) {
    controls.stage.file = options.scenes.front();
    controls.stage.animation = options.animation;
    controls.stage.time = options.time;
    controls.stage.builder = options.builders.front();
    controls.stage.settings = options.settings;
    controls.view = options.view;
    controls.samples = options.samples;
    controls.bounces = options.bounces;
    controls.exposure = std::log2(options.exposure);
    if (!options.traversals.empty()) controls.traversal = options.traversals.front();
    controls.test = options.triangleTests.front();
}

void Viewing::note(const std::string& text) {
    facts_.note = text;
    notedAt_ = clock_.milliseconds();
}

bool Viewing::moves() const { return controls.plays || !keys_.empty() || clock_.milliseconds() - movedAt_ < kRestMs; }

bool Viewing::isIdle() const {
    const std::shared_ptr<const Painted>& shown = facts_.painted;
    return !moves() && isStaged() && picked_ == picks_ && shown && !fresh_ && shown->number == paintAsked_.number &&
           shown->isDone;
}

std::shared_ptr<const Painted> Viewing::takePicture() { return std::exchange(fresh_, nullptr); }

void Viewing::lookFrom(const Camera& camera, const std::string& renderOptions) {
    navigation_.take(camera, facts_.staged->scene->restBounds, renderOptions);
}

void Viewing::resetCamera(const ViewOverrides& overrides) {
    const Staged& staged = *facts_.staged;
    const Box& bounds = staged.scene->restBounds;
    const Camera camera = overridden(cleave::chooseCamera(staged.geometry->posed, bounds, camera_), bounds, overrides);
    std::string told = camera_.empty() ? "" : "--camera " + shellWord(camera_);
    const auto add = [&](const char* option, const std::string& value) {
        told += (told.empty() ? "" : " ") + std::string(option) + " " + value;
    };
    if (overrides.eye) add("--eye", exactText(*overrides.eye));
    if (overrides.look) add("--look", exactText(*overrides.look));
    if (overrides.verticalFov && options_.fov) add("--fov", exactText(*options_.fov));
    lookFrom(camera, told);
}

void Viewing::chooseCamera(const std::string& nameOrIndex) {
    const std::string before = std::exchange(camera_, nameOrIndex);
    try {
        if (facts_.staged) resetCamera({});
    } catch (const NotFound&) {
        camera_ = before;
        throw;
    }
}

void Viewing::place(const std::optional<glm::dvec3>& eye, const std::optional<glm::dvec3>& look) {
    navigation_.place(eye.value_or(navigation_.camera().eye), look.value_or(navigation_.pivot()));
}

void Viewing::open(const std::filesystem::path& file) {
    facts_.error.clear();
    controls.stage.file = file;
    controls.stage.animation.clear();
    controls.stage.time.reset();
    controls.plays = false;
}

std::string Viewing::renderCommand() const {
    const auto nameIn = [](const auto& table, const auto& value) {
        for (const auto& [name, known] : table)
            if (known == value) return std::string(name);
        return std::string();
    };
    std::string command = "cleave render " + shellWord(controls.stage.file.string()) + " --size " +
                          std::to_string(size_.x) + "x" + std::to_string(size_.y) + " --view " +
                          nameIn(kViews, controls.view);
    if (controls.samples) command += " --spp " + std::to_string(*controls.samples);
    if (controls.view == View::path && controls.bounces != 8)
        command += " --bounces " + std::to_string(controls.bounces);
    if (controls.exposure != 0.0f) command += " --exposure " + exactText(double{controls.exposure});
    if (controls.stage.time) command += " --time " + exactText(*controls.stage.time);
    if (controls.stage.time && !controls.stage.animation.empty())
        command += " --animation " + shellWord(controls.stage.animation);
    if (!(controls.stage.builder == Builder::gpu)) command += " --builder " + nameOf(controls.stage.builder);
    if (controls.traversal != kDefaultTraversal) command += " --traversal " + nameOf(controls.traversal);
    const std::string camera = navigation_.renderOptions();
    return camera.empty() ? command : command + " " + camera;
}

Ray Viewing::rayAt(const glm::dvec2& at) const {
    return imageRay(imageCamera(navigation_.camera(), std::max(size_.x, 1u), std::max(size_.y, 1u), infinity()), at.x,
                    at.y);
}

void Viewing::pickAt(const glm::dvec2& at) { painter_.pick(++picks_, rayAt(at)); }

void Viewing::handle(const WindowEvent& event) {
    if (const auto* button = std::get_if<ButtonEvent>(&event)) press(*button);
    if (const auto* cursor = std::get_if<CursorEvent>(&event)) dragTo(cursor->at);
    if (const auto* drop = std::get_if<DropEvent>(&event)) open(drop->file);
    if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
        navigation_.zoom(scroll->steps);
        movedAt_ = clock_.milliseconds();
    }
    if (const auto* key = std::get_if<KeyEvent>(&event)) {
        static const std::set<int> kFlying{GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E};
        const bool flies = kFlying.contains(key->key);
        if (!key->isDown || !flies) keys_.erase(key->key);
        if (key->isDown && flies) keys_.insert(key->key);
        if (key->key == GLFW_KEY_LEFT_SHIFT || key->key == GLFW_KEY_RIGHT_SHIFT) {
            if (key->isDown)
                buttons_.insert(-1);
            else
                buttons_.erase(-1);
        } else if (key->isDown && !flies) {
            press(key->key);
        }
    }
}

void Viewing::press(const ButtonEvent& event) {
    cursor_ = event.at;
    if (!event.isDown) {
        buttons_.erase(event.button);
        return;
    }
    buttons_.insert(event.button);
    if (event.button != GLFW_MOUSE_BUTTON_LEFT) return;
    const double now = clock_.milliseconds();
    const bool isDouble = now - pressedAt_ < kDoubleClickMs && glm::length(event.at - pressedCursor_) < 6.0;
    pressedAt_ = isDouble ? -1e9 : now;
    pressedCursor_ = event.at;
    if (isDouble) pickAt(event.at);
}

void Viewing::dragTo(const glm::dvec2& at) {
    const glm::dvec2 way = (at - cursor_) / static_cast<double>(std::max(size_.y, 1u));
    cursor_ = at;
    if (buttons_.contains(GLFW_MOUSE_BUTTON_LEFT))
        navigation_.orbit(way.x * std::numbers::pi, way.y * std::numbers::pi);
    else if (buttons_.contains(GLFW_MOUSE_BUTTON_RIGHT) || buttons_.contains(GLFW_MOUSE_BUTTON_MIDDLE))
        navigation_.pan(way.x, -way.y);
    else
        return;
    movedAt_ = clock_.milliseconds();
}

void Viewing::press(int key) {
    switch (key) {
        case GLFW_KEY_F:
            if (facts_.staged && size_.y > 0)
                navigation_.frame(facts_.staged->geometry->bounds, static_cast<double>(size_.x) / size_.y);
            break;
        case GLFW_KEY_C:
            copied_ = renderCommand();
            note("copied: " + copied_);
            break;
        case GLFW_KEY_H:
            controls.keys = !controls.keys;
            break;
        case GLFW_KEY_P:
            controls.panel = !controls.panel;
            break;
        case GLFW_KEY_T:
            controls.overlayLevel = controls.overlayLevel == 0 ? 8 : 0;
            break;
        case GLFW_KEY_LEFT_BRACKET:
            controls.overlayLevel -= controls.overlayLevel > 0 ? 1 : 0;
            break;
        case GLFW_KEY_RIGHT_BRACKET:
            controls.overlayLevel += controls.overlayLevel < kDeepestOverlay ? 1 : 0;
            break;
        case GLFW_KEY_R:
            controls.rayCells = !controls.rayCells;
            break;
        case GLFW_KEY_X:
            controls.compares = !controls.compares;
            break;
        case GLFW_KEY_SPACE:
            controls.plays = !controls.plays;
            break;
        case GLFW_KEY_ESCAPE:
            controls.keys = false;
            forgetError();
            break;
        default:
            if (key < GLFW_KEY_1 || key > GLFW_KEY_9 || !facts_.staged) break;
            const auto index = static_cast<size_t>(key - GLFW_KEY_1);
            const std::vector<Camera>& cameras = facts_.staged->geometry->posed.cameras;
            if (index < cameras.size())
                chooseCamera(std::to_string(index));
            else
                note("the scene has " + std::to_string(cameras.size()) + " cameras");
    }
}

void Viewing::update(glm::uvec2 size) {
    size_ = size;
    const double now = clock_.milliseconds();
    const double seconds = 1e-3 * (now - updatedAt_);
    updatedAt_ = now;
    if (now - notedAt_ > kNoteMs) facts_.note.clear();
    takeStaged();
    takePainted();
    fly(seconds);
    play(seconds);
    askStage();
    askPainter();
    facts_.phase = stage_.phase();
    facts_.deviceBytes = stage_.deviceBytes() + painter_.deviceBytes();
    facts_.leaves.clear();
    if (controls.rayCells && facts_.painted) facts_.leaves = leavesUnderCursor(*facts_.painted->staged);
}

std::vector<PassedLeaf> Viewing::leavesUnderCursor(const Staged& staged) const {
    std::vector<PassedLeaf> leaves;
    for (const StagedTree& tree : staged.trees) {
        const std::vector<PassedLeaf> own = leavesAlong(*tree.tree, rayAt(cursor_));
        leaves.insert(leaves.end(), own.begin(), own.end());
    }
    std::ranges::stable_sort(leaves, {}, &PassedLeaf::entry);
    return leaves;
}

void Viewing::takeStaged() {
    handled_ = stage_.handled();  // first: what is there then is of this wish, or of a later one
    if (const std::optional<std::string> error = stage_.takeError()) {
        const std::shared_ptr<const Staged> there = stage_.latest();
        if (!there) throw Error(*error);
        facts_.error = *error;
        if (isStaged()) {  // what is there stays
            controls.stage.file = there->scene->file;
            controls.stage.time = there->time;
            controls.stage.builder = there->builder;
            controls.stage.settings = there->settings;
            controls.plays = false;
        }
    }
    const std::shared_ptr<const Staged> before = std::exchange(facts_.staged, stage_.latest());
    const std::shared_ptr<const Staged>& staged = facts_.staged;
    if (!staged) return;
    if (!before) {
        ViewOverrides overrides{options_.eye, options_.look, std::nullopt};
        if (options_.fov) overrides.verticalFov = glm::radians(*options_.fov);
        resetCamera(overrides);
    } else if (before->scene != staged->scene) {
        camera_.clear();
        resetCamera({});
    } else if (before->geometry != staged->geometry && !navigation_.isMoved() && !camera_.empty()) {
        resetCamera({});  // it may have moved with its node
    }
}

void Viewing::takePainted() {
    if (const std::optional<std::string> error = painter_.takeError()) {
        facts_.error = *error;
        if (!facts_.painted && !fresh_) throw Error(*error);
    }
    if (std::shared_ptr<const Painted> painted = painter_.take()) {
        const bool isOther = !facts_.painted || facts_.painted->number != painted->number;
        if (isOther && painted->moves) {
            facts_.frameMs.push_back(static_cast<float>(painted->ms));
            if (facts_.frameMs.size() > 120) facts_.frameMs.pop_front();
        }
        facts_.painted = fresh_ = std::move(painted);
    }
    if (const std::optional<Picked> picked = painter_.takePicked(); picked && picked->number == picks_) {
        picked_ = picks_;
        if (picked->hits)
            navigation_.lookAtPoint(picked->point);
        else
            note("there is nothing to turn about");
    }
}

void Viewing::fly(double seconds) {
    const auto along = [&](int ahead, int back) {
        return (keys_.contains(ahead) ? 1.0 : 0.0) - (keys_.contains(back) ? 1.0 : 0.0);
    };
    const glm::dvec3 way(along(GLFW_KEY_D, GLFW_KEY_A), along(GLFW_KEY_E, GLFW_KEY_Q), along(GLFW_KEY_W, GLFW_KEY_S));
    if (way == glm::dvec3(0.0)) return;
    const double speed = kDiagonalsPerSecond * (buttons_.contains(-1) ? 4.0 : 1.0);
    navigation_.fly(speed * std::min(seconds, 0.1) * way);
    movedAt_ = clock_.milliseconds();
}

// The next time is asked for when the one before is there, so that frames are left out and none waits.
void Viewing::play(double seconds) {
    if (!controls.plays || !facts_.staged) return;
    const double end = facts_.staged->scene->end;
    if (facts_.staged->scene->animations.empty() || !(end > 0.0)) {
        controls.plays = false;
        note("the scene has no animation");
        return;
    }
    played_ += seconds;
    if (!isStaged()) return;
    double time = controls.stage.time.value_or(0.0) + std::exchange(played_, 0.0);
    if (time > end) {
        time = controls.loops ? std::fmod(time, end) : end;
        controls.plays = controls.loops;
    }
    controls.stage.time = time;
}

void Viewing::askStage() {
    StageWish& wish = controls.stage;
    wish.view = controls.view == View::path ? View::path : View::shaded;
    wish.plays = controls.plays;
    const auto sameAs = [&](const StageWish& asked) {
        return asked.number != 0 && asked.file == wish.file && asked.animation == wish.animation &&
               asked.time == wish.time && asked.plays == wish.plays && asked.builder == wish.builder &&
               asked.view == wish.view && sameSettings(asked.settings, wish.settings);
    };
    if (sameAs(stageAsked_)) return;
    wish.number = stageAsked_.number + 1;
    stageAsked_ = wish;
    stage_.ask(wish);
}

void Viewing::askPainter() {
    if (!facts_.staged || size_.x == 0 || size_.y == 0) return;
    // A light that needs images waits for these.
    if (controls.view == View::path && facts_.staged->surfacesOf != View::path) return;
    PaintWish wish;
    wish.staged = facts_.staged;
    wish.camera = navigation_.camera();
    wish.width = size_.x;
    wish.height = size_.y;
    wish.view = controls.view;
    wish.samples = takesSamples(controls.view) ? controls.samples.value_or(defaultSamples(controls.view)) : 1;
    wish.bounces = controls.bounces;
    wish.exposure = std::exp2(controls.exposure);
    wish.traversal = controls.traversal;
    wish.test = controls.test;
    wish.moves = moves();
    wish.compares = controls.compares;
    if (samePicture(paintAsked_, wish)) return;
    wish.number = paintAsked_.number + 1;
    paintAsked_ = wish;
    painter_.ask(wish);
}

}  // namespace cleave
