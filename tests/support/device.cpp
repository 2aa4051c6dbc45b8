#include "support/device.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace cleave::test {

namespace {

ContextPointer& opened() {
    static ContextPointer context;
    return context;
}

// After each test, so that a message fails the test that caused it.
class SilentValidation : public testing::EmptyTestEventListener {
    uint64_t seen_ = 0;
    void OnTestEnd(const testing::TestInfo&) override {
        if (!opened()) return;
        const uint64_t messages = validationMessages(*opened());
        EXPECT_EQ(messages, seen_) << "Vulkan validation spoke";
        seen_ = messages;
    }
};

std::vector<std::function<void()>>& releases() {
    static std::vector<std::function<void()>> list;
    return list;
}

class CloseDevice : public testing::Environment {
    void TearDown() override {
        if (!opened()) return;
        const std::shared_ptr<ValidationLog> log = opened()->validation;
        const uint64_t before = log->messages;
        for (auto& release : releases()) release();
        opened().reset();
        EXPECT_EQ(log->messages, before) << "Vulkan validation spoke while the device was closed";
    }
};

const bool installed = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new SilentValidation);
    testing::AddGlobalTestEnvironment(new CloseDevice);
    return true;
}();

}  // namespace

void beforeClose(std::function<void()> release) { releases().push_back(std::move(release)); }

Context& device() {
    if (!opened()) {
        setenv("CLEAVE_VALIDATION", "1", 1);
        const char* name = std::getenv("CLEAVE_TEST_DEVICE");
        opened() = openDevice(name ? name : "");
    }
    return *opened();
}

}  // namespace cleave::test
