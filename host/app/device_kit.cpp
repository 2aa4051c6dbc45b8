#include "app/device_kit.h"

namespace cleave {

Context& DeviceKit::context() {
    if (!context_) context_ = openDevice(nameOrIndex_);
    return *context_;
}

GpuBuilder& DeviceKit::builder() {
    if (!builder_) {
        const double before = setupMilliseconds(context());
        builder_ = std::make_unique<GpuBuilder>(context());
        builder_->warmUp();
        setupMs_ = setupMilliseconds(context()) - before;
    }
    return *builder_;
}

Tracer& DeviceKit::tracer() {
    if (!tracer_) tracer_ = std::make_unique<Tracer>(context());
    return *tracer_;
}

Renderer& DeviceKit::renderer() {
    if (!renderer_) renderer_ = std::make_unique<Renderer>(context(), tracer());
    return *renderer_;
}

std::optional<std::string> DeviceKit::name() const {
    return context_ ? std::optional(deviceName(*context_)) : std::nullopt;
}

}  // namespace cleave
