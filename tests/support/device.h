// The device of a test program: opened once, with validation on; any validation message fails the program's tests.
#pragma once

#include <functional>

#include "gpu/device.h"
#include "record/kernel.h"

namespace cleave::test {

Device& device();

// A device of its own for a test that needs other options; its validation messages count, too.
std::unique_ptr<Device> openTestDevice(DeviceOptions options);

// Where kernels of a test are made.
PipelineHome pipelineHome();

// Runs before the device is closed: for what a test program keeps on it.
void beforeClose(std::function<void()> release);

}  // namespace cleave::test
