#include "view/swapchain.h"

#include <algorithm>

#include "base/error.h"
#include "gpu/check.h"

namespace cleave {
namespace {

// What a picture is copied to, drawn over, and read back from.
constexpr VkImageUsageFlags kUses =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

VkExtent2D extentOf(const VkSurfaceCapabilitiesKHR& can, VkExtent2D size) {
    if (can.currentExtent.width != UINT32_MAX) return can.currentExtent;
    return {std::clamp(size.width, can.minImageExtent.width, can.maxImageExtent.width),
            std::clamp(size.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

VkCompositeAlphaFlagBitsKHR alphaOf(const VkSurfaceCapabilitiesKHR& can) {
    return can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                                                                           : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
}

}  // namespace

SurfaceFormat chooseFormat(VkPhysicalDevice device, VkSurfaceKHR surface) {
    uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, nullptr), "listing the window's formats");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, formats.data()),
          "listing the window's formats");
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
        for (const VkSurfaceFormatKHR& format : formats)
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return {format, wanted == VK_FORMAT_B8G8R8A8_UNORM};
    throw Error("the window takes no colours of 8 bits per channel on this device; try another --device");
}

Swapchain::Swapchain(const Device& device, VkSurfaceKHR surface, const SurfaceFormat& format, VkRenderPass pass,
                     VkExtent2D size, const Swapchain* old)
    : handle_(device.handle()) {
    VkSurfaceCapabilitiesKHR can{};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physicalDevice(), surface, &can), "asking for the window");
    if ((can.supportedUsageFlags & kUses) != kUses)
        throw Error("the window's images cannot be copied to on this device; try another --device");
    extent_ = extentOf(can, size);
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = surface;
    info.minImageCount = std::max(2u, can.minImageCount);
    if (can.maxImageCount != 0) info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
    info.imageFormat = format.format.format;
    info.imageColorSpace = format.format.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = kUses;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = can.currentTransform;
    info.compositeAlpha = alphaOf(can);
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = old ? old->handle() : VK_NULL_HANDLE;
    check(vkCreateSwapchainKHR(device.handle(), &info, nullptr, handle_.put()), "making the window's images");

    uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(device.handle(), handle(), &count, nullptr), "listing the window's images");
    std::vector<VkImage> images(count);
    check(vkGetSwapchainImagesKHR(device.handle(), handle(), &count, images.data()), "listing the window's images");
    for (const VkImage image : images) {
        Image& made = images_.emplace_back();
        made.image = image;
        VkImageViewCreateInfo view{};
        view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        view.image = image;
        view.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view.format = info.imageFormat;
        view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        made.view = Owned<VkDevice, VkImageView, vkDestroyImageView>(device.handle());
        check(vkCreateImageView(device.handle(), &view, nullptr, made.view.put()), "making the window's images");
        const VkImageView attachment = made.view.get();
        VkFramebufferCreateInfo framebuffer{};
        framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
        framebuffer.renderPass = pass;
        framebuffer.attachmentCount = 1;
        framebuffer.pAttachments = &attachment;
        framebuffer.width = extent_.width;
        framebuffer.height = extent_.height;
        framebuffer.layers = 1;
        made.framebuffer = Owned<VkDevice, VkFramebuffer, vkDestroyFramebuffer>(device.handle());
        check(vkCreateFramebuffer(device.handle(), &framebuffer, nullptr, made.framebuffer.put()),
              "making the window's images");
        VkSemaphoreCreateInfo semaphore{};
        semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        made.drawn = Owned<VkDevice, VkSemaphore, vkDestroySemaphore>(device.handle());
        check(vkCreateSemaphore(device.handle(), &semaphore, nullptr, made.drawn.put()), "creating a semaphore");
    }
}

}  // namespace cleave
