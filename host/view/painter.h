// Makes the window's pictures, on a thread and a device of its own: small ones while something moves, whole and then
// better and better ones at rest.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "figures/ray_work.h"
#include "run/renderer.h"
#include "view/stage.h"

namespace cleave {

// What a picture shows, beside the samples that it is of.
struct PaintWish {
    uint64_t number = 0;  // of the wish; a greater one takes the place of a smaller one
    std::shared_ptr<const Staged> staged;
    Camera camera;
    uint32_t width = 0, height = 0;  // of the window, in pixels
    View view = View::shaded;
    uint32_t samples = 1;
    uint32_t bounces = 8;
    float exposure = 1.0f;
    Traversal traversal = kDefaultTraversal;
    TriangleTest test = TriangleTest::watertight;
    bool moves = false;     // a picture at once is wanted, though it be small
    bool compares = false;  // our answers beside the reference's, instead of the view
};

struct Comparison {
    uint64_t rays = 0;
    uint64_t mismatches = 0;
    uint64_t undecided = 0;
};

struct Painted {
    uint64_t number = 0;  // of the wish
    std::shared_ptr<const Staged> staged;
    Camera camera;
    View view = View::shaded;
    uint32_t width = 0, height = 0;  // not those of the window while something moves
    std::vector<uint32_t> pixels;
    uint32_t samples = 0, of = 0;  // 0 samples: some rows are of the picture before
    bool isDone = false;
    bool moves = false;           // as the wish
    double ms = 0.0;              // from the wish to here
    double mraysPerSecond = 0.0;  // of the primary rays
    float scaleLow = 0.0f, scaleHigh = 0.0f;
    std::optional<RayWork> work;  // of primary rays, on their way
    std::optional<Comparison> comparison;
};

// What a ray from the camera meets.
struct Picked {
    uint64_t number = 0;
    glm::dvec3 point{0.0};
    bool hits = false;
};

class Painter {
  public:
    Painter(std::string device, std::function<void()> wake);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    void ask(const PaintWish& wish);
    // The newest picture, once.
    std::shared_ptr<const Painted> take();
    // Shoots a ray through what was painted last.
    void pick(uint64_t number, const Ray& ray);
    std::optional<Picked> takePicked();
    std::optional<std::string> takeError();
    uint64_t deviceBytes() const;

  private:
    struct Easel;

    std::string device_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable asked_;
    std::optional<PaintWish> wish_;
    std::optional<std::pair<uint64_t, Ray>> pick_;
    std::shared_ptr<const Painted> painted_;
    std::optional<Picked> picked_;
    std::optional<std::string> error_;
    uint64_t deviceBytes_ = 0;
    bool ends_ = false;
    std::thread thread_;

    void run();
    bool isAskedForMore() const;
    void publish(std::shared_ptr<const Painted> painted);
};

}  // namespace cleave
