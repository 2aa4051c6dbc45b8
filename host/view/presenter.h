// Shows pictures of main memory in a window, and Dear ImGui's drawings over them. It has a device of its own: what it
// presents waits for nothing that another one builds or renders.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "gpu/instance.h"

struct GLFWwindow;

namespace cleave {

// The device or its surface is gone: a new presenter may do.
struct PresenterLost : Error {
    using Error::Error;
};

// R | G << 8 | B << 16 | A << 24, row by row from the top.
struct Pixels {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint32_t> values;
};

class Presenter {
  public:
    // On the named device or, if that cannot show a window, on the first that can. An ImGui context with the window's
    // backend must be there. Throws Error.
    Presenter(GLFWwindow* window, const std::string& device, ValidationListener listener);
    ~Presenter();
    std::string deviceName() const;

    // The picture that is shown from now on, stretched to the window.
    void setPicture(uint32_t width, uint32_t height, std::span<const uint32_t> pixels);

    // Shows the picture and ImGui's last frame. False if there is nothing to show it on now: the window is minimised,
    // or changes its size. `capture`: takes what was shown. Throws Error.
    bool present(Pixels* capture = nullptr);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cleave
