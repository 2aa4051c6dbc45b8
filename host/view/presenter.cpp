#include "view/presenter.h"

#define GLFW_INCLUDE_NONE
#include <vulkan/vulkan.h>
// After Vulkan, whose types it takes.
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <optional>

#include "gpu/allocator.h"
#include "gpu/buffer.h"
#include "gpu/check.h"
#include "gpu/create_device.h"
#include "gpu/device.h"
#include "view/swapchain.h"

namespace cleave {
namespace {

void checkShown(VkResult result, const std::string& what) {
    if (result == VK_ERROR_DEVICE_LOST || result == VK_ERROR_SURFACE_LOST_KHR)
        throw PresenterLost(what + ": the device or its window was lost");
    check(result, what);
}

std::vector<const char*> surfaceExtensions() {
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names) throw Error("no Vulkan driver here can show a window; install one (tools/setup installs lavapipe)");
    return {names, names + count};
}

// A family that computes, draws and presents; -1 if there is none.
int presentingFamily(VkPhysicalDevice device, VkSurfaceKHR surface) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; i++) {
        VkBool32 presents = VK_FALSE;
        if ((families[i].queueFlags & kNeeded) != kNeeded) continue;
        if (vkGetPhysicalDeviceSurfaceSupportKHR(device, i, surface, &presents) == VK_SUCCESS && presents)
            return static_cast<int>(i);
    }
    return -1;
}

bool hasSwapchains(VkPhysicalDevice device) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::ranges::any_of(extensions, [](const VkExtensionProperties& e) {
        return std::string(e.extensionName) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    });
}

void destroyInstanceSurface(VkInstance instance, VkSurfaceKHR surface, const VkAllocationCallbacks* allocator) {
    vkDestroySurfaceKHR(instance, surface, allocator);
}
void destroyLogicalDevice(int, VkDevice device, const VkAllocationCallbacks* allocator) {
    vkDestroyDevice(device, allocator);
}
void freeImageMemory(VmaAllocator allocator, VmaAllocation memory, const VkAllocationCallbacks*) {
    vmaFreeMemory(allocator, memory);
}

// The picture, where the window takes it from.
struct PictureImage {
    uint32_t width = 0, height = 0;
    Buffer upload;
    Owned<VmaAllocator, VmaAllocation, freeImageMemory> memory;
    Owned<VkDevice, VkImage, vkDestroyImage> image;
    bool isNew = true;  // what is in the buffer is not in the image yet

    PictureImage(Device& device, uint32_t w, uint32_t h)
        : width(w),
          height(h),
          upload(device, uint64_t{4} * w * h, VK_BUFFER_USAGE_TRANSFER_SRC_BIT),
          memory(device.allocator()),
          image(device.handle()) {
        VkImageCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = VK_FORMAT_R8G8B8A8_UNORM;
        info.extent = {w, h, 1};
        info.mipLevels = info.arrayLayers = 1;
        info.samples = VK_SAMPLE_COUNT_1_BIT;
        info.tiling = VK_IMAGE_TILING_OPTIMAL;
        info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        check(vkCreateImage(device.handle(), &info, nullptr, image.put()), "making an image for the picture");
        VmaAllocationCreateInfo placed{};
        placed.requiredFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
        check(vmaAllocateMemoryForImage(device.allocator(), image.get(), &placed, memory.put(), nullptr),
              "making an image for the picture");
        check(vmaBindImageMemory(device.allocator(), memory.get(), image.get()), "making an image for the picture");
    }
};

