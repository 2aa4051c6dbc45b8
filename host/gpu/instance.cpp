#include "gpu/instance.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "cleave/cleave.hpp"
#include "gpu/check.h"

namespace cleave {

namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    (*static_cast<const ValidationListener*>(user))(data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationListener* listener) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = listener;
    return info;
}

template <class Function>
Function instanceFunction(VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

const char* typeName(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

// The name of a feature that the library requires and the device lacks, or nothing.
std::string missingFeatures(VkPhysicalDevice device, uint32_t apiVersion) {
    const Requirements needed = requirements();
    if (apiVersion < needed.apiVersion) return "Vulkan 1.3";
    if (computeFamily(device) < 0) return "a compute queue";
    VkPhysicalDeviceVulkan13Features f13{};
    f13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features f12{};
    f12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    f12.pNext = &f13;
    VkPhysicalDeviceFeatures2 f{};
    f.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    f.pNext = &f12;
    vkGetPhysicalDeviceFeatures2(device, &f);
    if (!f.features.shaderFloat64) return "shaderFloat64";
    if (!f12.bufferDeviceAddress) return "bufferDeviceAddress";
    if (!f12.scalarBlockLayout) return "scalarBlockLayout";
    if (!f13.synchronization2) return "synchronization2";
    if (!f13.maintenance4) return "maintenance4";
    return "";
}

std::string lower(std::string s) {
    std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
}

}  // namespace

void Instance::destroyInstance(int, VkInstance instance, const VkAllocationCallbacks* allocator) {
    vkDestroyInstance(instance, allocator);
}

void Instance::destroyMessenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger,
                                const VkAllocationCallbacks* allocator) {
    instanceFunction<PFN_vkDestroyDebugUtilsMessengerEXT>(instance, "vkDestroyDebugUtilsMessengerEXT")(
        instance, messenger, allocator);
}

Instance::Instance(ValidationListener listener, std::span<const char* const> extensions) : instance_(0) {
    VkApplicationInfo app{};
    app.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    app.pApplicationName = "cleave";
    app.apiVersion = requirements().apiVersion;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &app;

    const bool validates = static_cast<bool>(listener);
    listener_ = std::make_unique<ValidationListener>(std::move(listener));
    const char* layer = "VK_LAYER_KHRONOS_validation";
    std::vector<const char*> enabledExtensions(extensions.begin(), extensions.end());
    const VkValidationFeatureEnableEXT enabled = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{};
    VkDebugUtilsMessengerCreateInfoEXT debug = messengerInfo(listener_.get());
    if (validates) {
        features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
        features.enabledValidationFeatureCount = 1;
        features.pEnabledValidationFeatures = &enabled;
        features.pNext = &debug;
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &layer;
        enabledExtensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        enabledExtensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }
    info.enabledExtensionCount = static_cast<uint32_t>(enabledExtensions.size());
    info.ppEnabledExtensionNames = enabledExtensions.data();
    const VkResult result = vkCreateInstance(&info, nullptr, instance_.put());
    if (result == VK_ERROR_LAYER_NOT_PRESENT)
        throw Error(
            "validation was asked for but VK_LAYER_KHRONOS_validation is not installed; install "
            "vulkan-validationlayers");
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        throw Error("no Vulkan driver was found; install one (tools/setup installs Mesa's lavapipe)");
    check(result, "creating the Vulkan instance");
    if (!validates) return;
    messenger_ = Owned<VkInstance, VkDebugUtilsMessengerEXT, destroyMessenger>(instance_.get());
    auto create =
        instanceFunction<PFN_vkCreateDebugUtilsMessengerEXT>(instance_.get(), "vkCreateDebugUtilsMessengerEXT");
    check(create(instance_.get(), &debug, nullptr, messenger_.put()), "creating the validation messenger");
}

std::vector<VkPhysicalDevice> Instance::devices() const {
    uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(handle(), &count, nullptr), "listing the Vulkan devices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(handle(), &count, devices.data()), "listing the Vulkan devices");
    devices.resize(count);
    return devices;
}

int computeFamily(VkPhysicalDevice device) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (uint32_t i = 0; i < count; i++)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return static_cast<int>(i);
    return -1;
}

DeviceInfo describe(VkPhysicalDevice device, uint32_t index) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);
    const VkPhysicalDeviceProperties& p = properties.properties;
    DeviceInfo info;
    info.index = index;
    info.name = p.deviceName;
    info.type = typeName(p.deviceType);
    info.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    info.apiVersion = std::to_string(VK_API_VERSION_MAJOR(p.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_MINOR(p.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_PATCH(p.apiVersion));
    const std::string lacks = missingFeatures(device, p.apiVersion);
    info.usable = lacks.empty();
    if (!info.usable) info.unusableWhy = "lacks " + lacks;
    return info;
}

uint32_t chooseDevice(const std::vector<DeviceInfo>& infos, const std::string& nameOrIndex) {
    if (!nameOrIndex.empty()) {
        const bool number =
            std::all_of(nameOrIndex.begin(), nameOrIndex.end(), [](char c) { return c >= '0' && c <= '9'; });
        for (const DeviceInfo& i : infos) {
            const bool named = number ? std::to_string(i.index) == nameOrIndex
                                      : lower(i.name).find(lower(nameOrIndex)) != std::string::npos;
            if (!named) continue;
            if (!i.usable)
                throw Error("device " + i.name + " cannot be used: it " + i.unusableWhy + "; see `cleave devices`");
            return i.index;
        }
        throw Error("no device is called '" + nameOrIndex + "'; `cleave devices` lists what there is");
    }
    const std::vector<std::string> order = {"discrete GPU", "integrated GPU", "virtual GPU", "other", "CPU"};
    for (const std::string& type : order)
        for (const DeviceInfo& i : infos)
            if (i.usable && i.type == type) return i.index;
    throw Error(infos.empty() ? "no Vulkan device was found; install a driver (tools/setup installs Mesa's lavapipe)"
                              : "no Vulkan device here can be used; `cleave devices` says what each lacks");
}

std::vector<DeviceInfo> listDevices() {
    const Instance instance;
    std::vector<DeviceInfo> infos;
    for (VkPhysicalDevice d : instance.devices()) infos.push_back(describe(d, static_cast<uint32_t>(infos.size())));
    const bool any = std::any_of(infos.begin(), infos.end(), [](const DeviceInfo& i) { return i.usable; });
    if (any) infos[chooseDevice(infos, "")].chosen = true;
    return infos;
}

}  // namespace cleave
