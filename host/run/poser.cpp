#include "run/poser.h"

#include <algorithm>

#include "base/error.h"
#include "base/stopwatch.h"
#include "gpu/check.h"
#include "gpu/commands.h"
#include "record/recorder.h"
#include "shared/config.h"

namespace cleave {

// The room's own kernels; a table that the build generates.
std::span<const Spirv> runKernels() noexcept;

namespace {

template <class Item>
void put(Device& device, Buffer& buffer, std::span<const Item> items) {
    if (items.empty()) return;
    if (buffer.size() < items.size_bytes()) {
        buffer = Buffer();  // the old one need not be beside the new one
        buffer = Buffer(device, items.size_bytes());
    }
    buffer.upload(items);
}

}  // namespace

DevicePose::DevicePose(Device& device, const PoseArrays& arrays)
    : parts_(uploaded(device, arrays.parts)),
      positions_(uploaded(device, arrays.positions)),
      morphs_(uploaded(device, arrays.morphs)),
      deltas_(uploaded(device, arrays.deltas)),
      influences_(uploaded(device, arrays.influences)),
      corners_(uploaded(device, arrays.corners)),
      numbers_(uploaded(device, arrays.numbers)),
      posed_(device, arrays.vertices * sizeof(vec3)) {
    push_.parts = parts_.address();
    push_.positions = positions_.address();
    push_.morphs = morphs_.address();
    push_.deltas = deltas_.address();
    push_.influences = influences_.address();
    push_.corners = corners_.address();
    push_.numbers = numbers_.address();
    push_.posed = posed_.address();
    push_.partCount = static_cast<uint32_t>(arrays.parts.size());
    push_.vertexCount = arrays.vertices;
    push_.triangleCount = static_cast<uint32_t>(arrays.numbers.size());
}

struct Poser::State {
    explicit State(Device& d) : device(d), commands(d) {
        if (const char* missing = functions.load(vkGetInstanceProcAddr, d.instance(), d.handle()))
            throw Error(std::string("the Vulkan driver has no function ") + missing);
        create(vertices, "pose_vertices");
        create(triangles, "pose_triangles");
    }

    void create(Kernel& kernel, const char* name) {
        check(kernel.create({&functions, device.handle(), device.pipelineCache(), nullptr},
                            findSpirv(runKernels(), name), sizeof(PosePush), {}),
              std::string("creating the pipeline of kernel ") + name);
    }

    void run(const PosePush& push) {
        const uint32_t row = device.longestRow() != 0 ? device.longestRow() : kLongestRow;
        commands.begin();
        Recorder recorder(functions, commands.handle(), row);
        recorder.dispatch(vertices, push, std::max(1u, ceilDiv(push.vertexCount, kGroup)));
        recorder.dispatch(triangles, push, std::max(1u, ceilDiv(push.triangleCount, kGroup)));
        commands.run();
    }

    Device& device;
    Functions functions;
    Kernel vertices, triangles;
    Commands commands;
};

Poser::Poser(Device& device) {
    const Stopwatch watch;
    state_ = std::make_unique<State>(device);
    // CPU devices compile at the first dispatch.
    const Buffer part = Buffer(device, sizeof(PosePart));
    PosePush nothing{};
    nothing.parts = part.address();
    nothing.partCount = 1;
    state_->run(nothing);
    setupMs_ = watch.milliseconds();
}
Poser::~Poser() = default;

void Poser::pose(DevicePose& pose, std::span<const AffineMap> maps, std::span<const double> weights,
                 const DeviceTriangles& triangles) {
    put(state_->device, pose.maps_, maps);
    put(state_->device, pose.weights_, weights);
    PosePush push = pose.push_;
    push.maps = pose.maps_.address();
    push.weights = pose.weights_.address();
    push.triangles = triangles.triangles.address();
    state_->run(push);
}

}  // namespace cleave
