#include "view/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/text.h"

namespace cleave {
namespace {

std::string whatGlfwSays() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? std::string(": ") + oneLine(text) : "";
}

}  // namespace

Window::Window(const std::string& title, uint32_t width, uint32_t height) {
    if (!glfwInit())
        throw Error("cannot open a window" + whatGlfwSays() +
                    "; set DISPLAY, run it under xvfb-run, or make pictures by `cleave render`");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string why = whatGlfwSays();
        glfwTerminate();
        throw Error("cannot open a window" + why + "; make pictures by `cleave render`");
    }
    glfwSetWindowUserPointer(window_, this);
    listen();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

Window& Window::of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

// Before those of ImGui, which calls them on.
void Window::listen() {
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        of(w).events_.emplace_back(ButtonEvent{button, action == GLFW_PRESS, of(w).cursor()});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        of(w).events_.emplace_back(CursorEvent{glm::dvec2(x, y) * of(w).pixelsPerUnit()});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) { of(w).events_.emplace_back(ScrollEvent{y}); });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
        if (action != GLFW_REPEAT) of(w).events_.emplace_back(KeyEvent{key, action == GLFW_PRESS});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** files) {
        if (count > 0) of(w).events_.emplace_back(DropEvent{files[0]});
    });
}

bool Window::isClosing() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

glm::uvec2 Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<uint32_t>(std::max(width, 0)), static_cast<uint32_t>(std::max(height, 0))};
}

glm::dvec2 Window::pixelsPerUnit() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (width <= 0 || height <= 0) return {1.0, 1.0};
    return glm::dvec2(size()) / glm::dvec2(width, height);
}

void Window::resize(glm::uvec2 pixels) {
    const glm::dvec2 units = glm::round(glm::dvec2(pixels) / pixelsPerUnit());
    glfwSetWindowSize(window_, static_cast<int>(units.x), static_cast<int>(units.y));
}

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

float Window::scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(y / static_cast<float>(pixelsPerUnit().y), 0.5f, 4.0f);
}

glm::dvec2 Window::cursor() const {
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    return glm::dvec2(x, y) * pixelsPerUnit();
}

void Window::copy(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

std::vector<WindowEvent> Window::wait(double seconds) {
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return std::exchange(events_, {});
}

void Window::wake() { glfwPostEmptyEvent(); }

std::optional<int> keyNamed(const std::string& name) {
    if (name == "space") return GLFW_KEY_SPACE;
    if (name == "escape") return GLFW_KEY_ESCAPE;
    if (name == "[") return GLFW_KEY_LEFT_BRACKET;
    if (name == "]") return GLFW_KEY_RIGHT_BRACKET;
    if (name.size() != 1) return std::nullopt;
    const char c = name[0];
    if (c >= 'a' && c <= 'z') return GLFW_KEY_A + (c - 'a');
    if (c >= 'A' && c <= 'Z') return GLFW_KEY_A + (c - 'A');
    if (c >= '0' && c <= '9') return GLFW_KEY_0 + (c - '0');
    return std::nullopt;
}

}  // namespace cleave
