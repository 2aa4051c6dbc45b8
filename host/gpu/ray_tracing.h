// The driver's own ray tracing: what a device has of it, and how it is opened with that. cleave compares itself with it
// and never needs it.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <vector>

namespace cleave {

struct RayTracing {
    bool query = false;     // VK_KHR_ray_query
    bool pipeline = false;  // VK_KHR_ray_tracing_pipeline
};

// What to open a device with, so that all that it has of ray tracing can be used. It outlives vkCreateDevice.
class RayTracingRequest {
  public:
    explicit RayTracingRequest(VkPhysicalDevice device);
    RayTracingRequest(const RayTracingRequest&) = delete;
    RayTracingRequest& operator=(const RayTracingRequest&) = delete;

    RayTracing found() const { return found_; }
    std::span<const char* const> extensions() const { return extensions_; }
    // The features, before those of `next`.
    void* chain(void* next);

  private:
    RayTracing found_;
    std::vector<const char*> extensions_;
    VkPhysicalDeviceAccelerationStructureFeaturesKHR structure_{};
    VkPhysicalDeviceRayQueryFeaturesKHR query_{};
    VkPhysicalDeviceRayTracingPipelineFeaturesKHR pipeline_{};
};

}  // namespace cleave
