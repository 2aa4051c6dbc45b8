// A command buffer, its submission and its clock. What goes into it is recorded by others.
#pragma once

#include <string>
#include <vector>

#include "gpu/device.h"

namespace cleave {

// The time that the dispatches of one pass took together.
struct PassTime {
    std::string name;
    double ms = 0.0;
};

class Commands {
  public:
    // `mostStamps`: how many times the clock can be read in between.
    explicit Commands(Device& device, uint32_t mostStamps = 0);
    ~Commands();
    Commands(Commands&& other) noexcept;
    Commands& operator=(Commands&&) = delete;

    VkCommandBuffer handle() const { return commands_; }

    void begin();  // waits for what was submitted before
    void copy(VkBuffer from, VkDeviceSize fromOffset, VkBuffer to, VkDeviceSize toOffset, VkDeviceSize bytes);
    void fillZero(VkBuffer buffer);
    // Reads the clock when what was recorded so far is done; the time since the last reading counts to `name`. Beyond
    // `mostStamps`, or on a queue without a clock, nothing happens.
    void stamp(const char* name);
    // Afterwards the host may read and write every buffer.
    void submit();
    void wait();  // for what was submitted; does nothing if nothing was
    // Submits and waits.
    void run() {
        submit();
        wait();
    }
    // The device's time from begin() to the end, in milliseconds; on a queue without a clock the host's from submit()
    // to the end of wait().
    double milliseconds() const { return milliseconds_; }
    // By name, in the order in which they came first.
    const std::vector<PassTime>& passTimes() const { return passTimes_; }
    // Of each stamp, in order.
    const std::vector<double>& stampMilliseconds() const { return stampMilliseconds_; }

  private:
    Device& device_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Owned<VkDevice, VkFence, vkDestroyFence> fence_;
    Owned<VkDevice, VkQueryPool, vkDestroyQueryPool> clock_;
    uint32_t mostStamps_;
    std::vector<const char*> stamps_;
    bool pending_ = false;
    double milliseconds_ = 0.0;
    double submittedAt_ = 0.0;
    std::vector<PassTime> passTimes_;
    std::vector<double> stampMilliseconds_;

    void readClock();
};

}  // namespace cleave
