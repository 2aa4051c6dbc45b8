// The Vulkan device: which there are, which is used, and what everything else on it needs.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cleave {

struct DeviceInfo {
    uint32_t index = 0;
    std::string name;
    std::string type;  // "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    std::string driver;
    std::string apiVersion;
    bool usable = false;
    bool chosen = false;      // what would be used without --device
    std::string unusableWhy;  // what it lacks
};

// Every Vulkan device here, in the loader's order. Throws Error if there is no Vulkan loader or instance.
std::vector<DeviceInfo> listDevices();

class Context;
struct ContextDeleter {
    void operator()(Context* context) const;
};
using ContextPointer = std::unique_ptr<Context, ContextDeleter>;

// Opens a device by index or by a part of its name (case is ignored); empty: the best usable one, real GPUs before
// CPUs. Throws Error if there is none such. Validation (with synchronisation validation) is on where the environment
// variable CLEAVE_VALIDATION is 1; its messages are counted by validationMessages() and printed to stderr.
ContextPointer openDevice(const std::string& nameOrIndex = "");

std::string deviceName(const Context& context);
uint64_t validationMessages(const Context& context);

// Milliseconds that this context has spent on creating pipelines and on the first dispatch of each (where CPU devices
// compile).
double setupMilliseconds(const Context& context);

// What the dispatches of one kernel took together.
struct KernelTime {
    std::string name;
    double ms = 0.0;
};

}  // namespace cleave
