#include "facade/states.h"
#include "gpu/instance.h"

namespace cleave::scene {
namespace {

cleave::DeviceOptions optionsOf(DeviceOptions options) {
    cleave::DeviceOptions o;
    o.nameOrIndex = std::move(options.nameOrIndex);
    o.onValidation = std::move(options.onValidation);
    o.loadPipelines = std::move(options.loadPipelines);
    o.storePipelines = std::move(options.storePipelines);
    o.maps = options.mapsMemory;
    return o;
}

}  // namespace

std::vector<DeviceInfo> listDevices() {
    std::vector<DeviceInfo> infos;
    for (const cleave::DeviceInfo& i : cleave::listDevices())
        infos.push_back({i.name, i.type, i.driver, i.apiVersion, i.unusableWhy, i.chosen});
    return infos;
}

Device::Device(DeviceOptions options) : state_(std::make_unique<State>(optionsOf(std::move(options)))) {}

Device::Device(const AdoptedDevice& a, DeviceOptions options)
    : state_(std::make_unique<State>(
          cleave::Device::Adopted{a.instance, a.physicalDevice, a.device, a.queue, a.queueFamily},
          optionsOf(std::move(options)))) {}

Device::~Device() = default;
Device::Device(Device&&) noexcept = default;

std::string Device::name() const { return state_->device.name(); }

Transfers Device::transfers() const { return {state_->device.transfers.upBytes, state_->device.transfers.downBytes}; }

}  // namespace cleave::scene
