#include "view/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <fstream>

#include "app/device_kit.h"
#include "app/run_request.h"
#include "app/session.h"
#include "base/stopwatch.h"
#include "figures/json.h"
#include "formats/write_file.h"
#include "view/overlay.h"
#include "view/panel.h"
#include "view/presenter.h"
#include "view/script_player.h"
#include "view/viewing.h"

namespace cleave {
namespace {

constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kRestSeconds = 0.1;
constexpr uint32_t kMostLost = 3;  // presenters, one after the other, before it is given up

// How the window does, for --json.
class WindowFigures {
  public:
    void asked(uint64_t wish, bool moves) {
        if (wish == lastAsked_) return;
        lastAsked_ = wish;
        if (moves) asked_.push_back({wish, pictures_, Stopwatch()});
    }
    // A wish that another one took the place of is answered by the picture of that one.
    void shown(const Painted& painted, bool moves) {
        ++pictures_;
        for (; !asked_.empty() && asked_.front().wish <= painted.number; asked_.pop_front()) {
            pictureCounts_.push_back(static_cast<double>(pictures_ - asked_.front().pictures));
            waits_.push_back(asked_.front().since.milliseconds());
        }
        if (moves) {
            width_ = painted.width;
            height_ = painted.height;
            if (movedBefore_) {
                movingSeconds_ += sinceMove_.milliseconds() / 1000.0;
                ++movingPictures_;
            }
            sinceMove_ = Stopwatch();
        }
        movedBefore_ = moves;
    }
    void presented() { ++frames_; }
    void busy(double ms) { longestMs_ = std::max(longestMs_, ms); }

    double movingPerSecond() const {
        return movingSeconds_ > 0.0 ? static_cast<double>(movingPictures_) / movingSeconds_ : 0.0;
    }
    Json json() const {
        return {{"frames", frames_},
                {"seconds", numberJson(total_.milliseconds() / 1000.0)},
                {"movingPictures", movingPictures_},
                {"movingPicturesPerSecond", numberJson(movingPerSecond())},
                {"movingSize", {width_, height_}},
                {"picturesFromInputToItsOwn", spreadOf(pictureCounts_)},
                {"msFromInputToPicture", spreadOf(waits_)},
                {"longestBusyMs", numberJson(longestMs_)}};
    }

  private:
    struct Asked {
        uint64_t wish, pictures;
        Stopwatch since;
    };
    static Json spreadOf(std::vector<double> values) {
        if (values.empty()) return nullptr;
        std::ranges::sort(values);
        return {
            {"median", values[values.size() / 2]}, {"p99", values[values.size() * 99 / 100]}, {"most", values.back()}};
    }
    Stopwatch total_, sinceMove_;
    uint64_t frames_ = 0, pictures_ = 0, lastAsked_ = 0, movingPictures_ = 0;
    uint32_t width_ = 0, height_ = 0;
    double movingSeconds_ = 0.0, longestMs_ = 0.0;
    bool movedBefore_ = false;
    std::deque<Asked> asked_;
    std::vector<double> pictureCounts_, waits_;
};

// Dear ImGui, with the window's part of it.
class Interface {
  public:
    explicit Interface(Window& window) {
        ImGui::CreateContext();
        ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
    }
    ~Interface() {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;
};

uint64_t residentBytes() {
    std::ifstream statm("/proc/self/statm");
    uint64_t pages = 0, resident = 0;
    statm >> pages >> resident;
    return resident * 4096;
}

class Viewer {
  public:
    Viewer(const Options& options, std::optional<ScriptPlayer> script)
        : options_(options),
          script_(std::move(script)),
          window_("cleave: " + options.scenes.front().filename().string(), options.width, options.height),
          interface_(window_),
          viewing_(options, Window::wake) {
        openPresenter();
    }

    void run() {
        while (!window_.isClosing() && !(script_ && script_->hasEnded())) {
            const std::vector<WindowEvent> events = window_.wait(waitSeconds());
            const Stopwatch busy;
            takeEvents(events);
            if (script_) script_->play(viewing_, window_);
            viewing_.update(window_.size());
            if (const std::string copied = viewing_.takeCopied(); !copied.empty()) {
                window_.copy(copied);
                std::printf("%s\n", copied.c_str());
            }
            takePicture();
            figures_.asked(viewing_.wished(), viewing_.moves());     // after the picture that came before it
            const bool captures = script_ && script_->screenshot();  // which takes the time to write it
            if (isWorthAFrame(!events.empty())) draw();
            if (!captures) figures_.busy(busy.milliseconds());
        }
        tell();
    }

