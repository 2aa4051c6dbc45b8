// A window of the desktop, and what its user does in it.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

struct GLFWwindow;

namespace cleave {

// Places are in pixels of the picture, from the upper left.
struct ButtonEvent {
    int button = 0;  // of GLFW: 0 left, 1 right, 2 middle
    bool isDown = false;
    glm::dvec2 at{0.0};
};
struct CursorEvent {
    glm::dvec2 at{0.0};
};
struct ScrollEvent {
    double steps = 0.0;
};
struct KeyEvent {
    int key = 0;  // of GLFW
    bool isDown = false;
};
struct DropEvent {
    std::filesystem::path file;
};
using WindowEvent = std::variant<ButtonEvent, CursorEvent, ScrollEvent, KeyEvent, DropEvent>;

class Window {
  public:
    // With so many pixels. Throws Error if there is no display.
    Window(const std::string& title, uint32_t width, uint32_t height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    bool isClosing() const;
    glm::uvec2 size() const;  // in pixels; 0 while it is minimised
    void resize(glm::uvec2 pixels);
    void setTitle(const std::string& title);
    // Letters of how many times the usual size are read well, in units of ImGui.
    float scale() const;
    glm::dvec2 cursor() const;  // in pixels
    void copy(const std::string& text);

    // Waits for something to happen, or for so many seconds; then tells what the user did.
    std::vector<WindowEvent> wait(double seconds);
    // Ends a wait; may be called by any thread.
    static void wake();

  private:
    GLFWwindow* window_ = nullptr;
    std::vector<WindowEvent> events_;

    glm::dvec2 pixelsPerUnit() const;
    void listen();
    static Window& of(GLFWwindow* window);
};

// The key of that name: a letter, a digit, space, escape, [ or ].
std::optional<int> keyNamed(const std::string& name);

}  // namespace cleave
