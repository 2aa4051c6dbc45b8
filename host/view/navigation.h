// The camera of the window: how gestures move it, and how `cleave render` is told of it.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scene/camera.h"

namespace cleave {

// As --eye and --look take it, to the last bit.
std::string exactText(const glm::dvec3& point);

// Turns about a pivot, the point that it looks at. Moved, a camera is that of --eye, --look and --fov, so that what
// renderOptions() gives shows the same picture, to the last bit.
class Navigation {
  public:
    // Takes a camera as it is. `options`: what `cleave render` is told to have it; empty: nothing.
    void take(const Camera& camera, const Box& bounds, const std::string& options);
    // Looks from a point at another one.
    void place(const glm::dvec3& eye, const glm::dvec3& look);

    const Camera& camera() const { return camera_; }
    bool isMoved() const { return moved_; }
    const glm::dvec3& pivot() const { return look_; }
    std::string renderOptions() const;

    void orbit(double right, double up);  // radians; up: the camera rises
    void pan(double right, double up);    // heights of the picture; what is under the cursor follows it
    void zoom(double steps);              // towards the pivot, a tenth of the way each
    // Right, up and forward, in diagonals of the scene.
    void fly(const glm::dvec3& way);
    void lookAtPoint(const glm::dvec3& point);
    // Goes back so far that the whole scene is seen; `aspect`: width over height of the picture.
    void frame(const Box& bounds, double aspect);

  private:
    Camera camera_;
    Box bounds_ = emptyBox();
    glm::dvec3 look_{0.0};
    double degrees_ = 45.0;  // vertical field of view, as --fov takes it
    std::string options_;
    bool moved_ = false;

    double diagonal() const;
    void makePerspective();
    void move(const glm::dvec3& eye, const glm::dvec3& look);
};

}  // namespace cleave
