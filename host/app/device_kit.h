// The Vulkan device and what runs on it, each made when it is first needed: a command that needs no device works
// where there is none.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gpu/device.h"
#include "run/gpu_builder.h"
#include "run/poser.h"
#include "run/renderer.h"
#include "run/searcher.h"
#include "run/tracer.h"

namespace cleave {

// What CLEAVE_VALIDATION=1 in the environment asks for: messages go to stderr. Nothing otherwise.
ValidationListener validationAsked();

class DeviceKit {
  public:
    // `rayTracing`: with the driver's own, too, to compare with. `keepsTrails`: of TraceLimits.
    explicit DeviceKit(std::string nameOrIndex, bool rayTracing = false, bool keepsTrails = false)
        : nameOrIndex_(std::move(nameOrIndex)), rayTracing_(rayTracing), keepsTrails_(keepsTrails) {}

    // Opened with what the environment says: CLEAVE_VALIDATION=1 turns the validation layers on, CLEAVE_NO_MAP=1
    // refuses mapped device memory, CLEAVE_NO_RAY_TRACING=1 the driver's own ray tracing. Pipelines are kept in the
    // user's cache folder.
    Device& device();
    GpuBuilder& builder();  // warm
    GpuBuilder& lazyBuilder();
    Tracer& tracer();
    Searcher& searcher();
    Renderer& renderer();
    Poser& poser();

    bool isOpen() const { return device_ != nullptr; }
    std::optional<std::string> name() const;  // nothing unless opened
    double builderSetupMilliseconds() const {
        return (builder_ ? builder_->setupMilliseconds() : 0.0) +
               (lazyBuilder_ ? lazyBuilder_->setupMilliseconds() : 0.0);
    }
    // Pipelines and their compilation, of all that was made so far.
    double setupMilliseconds() const;
    TransferCount transfers() const { return device_ ? device_->transfers : TransferCount{}; }

  private:
    // The order matters: what lives on the device goes before it.
    std::string nameOrIndex_;
    bool rayTracing_;
    bool keepsTrails_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<GpuBuilder> builder_;
    std::unique_ptr<GpuBuilder> lazyBuilder_;
    std::unique_ptr<Tracer> tracer_;
    std::unique_ptr<Searcher> searcher_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Poser> poser_;
};

}  // namespace cleave
