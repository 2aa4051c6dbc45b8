// Owns a Vulkan handle, so that it is destroyed also where a later call throws.
#pragma once

#include <utility>

namespace cleave {

// `destroy` is called as destroy(parent, handle, nullptr), the shape of vkDestroyFence and the like.
template <class Parent, class Handle, auto destroy>
class Owned {
  public:
    Owned() = default;
    explicit Owned(Parent parent) : parent_(parent) {}
    ~Owned() { reset(); }
    Owned(Owned&& other) noexcept { swap(other); }
    Owned& operator=(Owned&& other) noexcept {
        Owned taken(std::move(other));
        swap(taken);
        return *this;
    }

    Handle get() const { return handle_; }
    // Where a vkCreate... function puts the handle. The owner must be empty.
    Handle* put() { return &handle_; }
    explicit operator bool() const { return handle_ != Handle{}; }

  private:
    Parent parent_{};
    Handle handle_{};

    void swap(Owned& other) noexcept {
        std::swap(parent_, other.parent_);
        std::swap(handle_, other.handle_);
    }
    void reset() {
        if (handle_ != Handle{}) destroy(parent_, handle_, nullptr);
    }
};

}  // namespace cleave
