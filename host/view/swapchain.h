// The images of a window.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

#include "gpu/device.h"

namespace cleave {

// How a surface is drawn to on a device.
struct SurfaceFormat {
    VkSurfaceFormatKHR format{};
    bool isBgr = false;
};
// 8 bits per channel, sRGB colours that are encoded already. Throws Error if the surface has nothing of the kind.
SurfaceFormat chooseFormat(VkPhysicalDevice device, VkSurfaceKHR surface);

class Swapchain {
  public:
    // `size`: of the window, for surfaces that leave it to us. `old`: what it takes the place of, or null. Throws
    // Error.
    Swapchain(const Device& device, VkSurfaceKHR surface, const SurfaceFormat& format, VkRenderPass pass,
              VkExtent2D size, const Swapchain* old);

    struct Image {
        VkImage image = VK_NULL_HANDLE;
        Owned<VkDevice, VkImageView, vkDestroyImageView> view;
        Owned<VkDevice, VkFramebuffer, vkDestroyFramebuffer> framebuffer;
        Owned<VkDevice, VkSemaphore, vkDestroySemaphore> drawn;  // may be presented
    };

    VkSwapchainKHR handle() const { return handle_.get(); }
    VkExtent2D extent() const { return extent_; }
    const Image& image(uint32_t index) const { return images_[index]; }
    uint32_t imageCount() const { return static_cast<uint32_t>(images_.size()); }

  private:
    Owned<VkDevice, VkSwapchainKHR, vkDestroySwapchainKHR> handle_;
    VkExtent2D extent_{};
    std::vector<Image> images_;
};

}  // namespace cleave
