#include "support/device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace cleave::test {

namespace {

std::atomic<uint64_t>& messages() {
    static std::atomic<uint64_t> count{0};
    return count;
}

std::unique_ptr<Device>& opened() {
    static std::unique_ptr<Device> device;
    return device;
}

// After each test, so that a message fails the test that caused it.
class SilentValidation : public testing::EmptyTestEventListener {
    uint64_t seen_ = 0;
    void OnTestEnd(const testing::TestInfo&) override {
        const uint64_t now = messages();
        EXPECT_EQ(now, seen_) << "Vulkan validation spoke";
        seen_ = now;
    }
};

std::vector<std::function<void()>>& releases() {
    static std::vector<std::function<void()>> list;
    return list;
}

class CloseDevice : public testing::Environment {
    void TearDown() override {
        if (!opened()) return;
        const uint64_t before = messages();
        for (size_t i = releases().size(); i-- > 0;) releases()[i]();
        opened().reset();
        EXPECT_EQ(messages(), before) << "Vulkan validation spoke while the device was closed";
    }
};

const bool installed = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new SilentValidation);
    testing::AddGlobalTestEnvironment(new CloseDevice);
    return true;
}();

}  // namespace

void beforeClose(std::function<void()> release) { releases().push_back(std::move(release)); }

std::unique_ptr<Device> openTestDevice(DeviceOptions options) {
    const char* name = std::getenv("CLEAVE_TEST_DEVICE");
    options.nameOrIndex = name ? name : "";
    const char* noMap = std::getenv("CLEAVE_NO_MAP");
    if (noMap && std::string_view(noMap) == "1") options.maps = false;  // as the program does
    options.onValidation = [](const char* message) {
        messages()++;
        std::fprintf(stderr, "validation: %s\n", message);
    };
    return std::make_unique<Device>(std::move(options));
}

Device& device() {
    if (!opened()) opened() = openTestDevice({});
    return *opened();
}

PipelineHome pipelineHome() {
    static Functions functions;
    functions.load(vkGetInstanceProcAddr, device().instance(), device().handle());
    return {&functions, device().handle(), device().pipelineCache(), nullptr};
}

}  // namespace cleave::test