struct Access {
    VkImageLayout layout;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
};
constexpr Access kUndefined{VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0};
constexpr Access kCopiedTo{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                           VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr Access kCopiedFrom{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                             VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr Access kDrawnTo{VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                          VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
constexpr Access kPresented{VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0};

void turn(VkCommandBuffer commands, VkImage image, const Access& from, const Access& to) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = from.stages;
    barrier.srcAccessMask = from.access;
    barrier.dstStageMask = to.stages;
    barrier.dstAccessMask = to.access;
    barrier.oldLayout = from.layout;
    barrier.newLayout = to.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

VkBufferImageCopy wholeImage(VkExtent2D extent) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {extent.width, extent.height, 1};
    return copy;
}

}  // namespace

struct Presenter::State {
    GLFWwindow* window;
    Instance instance;
    Owned<VkInstance, VkSurfaceKHR, destroyInstanceSurface> surface;
    Owned<int, VkDevice, destroyLogicalDevice> logical;
    std::optional<Device> device;
    SurfaceFormat format;
    Owned<VkDevice, VkRenderPass, vkDestroyRenderPass> pass;
    Owned<VkDevice, VkDescriptorPool, vkDestroyDescriptorPool> descriptors;  // of ImGui
    Owned<VkDevice, VkSemaphore, vkDestroySemaphore> acquired;
    Owned<VkDevice, VkFence, vkDestroyFence> done;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::optional<Swapchain> swapchain;
    std::optional<PictureImage> picture;
    bool outOfDate = true;
    bool hasImGui = false;

    State(GLFWwindow* w, const std::string& name, ValidationListener listener)
        : window(w), instance(std::move(listener), surfaceExtensions()), surface(instance.handle()) {
        checkShown(glfwCreateWindowSurface(instance.handle(), window, nullptr, surface.put()),
                   "connecting the window with Vulkan");
        openDevice(name);
        format = chooseFormat(device->physicalDevice(), surface.get());
        makePass();
        makeFrame();
        initImGui();
    }

    ~State() {
        if (device) vkDeviceWaitIdle(device->handle());
        if (hasImGui) ImGui_ImplVulkan_Shutdown();
    }

    // The device that is named, if it can show a window; else any that can.
    VkPhysicalDevice choose(const std::string& name) const {
        const std::vector<VkPhysicalDevice> devices = instance.devices();
        std::vector<DeviceInfo> infos;
        for (VkPhysicalDevice d : devices) infos.push_back(describe(d, static_cast<uint32_t>(infos.size())));
        const auto shows = [&](uint32_t i) {
            return infos[i].usable && hasSwapchains(devices[i]) && presentingFamily(devices[i], surface.get()) >= 0;
        };
        if (const uint32_t wanted = chooseDevice(infos, name); shows(wanted)) return devices[wanted];
        for (uint32_t i = 0; i < devices.size(); ++i)
            if (shows(i)) return devices[i];
        throw Error("no Vulkan device here can show a window on this display; `cleave render` needs none");
    }

    void openDevice(const std::string& name) {
        Device::Adopted adopted{};
        adopted.instance = instance.handle();
        adopted.physicalDevice = choose(name);
        adopted.queueFamily = static_cast<uint32_t>(presentingFamily(adopted.physicalDevice, surface.get()));
        const char* extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
        adopted.queue = createDevice(adopted.physicalDevice, adopted.queueFamily, {&extension, 1}, nullptr,
                                     logical.put(), "opening the window's device");
        adopted.device = logical.get();
        device.emplace(adopted, DeviceOptions{});
    }

    // ImGui draws over the picture, which is there.
    void makePass() {
        VkAttachmentDescription colour{};
        colour.format = format.format.format;
        colour.samples = VK_SAMPLE_COUNT_1_BIT;
        colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
        colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        colour.initialLayout = colour.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
        VkSubpassDescription subpass{};
        subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
        subpass.colorAttachmentCount = 1;
        subpass.pColorAttachments = &reference;
        VkRenderPassCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
        info.attachmentCount = 1;
        info.pAttachments = &colour;
        info.subpassCount = 1;
        info.pSubpasses = &subpass;
        pass = Owned<VkDevice, VkRenderPass, vkDestroyRenderPass>(device->handle());
        check(vkCreateRenderPass(device->handle(), &info, nullptr, pass.put()), "making the window's render pass");
    }

    void makeFrame() {
        VkSemaphoreCreateInfo semaphore{};
        semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        acquired = Owned<VkDevice, VkSemaphore, vkDestroySemaphore>(device->handle());
        check(vkCreateSemaphore(device->handle(), &semaphore, nullptr, acquired.put()), "creating a semaphore");
        VkFenceCreateInfo fence{};
        fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
        done = Owned<VkDevice, VkFence, vkDestroyFence>(device->handle());
        check(vkCreateFence(device->handle(), &fence, nullptr, done.put()), "creating a fence");
        VkCommandBufferAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocate.commandPool = device->commandPool();
        allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocate.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(device->handle(), &allocate, &commands), "allocating a command buffer");
    }

    void begin() const {
        VkCommandBufferBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        check(vkBeginCommandBuffer(commands, &info), "recording commands");
    }

    void wait() const {
        const VkFence fence = done.get();
        checkShown(vkWaitForFences(device->handle(), 1, &fence, VK_TRUE, UINT64_MAX), "waiting for the window");
    }

    // `image`: what is drawn to, once it is acquired; null: the work has nothing to do with the window.
    void submit(const Swapchain::Image* image) const {
        check(vkEndCommandBuffer(commands), "recording commands");
        VkCommandBufferSubmitInfo buffer{};
        buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
        buffer.commandBuffer = commands;
        VkSemaphoreSubmitInfo before{}, after{};
        before.sType = after.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
        before.semaphore = acquired.get();
        before.stageMask = after.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        VkSubmitInfo2 info{};
        info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
        info.commandBufferInfoCount = 1;
        info.pCommandBufferInfos = &buffer;
        if (image) {
            after.semaphore = image->drawn.get();
            info.waitSemaphoreInfoCount = info.signalSemaphoreInfoCount = 1;
            info.pWaitSemaphoreInfos = &before;
            info.pSignalSemaphoreInfos = &after;
        }
        const VkFence fence = done.get();
        check(vkResetFences(device->handle(), 1, &fence), "resetting a fence");
        checkShown(vkQueueSubmit2(device->queue(), 1, &info, fence), "drawing the window");
    }

    void initImGui() {
        const VkDescriptorPoolSize sizes{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
        VkDescriptorPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        pool.maxSets = 1;
        pool.poolSizeCount = 1;
        pool.pPoolSizes = &sizes;
        descriptors = Owned<VkDevice, VkDescriptorPool, vkDestroyDescriptorPool>(device->handle());
        check(vkCreateDescriptorPool(device->handle(), &pool, nullptr, descriptors.put()),
              "making the window's descriptors");
        ImGui_ImplVulkan_InitInfo info{};
        info.Instance = instance.handle();
        info.PhysicalDevice = device->physicalDevice();
        info.Device = device->handle();
        info.QueueFamily = static_cast<uint32_t>(presentingFamily(device->physicalDevice(), surface.get()));
        info.Queue = device->queue();
        info.DescriptorPool = descriptors.get();
        info.MinImageCount = info.ImageCount = 2;
        info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
        info.CheckVkResultFn = [](VkResult result) { checkShown(result, "drawing the panels"); };
        hasImGui = ImGui_ImplVulkan_Init(&info, pass.get());
        begin();
        ImGui_ImplVulkan_CreateFontsTexture(commands);
        submit(nullptr);
        wait();
        ImGui_ImplVulkan_DestroyFontUploadObjects();
    }

    // False while the window has no size.
    bool renewSwapchain() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width <= 0 || height <= 0) return false;
        checkShown(vkDeviceWaitIdle(device->handle()), "waiting for the window");
        std::optional<Swapchain> old = std::move(swapchain);
        swapchain.reset();
        swapchain.emplace(*device, surface.get(), format, pass.get(),
                          VkExtent2D{static_cast<uint32_t>(width), static_cast<uint32_t>(height)},
                          old ? &*old : nullptr);
        outOfDate = false;
        return true;
    }

    void uploadPicture() {
        if (!picture || !picture->isNew) return;
        turn(commands, picture->image.get(), kUndefined, kCopiedTo);
        const VkBufferImageCopy copy = wholeImage({picture->width, picture->height});
        vkCmdCopyBufferToImage(commands, picture->upload.handle(), picture->image.get(),
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
        turn(commands, picture->image.get(), kCopiedTo, kCopiedFrom);
        picture->isNew = false;
    }

    void drawPicture(VkImage to) const {
        const VkExtent2D extent = swapchain->extent();
        if (!picture) {
            const VkClearColorValue dark{{0.08f, 0.09f, 0.10f, 1.0f}};
            const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
            vkCmdClearColorImage(commands, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark, 1, &all);
            return;
        }
        VkImageBlit region{};
        region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.srcOffsets[1] = {static_cast<int32_t>(picture->width), static_cast<int32_t>(picture->height), 1};
        region.dstOffsets[1] = {static_cast<int32_t>(extent.width), static_cast<int32_t>(extent.height), 1};
        const bool same = picture->width == extent.width && picture->height == extent.height;
        vkCmdBlitImage(commands, picture->image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, same ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
    }

    void drawPanels(const Swapchain::Image& image) const {
        VkRenderPassBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
        info.renderPass = pass.get();
        info.framebuffer = image.framebuffer.get();
        info.renderArea.extent = swapchain->extent();
        vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
        ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
        vkCmdEndRenderPass(commands);
    }

    // What was copied to buffers.
    void showToHost() const {
        VkMemoryBarrier2 barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
        barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
        barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
        VkDependencyInfo dependency{};
        dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
        dependency.memoryBarrierCount = 1;
        dependency.pMemoryBarriers = &barrier;
        vkCmdPipelineBarrier2(commands, &dependency);
    }

    Pixels read(const Buffer& buffer) const {
        Pixels pixels{swapchain->extent().width, swapchain->extent().height, {}};
        pixels.values = buffer.download<uint32_t>(size_t{pixels.width} * pixels.height);
        for (uint32_t& p : pixels.values) {
            if (format.isBgr) p = (p & 0xFF00FF00u) | (p & 0xFFu) << 16 | (p >> 16 & 0xFFu);
            p |= 0xFF000000u;
        }
        return pixels;
    }

    bool present(Pixels* capture) {
        wait();
        if (outOfDate && !renewSwapchain()) return false;
        uint32_t index = 0;
        const VkResult got = vkAcquireNextImageKHR(device->handle(), swapchain->handle(), UINT64_MAX, acquired.get(),
                                                   VK_NULL_HANDLE, &index);
        if (got == VK_ERROR_OUT_OF_DATE_KHR) {
            outOfDate = true;
            return false;
        }
        if (got != VK_SUBOPTIMAL_KHR) checkShown(got, "taking an image of the window");
        const Swapchain::Image& image = swapchain->image(index);
        const VkExtent2D extent = swapchain->extent();
        std::optional<Buffer> shown;
        if (capture) shown.emplace(*device, uint64_t{4} * extent.width * extent.height);

        begin();
        uploadPicture();
        turn(commands, image.image, kUndefined, kCopiedTo);
        drawPicture(image.image);
        turn(commands, image.image, kCopiedTo, kDrawnTo);
        drawPanels(image);
        if (shown) {
            turn(commands, image.image, kDrawnTo, kCopiedFrom);
            const VkBufferImageCopy copy = wholeImage(extent);
            vkCmdCopyImageToBuffer(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, shown->handle(), 1,
                                   &copy);
            showToHost();
            turn(commands, image.image, kCopiedFrom, kPresented);
        } else {
            turn(commands, image.image, kDrawnTo, kPresented);
        }
        submit(&image);
        if (shown) {
            wait();
            *capture = read(*shown);
        }

        const VkSemaphore drawn = image.drawn.get();
        const VkSwapchainKHR handle = swapchain->handle();
        VkPresentInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
        info.waitSemaphoreCount = 1;
        info.pWaitSemaphores = &drawn;
        info.swapchainCount = 1;
        info.pSwapchains = &handle;
        info.pImageIndices = &index;
        const VkResult presented = vkQueuePresentKHR(device->queue(), &info);
        outOfDate = presented == VK_ERROR_OUT_OF_DATE_KHR || presented == VK_SUBOPTIMAL_KHR || got == VK_SUBOPTIMAL_KHR;
        if (presented != VK_ERROR_OUT_OF_DATE_KHR && presented != VK_SUBOPTIMAL_KHR)
            checkShown(presented, "presenting the window");
        return presented != VK_ERROR_OUT_OF_DATE_KHR;
    }
};

Presenter::Presenter(GLFWwindow* window, const std::string& device, ValidationListener listener)
    : state_(std::make_unique<State>(window, device, std::move(listener))) {}
Presenter::~Presenter() = default;

std::string Presenter::deviceName() const { return state_->device->name(); }

void Presenter::setPicture(uint32_t width, uint32_t height, std::span<const uint32_t> pixels) {
    State& s = *state_;
    s.wait();
    if (!s.picture || s.picture->width != width || s.picture->height != height) {
        s.picture.reset();
        s.picture.emplace(*s.device, width, height);
    }
    s.picture->upload.write(0, pixels.data(), pixels.size_bytes());
    s.picture->isNew = true;
}

bool Presenter::present(Pixels* capture) { return state_->present(capture); }

}  // namespace cleave
