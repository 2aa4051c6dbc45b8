// What the classes of cleave/scene.hpp hold.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cleave/scene.hpp"
#include "judge/oracle.h"
#include "run/gpu_builder.h"
#include "run/searcher.h"
#include "run/tracer.h"

namespace cleave::scene {

struct Device::State {
    template <class... Arguments>
    explicit State(Arguments&&... arguments)
        : device(std::forward<Arguments>(arguments)...), tracer(device), searcher(device) {}

    // Compiles its kernels when it is first asked for.
    GpuBuilder& builder() {
        if (!builder_) builder_ = std::make_unique<GpuBuilder>(device);
        return *builder_;
    }

    cleave::Device device;
    Tracer tracer;
    Searcher searcher;

  private:
    std::unique_ptr<GpuBuilder> builder_;
};

// Triangles in world space, which trees share with the mesh.
using World = std::shared_ptr<const std::vector<cleave::Triangle>>;

struct Tree::State {
    Tracer* tracer;
    Searcher* searcher;
    std::shared_ptr<DeviceTree> tree;
    World world;
    std::vector<uint32_t> list;         // of the world, as Mesh::build() was given it
    std::optional<uint64_t> openEdges;  // of the tree's triangles, once they are counted

    void requireClosed();
};

struct Twin::State {
    World world;
    TriangleSet set;
    uint32_t threads;
    std::optional<uint64_t> openEdges;

    void requireClosed();
};

struct Mesh::State {
    Device::State* device;
    World world;
    std::unique_ptr<DeviceTriangles> onDevice;
    std::unique_ptr<Reference> reference;
};

}  // namespace cleave::scene
