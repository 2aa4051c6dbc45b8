// The device of a test program: opened once, with validation on; any validation message fails the program's tests.
#pragma once

#include <functional>

#include "gpu/device.h"

namespace cleave::test {

Context& device();

// Runs before the device is closed: for what a test program keeps on it.
void beforeClose(std::function<void()> release);

}  // namespace cleave::test
