// Turns what Vulkan returns into errors for people.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

namespace cleave {

// Throws Error naming `what` and the result if that is not VK_SUCCESS.
void check(VkResult result, const std::string& what);

}  // namespace cleave
