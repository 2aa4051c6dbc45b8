// The Vulkan device and what runs on it, each made when it is first needed: a command that needs no device works
// where there is none.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gpu/context.h"
#include "pass/gpu_builder.h"
#include "pass/renderer.h"
#include "pass/tracer.h"

namespace cleave {

class DeviceKit {
  public:
    explicit DeviceKit(std::string nameOrIndex) : nameOrIndex_(std::move(nameOrIndex)) {}

    Context& context();
    GpuBuilder& builder();  // warm
    Tracer& tracer();
    Renderer& renderer();

    bool isOpen() const { return context_ != nullptr; }
    std::optional<std::string> name() const;                      // nothing unless opened
    double builderSetupMilliseconds() const { return setupMs_; }  // of builder(); 0 before

  private:
    // The order matters: what lives on the context goes before it.
    std::string nameOrIndex_;
    ContextPointer context_;
    std::unique_ptr<GpuBuilder> builder_;
    std::unique_ptr<Tracer> tracer_;
    std::unique_ptr<Renderer> renderer_;
    double setupMs_ = 0.0;
};

}  // namespace cleave