  private:
    const Options& options_;
    std::optional<ScriptPlayer> script_;
    Window window_;
    Interface interface_;
    float scale_ = 0.0f;
    std::unique_ptr<Presenter> presenter_;
    std::shared_ptr<const Painted> shown_;
    Viewing viewing_;
    WindowFigures figures_;
    Stopwatch sinceFrame_;
    std::string lastPhase_, lastNote_;
    glm::uvec2 lastSize_{0};
    bool changed_ = true;
    uint32_t lost_ = 0;    // presenters, since a frame was shown
    int framesAfter_ = 0;  // that panels take to settle

    void openPresenter() {
        presenter_.reset();
        scale_ = window_.scale();
        ImGui::GetIO().Fonts->Clear();
        styleInterface(scale_);
        presenter_ = std::make_unique<Presenter>(window_.handle(), options_.device, validationAsked());
        if (shown_) presenter_->setPicture(shown_->width, shown_->height, shown_->pixels);
    }

    double waitSeconds() const {
        const bool active = viewing_.moves() || framesAfter_ > 0 || (script_ && script_->needsFrames());
        if (!active) return kRestSeconds;
        return std::max(0.0, kFrameSeconds - sinceFrame_.milliseconds() / 1000.0);
    }

    void takeEvents(const std::vector<WindowEvent>& events) {
        const ImGuiIO& io = ImGui::GetIO();
        for (const WindowEvent& event : events) {
            const bool isMouse =
                std::holds_alternative<ButtonEvent>(event) || std::holds_alternative<ScrollEvent>(event);
            const auto* button = std::get_if<ButtonEvent>(&event);
            const auto* key = std::get_if<KeyEvent>(&event);
            // What goes up was down somewhere.
            if (isMouse && io.WantCaptureMouse && !(button && !button->isDown)) continue;
            if (key && key->isDown && io.WantTextInput) continue;
            viewing_.handle(event);
        }
    }

    void takePicture() {
        const std::shared_ptr<const Painted> painted = viewing_.takePicture();
        if (!painted) return;
        const bool isOther = !shown_ || shown_->pixels != painted->pixels || shown_->width != painted->width;
        shown_ = painted;
        changed_ = true;
        if (isOther) presenter_->setPicture(painted->width, painted->height, painted->pixels);
        figures_.shown(*painted, viewing_.moves());
    }

    bool isWorthAFrame(bool hadEvents) {
        const Facts& facts = viewing_.facts();
        const glm::uvec2 size = window_.size();
        changed_ = changed_ || hadEvents || facts.phase != lastPhase_ || facts.note != lastNote_ || size != lastSize_;
        lastPhase_ = facts.phase;
        lastNote_ = facts.note;
        lastSize_ = size;
        if (changed_) framesAfter_ = 3;
        if (size.x == 0 || size.y == 0) return false;
        return changed_ || framesAfter_ > 0 || (script_ && script_->needsFrames());
    }

    void draw() {
        if (window_.scale() != scale_) openPresenter();
        const bool captures = script_ && script_->screenshot();
        const bool panels = !captures || script_->screenshotsPanels();
        ImGui_ImplVulkan_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        Facts facts = viewing_.facts();
        facts.framesPerSecond = figures_.movingPerSecond();
        facts.device = presenter_->deviceName();
        drawOverlay(viewing_.controls, facts, ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
        if (panels && drawPanel(viewing_.controls, facts)) viewing_.forgetError();
        ImGui::Render();
        Pixels taken;
        if (!present(captures ? &taken : nullptr)) return;
        sinceFrame_ = Stopwatch();
        changed_ = false;
        framesAfter_ = std::max(0, framesAfter_ - 1);
        figures_.presented();
        if (captures) script_->keep(taken);
        if (script_) script_->framePresented();
    }

    bool present(Pixels* taken) {
        try {
            const bool shown = presenter_->present(taken);
            if (shown) lost_ = 0;
            return shown;
        } catch (const PresenterLost&) {
            if (++lost_ == kMostLost) throw;
        }
        openPresenter();
        return false;  // what ImGui has drawn went with the presenter
    }

    void tell() const {
        if (!options_.json) return;
        Json report{{"window", figures_.json()},
                    {"device", {{"name", presenter_->deviceName()}}},
                    {"memory", {{"deviceBytes", viewing_.facts().deviceBytes}, {"residentBytes", residentBytes()}}}};
        writeFile(*options_.json, report.dump(2) + "\n");
    }
};

void view(const Options& asked) {
    Options options = asked;
    if (options.scenes.empty()) options.scenes.push_back(defaultScene());
    if (options.json) requireWritable(*options.json);
    std::optional<ScriptPlayer> script;
    if (options.script) script.emplace(readScript(*options.script), options.script->string());
    Viewer(options, std::move(script)).run();
}

}  // namespace

int runViewer(int argc, const char* const* argv) {
    return runRequest([&] { return parseViewerLine(argc, argv); }, view);
}

}  // namespace cleave
