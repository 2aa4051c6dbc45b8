#include "app/device_kit.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "app/pipeline_file.h"

namespace cleave {
namespace {

bool isOn(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && std::string_view(value) == "1";
}

}  // namespace

ValidationListener validationAsked() {
    if (!isOn("CLEAVE_VALIDATION")) return nullptr;
    return [](const char* message) { std::fprintf(stderr, "validation: %s\n", message); };
}

Device& DeviceKit::device() {
    if (device_) return *device_;
    DeviceOptions options;
    options.nameOrIndex = nameOrIndex_;
    options.maps = !isOn("CLEAVE_NO_MAP");
    options.rayTracing = rayTracing_ && !isOn("CLEAVE_NO_RAY_TRACING");
    options.loadPipelines = loadPipelines;
    options.storePipelines = storePipelines;
    options.onValidation = validationAsked();
    device_ = std::make_unique<Device>(std::move(options));
    return *device_;
}

GpuBuilder& DeviceKit::builder() {
    if (!builder_) builder_ = std::make_unique<GpuBuilder>(device());
    return *builder_;
}

GpuBuilder& DeviceKit::lazyBuilder() {
    if (!lazyBuilder_) lazyBuilder_ = std::make_unique<GpuBuilder>(device(), true);
    return *lazyBuilder_;
}

Tracer& DeviceKit::tracer() {
    TraceLimits limits;
    limits.keepsTrails = keepsTrails_;
    if (!tracer_) tracer_ = std::make_unique<Tracer>(device(), limits);
    return *tracer_;
}

Searcher& DeviceKit::searcher() {
    if (!searcher_) searcher_ = std::make_unique<Searcher>(device());
    return *searcher_;
}

Renderer& DeviceKit::renderer() {
    if (!renderer_) renderer_ = std::make_unique<Renderer>(device(), tracer());
    return *renderer_;
}

Poser& DeviceKit::poser() {
    if (!poser_) poser_ = std::make_unique<Poser>(device());
    return *poser_;
}

double DeviceKit::setupMilliseconds() const {
    return builderSetupMilliseconds() + (tracer_ ? tracer_->setupMilliseconds() : 0.0) +
           (renderer_ ? renderer_->setupMilliseconds() : 0.0) + (poser_ ? poser_->setupMilliseconds() : 0.0);
}

std::optional<std::string> DeviceKit::name() const { return device_ ? std::optional(device_->name()) : std::nullopt; }

}  // namespace cleave
