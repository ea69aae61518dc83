// SPDX-License-Identifier: MIT
#include "host_min/vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

// What ray queries need; enabled together, and only on a device that has all of it (DeviceFacts::rayQuery).
constexpr std::array kRayQueryExtensions{VK_KHR_RAY_QUERY_EXTENSION_NAME, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                         VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* counter) {
    if (severity < VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT) return VK_FALSE;
    static_cast<std::atomic<uint64_t>*>(counter)->fetch_add(1);
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    return VK_FALSE;
}

/// Mesa 25.0's disk cache of lavapipe shaders forgets the vector width: code for another width would be run, and subgroups vanish. So each width has
/// a folder of its own below the folder that Mesa would use; where there is none, no cache.
void separateShaderCaches() {
    const char* const width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
    if (!width || std::getenv("MESA_SHADER_CACHE_DISABLE")) return;
    namespace fs = std::filesystem;
    const auto folder = [](const char* variable, const char* below) {
        const char* const value = std::getenv(variable);
        if (!value || !*value) return fs::path();
        return *below ? fs::path(value) / below : fs::path(value);
    };
    fs::path base;
    for (const auto& [variable, below] : {std::pair("MESA_SHADER_CACHE_DIR", ""), std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")})
        if (base.empty()) base = folder(variable, below);
    const std::string bits = width, name = "gnomon-lavapipe-" + bits;
    if (base.filename() == name) return;  // a second device of this process
    std::error_code error;
    const bool isNumber = !bits.empty() && bits.find_first_not_of("0123456789") == std::string::npos;
    if (isNumber && !base.empty()) fs::create_directories(base / name, error);
    if (isNumber && !base.empty() && !error)
        setenv("MESA_SHADER_CACHE_DIR", (base / name).c_str(), 1);
    else
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

vk::raii::Instance makeInstance(const vk::raii::Context& context, bool validation) {
    separateShaderCaches();
    const vk::ApplicationInfo application("gnomon", 1, "gnomon", 1, VK_API_VERSION_1_3);
    std::vector<const char*> layers, extensions;
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features(synchronization, {});
    vk::InstanceCreateInfo info({}, &application);
    if (validation) {
        bool found = false;
        for (const auto& layer : context.enumerateInstanceLayerProperties()) found |= std::string_view(layer.layerName) == kValidationLayer;
        if (!found)
            throw InputError(
                "the Khronos validation layer is not installed (Debian: vulkan-validationlayers); set GNOMON_VALIDATE=0 to run without it");
        layers.push_back(kValidationLayer);
        extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
        info.setPNext(&features);
    }
    info.setPEnabledLayerNames(layers).setPEnabledExtensionNames(extensions);
    try {
        return {context, info};
    } catch (const vk::SystemError& error) {
        throw InputError(fmt::format("no Vulkan instance ({}): install a Vulkan 1.3 driver (Debian: mesa-vulkan-drivers) or check VK_DRIVER_FILES",
                                     error.what()));
    }
}

/// The first that can draw and compute; one with time stamps where there is one.
std::optional<uint32_t> findQueueFamily(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    const auto needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    std::optional<uint32_t> found;
    for (uint32_t i = 0; i < families.size(); ++i) {
        if ((families[i].queueFlags & needed) != needed) continue;
        if (families[i].timestampValidBits > 0) return i;
        if (!found) found = i;
    }
    return found;
}

bool hasRayQuery(const vk::raii::PhysicalDevice& device) {
    const auto there = device.enumerateDeviceExtensionProperties();
    for (const char* wanted : kRayQueryExtensions)
        if (std::none_of(there.begin(), there.end(), [&](const auto& extension) { return std::string_view(extension.extensionName) == wanted; }))
            return false;
    const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                                              vk::PhysicalDeviceAccelerationStructureFeaturesKHR, vk::PhysicalDeviceRayQueryFeaturesKHR>();
    return features.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery &&
           features.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure &&
           features.get<vk::PhysicalDeviceVulkan12Features>().bufferDeviceAddress;
}

DeviceFacts factsOf(const vk::raii::PhysicalDevice& device) {
    const auto properties =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties, vk::PhysicalDeviceSubgroupProperties>();
    const auto& base = properties.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = properties.get<vk::PhysicalDeviceDriverProperties>();
    DeviceFacts facts;
    facts.deviceName = base.deviceName.data();
    facts.driverName = driver.driverName.data();
    facts.driverInfo = driver.driverInfo.data();
    facts.isLavapipe = driver.driverID == vk::DriverId::eMesaLlvmpipe;
    facts.apiVersionMajor = VK_API_VERSION_MAJOR(base.apiVersion);
    facts.apiVersionMinor = VK_API_VERSION_MINOR(base.apiVersion);
    const std::optional<uint32_t> family = findQueueFamily(device);
    facts.hasGraphicsAndComputeQueue = family.has_value();
    facts.timestampValidBits = family ? device.getQueueFamilyProperties()[*family].timestampValidBits : 0;
    facts.maxStorageBufferRange = base.limits.maxStorageBufferRange;
    facts.maxImageDimension2D = base.limits.maxImageDimension2D;
    facts.maxBoundDescriptorSets = base.limits.maxBoundDescriptorSets;
    facts.maxPushConstantsSize = base.limits.maxPushConstantsSize;
    facts.maxColorAttachments = base.limits.maxColorAttachments;
    facts.maxComputeWorkGroupInvocations = std::min(base.limits.maxComputeWorkGroupInvocations, base.limits.maxComputeWorkGroupSize[0]);
    const auto& subgroup = properties.get<vk::PhysicalDeviceSubgroupProperties>();
    facts.subgroupSize = subgroup.subgroupSize;
    facts.subgroupBallot = bool(subgroup.supportedOperations & vk::SubgroupFeatureFlagBits::eBallot) &&
                           bool(subgroup.supportedStages & vk::ShaderStageFlagBits::eCompute);
    facts.dynamicRendering = facts.synchronization2 = false;
    if (base.apiVersion >= VK_API_VERSION_1_3) {
        const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>();
        facts.dynamicRendering = features.get<vk::PhysicalDeviceVulkan13Features>().dynamicRendering;
        facts.synchronization2 = features.get<vk::PhysicalDeviceVulkan13Features>().synchronization2;
        facts.rayQuery = hasRayQuery(device);
    }
    if (facts.rayQuery)
        facts.scratchAlignment = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceAccelerationStructurePropertiesKHR>()
                                     .get<vk::PhysicalDeviceAccelerationStructurePropertiesKHR>()
                                     .minAccelerationStructureScratchOffsetAlignment;
    return facts;
}

}  // namespace

DeviceOptions DeviceOptions::fromEnvironment() {
    DeviceOptions options;
    if (const char* wanted = std::getenv("GNOMON_DEVICE")) options.wanted = wanted;
#ifndef NDEBUG
    options.validation = true;
#endif
    if (const char* validate = std::getenv("GNOMON_VALIDATE")) options.validation = std::string_view(validate) != "0";
    return options;
}

Device::Device(const DeviceOptions& options) : instance_(makeInstance(context_, options.validation)) {
    if (options.validation) {
        using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
        using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
        vk::DebugUtilsMessengerCreateInfoEXT info({}, Severity::eWarning | Severity::eError, Type::eGeneral | Type::eValidation);
        info.pfnUserCallback = reinterpret_cast<decltype(info.pfnUserCallback)>(&onMessage);
        info.pUserData = &messages_;
        messenger_ = vk::raii::DebugUtilsMessengerEXT(instance_, info);
    }
    std::vector<vk::raii::PhysicalDevice> devices = instance_.enumeratePhysicalDevices();
    std::vector<DeviceFacts> facts;
    for (const auto& device : devices) facts.push_back(factsOf(device));
    const size_t chosen = chooseDevice(facts, options.wanted);
    physical_ = std::move(devices[chosen]);
    facts_ = facts[chosen];
    queueFamily_ = *findQueueFamily(physical_);
    memory_ = physical_.getMemoryProperties();
    timestampPeriod_ = physical_.getProperties().limits.timestampPeriod;

    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue({}, queueFamily_, 1, &priority);
    vk::PhysicalDeviceVulkan13Features features13;
    features13.dynamicRendering = features13.synchronization2 = VK_TRUE;
    vk::DeviceCreateInfo info({}, queue);
    info.pNext = &features13;
    vk::PhysicalDeviceVulkan12Features features12;
    vk::PhysicalDeviceAccelerationStructureFeaturesKHR structures;
    vk::PhysicalDeviceRayQueryFeaturesKHR queries;
    features12.bufferDeviceAddress = structures.accelerationStructure = queries.rayQuery = VK_TRUE;
    if (facts_.rayQuery) {
        info.setPEnabledExtensionNames(kRayQueryExtensions);
        features13.pNext = &features12;
        features12.pNext = &structures;
        structures.pNext = &queries;
    }
    device_ = vk::raii::Device(physical_, info);
    queue_ = device_.getQueue(queueFamily_, 0);
}

uint32_t Device::memoryType(uint32_t allowed, vk::MemoryPropertyFlags wanted) const {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
        if ((allowed >> i & 1u) && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    throw WorkError(fmt::format("the device has no memory type with {}", vk::to_string(wanted)));
}

std::vector<DeviceFacts> Device::list() {
    const vk::raii::Context context;
    const vk::raii::Instance instance = makeInstance(context, false);
    std::vector<DeviceFacts> facts;
    for (const auto& device : instance.enumeratePhysicalDevices()) facts.push_back(factsOf(device));
    return facts;
}

}  // namespace gno::host
