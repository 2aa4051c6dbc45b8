// The device of a test program: opened once, with validation on; any validation message fails the program's tests.
//
// One rule for all devices: what decides a tree, an answer or a bit of a hit is integer or correctly rounded, so that
// every device must give the bits of the twin, and tests compare with ==. Colours are not under that rule; where pow(),
// exp() or a device's division comes in, the test names its tolerance.
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

// Runs before the device is closed, the last one first: for what a test program keeps on it.
void beforeClose(std::function<void()> release);

}  // namespace cleave::test
