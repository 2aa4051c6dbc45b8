// What the classes of cleave/scene.hpp hold.
#pragma once

#include <memory>
#include <vector>

#include "cleave/scene.hpp"
#include "judge/oracle.h"
#include "run/gpu_builder.h"
#include "run/tracer.h"

namespace cleave::scene {

struct Device::State {
    template <class... Arguments>
    explicit State(Arguments&&... arguments) : device(std::forward<Arguments>(arguments)...), tracer(device) {}

    // Compiles its kernels when it is first asked for.
    GpuBuilder& builder() {
        if (!builder_) builder_ = std::make_unique<GpuBuilder>(device);
        return *builder_;
    }

    cleave::Device device;
    Tracer tracer;

  private:
    std::unique_ptr<GpuBuilder> builder_;
};

struct Tree::State {
    Tracer* tracer;
    std::shared_ptr<DeviceTree> tree;
};

struct Mesh::State {
    Device::State* device;
    std::vector<cleave::Triangle> triangles;
    std::unique_ptr<DeviceTriangles> onDevice;
    std::unique_ptr<Reference> reference;
};

}  // namespace cleave::scene
