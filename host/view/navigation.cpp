#include "view/navigation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>

#include "base/text.h"

namespace cleave {
namespace {

using glm::dvec3;

constexpr double kSteepest = 0.999 * std::numbers::pi / 2.0;  // from the horizon, so that up stays up

}  // namespace

std::string exactText(const dvec3& p) { return exactText(p.x) + "," + exactText(p.y) + "," + exactText(p.z); }

double Navigation::diagonal() const {
    const double length = isEmpty(bounds_) ? 0.0 : glm::length(dvec3(bounds_.hi) - dvec3(bounds_.lo));
    return length > 0.0 ? length : 1.0;
}

// The pivot is as far away as the scene's centre is or, where that is behind or beside, half of its diagonal.
void Navigation::take(const Camera& camera, const Box& bounds, const std::string& options) {
    camera_ = camera;
    bounds_ = bounds;
    options_ = options;
    moved_ = false;
    const dvec3 centre = isEmpty(bounds) ? dvec3(0.0) : 0.5 * (dvec3(bounds.lo) + dvec3(bounds.hi));
    const double ahead = glm::dot(centre - camera.eye, camera.forward);
    look_ = camera.eye + camera.forward * (ahead > 0.05 * diagonal() ? ahead : 0.5 * diagonal());
    degrees_ = glm::degrees(camera.verticalFov);
}

void Navigation::place(const dvec3& eye, const dvec3& look) {
    makePerspective();
    move(eye, look);
}

std::string Navigation::renderOptions() const {
    if (!moved_) return options_;
    return "--eye " + exactText(camera_.eye) + " --look " + exactText(look_) + " --fov " + exactText(degrees_);
}

// Gestures need a distance to the pivot that shows. What is as far away as the pivot keeps its size.
void Navigation::makePerspective() {
    if (!camera_.orthographic) return;
    degrees_ = 45.0;
    const double distance = 0.5 * camera_.orthographicHeight / std::tan(glm::radians(0.5 * degrees_));
    camera_.eye = look_ - camera_.forward * distance;
    camera_.orthographic = false;
}

void Navigation::move(const dvec3& eye, const dvec3& look) {
    look_ = look;
    moved_ = true;
    camera_ = overridden(camera_, bounds_, {eye, look, glm::radians(degrees_)});
}

void Navigation::orbit(double right, double up) {
    makePerspective();
    const dvec3 back = camera_.eye - look_;
    const double distance = glm::length(back);
    if (!(distance > 0.0)) return;
    const double turn = std::atan2(back.x, back.z) - right;
    const double rise = std::clamp(std::asin(std::clamp(back.y / distance, -1.0, 1.0)) + up, -kSteepest, kSteepest);
    move(look_ + distance * dvec3(std::cos(rise) * std::sin(turn), std::sin(rise), std::cos(rise) * std::cos(turn)),
         look_);
}

void Navigation::pan(double right, double up) {
    makePerspective();
    const double height = 2.0 * glm::length(camera_.eye - look_) * std::tan(glm::radians(0.5 * degrees_));
    const dvec3 side = glm::cross(camera_.forward, camera_.up);
    const dvec3 way = -height * (right * side + up * camera_.up);
    move(camera_.eye + way, look_ + way);
}

void Navigation::zoom(double steps) {
    makePerspective();
    const double distance =
        std::clamp(glm::length(camera_.eye - look_) * std::pow(0.9, steps), 1e-6 * diagonal(), 1e4 * diagonal());
    move(look_ - camera_.forward * distance, look_);
}

void Navigation::fly(const dvec3& way) {
    makePerspective();
    const dvec3 side = glm::cross(camera_.forward, camera_.up);
    const dvec3 step = diagonal() * (way.x * side + way.y * camera_.up + way.z * camera_.forward);
    move(camera_.eye + step, look_ + step);
}

void Navigation::lookAtPoint(const dvec3& point) {
    makePerspective();
    move(camera_.eye, point);
}

void Navigation::frame(const Box& bounds, double aspect) {
    makePerspective();
    if (isEmpty(bounds)) return;
    const dvec3 centre = 0.5 * (dvec3(bounds.lo) + dvec3(bounds.hi));
    const double radius = 0.5 * glm::length(dvec3(bounds.hi) - dvec3(bounds.lo));
    const double half = std::atan(std::tan(glm::radians(0.5 * degrees_)) * std::min(aspect, 1.0));
    move(centre - camera_.forward * std::max(radius / std::sin(half), 1e-6 * diagonal()), centre);
}

}  // namespace cleave
