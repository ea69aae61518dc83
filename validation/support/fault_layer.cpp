// SPDX-License-Identifier: MIT
// A Vulkan layer for tests of the whole program: it makes a chosen call fail, or the device say less than it has. Tests switch it on by the loader's
// own VK_INSTANCE_LAYERS and VK_LAYER_PATH; the program knows nothing of it.
//
// GNOMON_FAULT, words with spaces between:
//   CALL:N:RESULT        the Nth call (from 1 on) of vkAllocateMemory, vkQueueSubmit2, vkWaitForFences or vkCreateComputePipelines is not made and
//                        returns the VkResult; vkWaitForFences and vkQueueSubmit2 with a lost device (-4): and all of them after it
//   CALL:N:sleep         the Nth call sleeps for a minute first
//   timestampValidBits   every queue family has 0 of them, and timestampComputeAndGraphics is false
//   maxImageDimension2D:N
// GNOMON_FAULT_COUNTS: a file that takes "CALL COUNT" lines when the instance is destroyed, and when a call begins to sleep.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>

namespace {

constexpr int32_t kSleep = 1 << 30;

struct Call {
    const char* name;
    std::atomic<uint32_t> count{0};
    uint32_t faultAt = 0;  ///< 0: never
    int32_t result = 0;
};
Call allocate{"vkAllocateMemory"}, submit{"vkQueueSubmit2"}, await{"vkWaitForFences"}, compile{"vkCreateComputePipelines"};
Call* const calls[] = {&allocate, &submit, &await, &compile};
std::atomic<bool> lost{false};
bool noTimestamps = false;
uint32_t mostTexels = 0;  // 0: as the device says

// The next layer's (or the driver's) functions, of the one instance and the one device that the program has. Asked for when these are made: later
// the loader answers with the top of the chain.
PFN_vkGetInstanceProcAddr nextInstanceProc = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceProc = nullptr;
PFN_vkDestroyInstance nextDestroyInstance = nullptr;
PFN_vkCreateDevice nextCreateDevice = nullptr;
PFN_vkGetPhysicalDeviceQueueFamilyProperties nextQueueFamilies = nullptr;
PFN_vkGetPhysicalDeviceProperties nextProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 nextProperties2 = nullptr;
PFN_vkAllocateMemory nextAllocate = nullptr;
PFN_vkQueueSubmit2 nextSubmit = nullptr;
PFN_vkWaitForFences nextAwait = nullptr;
PFN_vkCreateComputePipelines nextCompile = nullptr;

void readFaults() {
    const char* text = std::getenv("GNOMON_FAULT");
    std::stringstream words(text == nullptr ? "" : text);
    for (std::string word; words >> word;) {
        noTimestamps |= word == "timestampValidBits";
        const size_t first = word.find(':'), second = word.find(':', first + 1);
        if (first == std::string::npos) continue;
        const std::string name = word.substr(0, first);
        if (name == "maxImageDimension2D") mostTexels = uint32_t(std::stoul(word.substr(first + 1)));
        for (Call* call : calls) {
            if (name != call->name) continue;
            call->faultAt = uint32_t(std::stoul(word.substr(first + 1)));
            const std::string result = word.substr(second + 1);
            call->result = result == "sleep" ? kSleep : std::stoi(result);
        }
    }
}

void writeCounts() {
    const char* path = std::getenv("GNOMON_FAULT_COUNTS");
    if (path == nullptr) return;
    std::ofstream file(path);
    for (const Call* call : calls) file << call->name << ' ' << call->count << '\n';
}

/// What the call returns without being made; VK_SUCCESS: it is made.
VkResult faultOf(Call& call) {
    const uint32_t number = ++call.count;
    if (lost && (&call == &submit || &call == &await)) return VK_ERROR_DEVICE_LOST;
    if (number != call.faultAt) return VK_SUCCESS;
    if (call.result == kSleep) {
        writeCounts();
        std::this_thread::sleep_for(std::chrono::minutes(1));
        return VK_SUCCESS;
    }
    lost = call.result == VK_ERROR_DEVICE_LOST;
    return VkResult(call.result);
}

VKAPI_ATTR VkResult VKAPI_CALL allocateMemory(VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* host,
                                              VkDeviceMemory* memory) {
    const VkResult fault = faultOf(allocate);
    return fault != VK_SUCCESS ? fault : nextAllocate(device, info, host, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit2(VkQueue queue, uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
    const VkResult fault = faultOf(submit);
    return fault != VK_SUCCESS ? fault : nextSubmit(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, uint32_t count, const VkFence* fences, VkBool32 all, uint64_t timeout) {
    const VkResult done = nextAwait(device, count, fences, all, timeout);
    const VkResult fault = faultOf(await);  // afterwards: the real device must not be left at work
    return fault != VK_SUCCESS ? fault : done;
}

VKAPI_ATTR VkResult VKAPI_CALL createComputePipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                                      const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* host,
                                                      VkPipeline* pipelines) {
    const VkResult fault = faultOf(compile);
    if (fault == VK_SUCCESS) return nextCompile(device, cache, count, infos, host, pipelines);
    std::fill_n(pipelines, count, VkPipeline(VK_NULL_HANDLE));
    return fault;
}

VKAPI_ATTR void VKAPI_CALL getQueueFamilyProperties(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties* families) {
    nextQueueFamilies(device, count, families);
    for (uint32_t i = 0; noTimestamps && families != nullptr && i < *count; ++i) families[i].timestampValidBits = 0;
}

void change(VkPhysicalDeviceLimits& limits) {
    if (noTimestamps) limits.timestampComputeAndGraphics = VK_FALSE;
    if (mostTexels > 0) limits.maxImageDimension2D = mostTexels;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice device, VkPhysicalDeviceProperties* properties) {
    nextProperties(device, properties);
    change(properties->limits);
}

VKAPI_ATTR void VKAPI_CALL getProperties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* properties) {
    nextProperties2(device, properties);
    change(properties->properties.limits);
}

/// The loader's link to the next layer (or the driver) in a create info's chain.
template <class Link, class Info>
Link* linkOf(const Info* info, VkStructureType type) {
    auto* link = static_cast<Link*>(const_cast<void*>(info->pNext));
    while (link != nullptr && !(link->sType == type && link->function == VK_LAYER_LINK_INFO))
        link = static_cast<Link*>(const_cast<void*>(static_cast<const void*>(link->pNext)));
    return link;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* host, VkInstance* instance) {
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
    nextInstanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    readFaults();
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProc(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, host, instance);
    if (result != VK_SUCCESS) return result;
    const auto find = [&]<class Function>(Function& function, const char* name) {
        function = reinterpret_cast<Function>(nextInstanceProc(*instance, name));
    };
    find(nextDestroyInstance, "vkDestroyInstance");
    find(nextCreateDevice, "vkCreateDevice");
    find(nextQueueFamilies, "vkGetPhysicalDeviceQueueFamilyProperties");
    find(nextProperties, "vkGetPhysicalDeviceProperties");
    find(nextProperties2, "vkGetPhysicalDeviceProperties2");
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance, const VkAllocationCallbacks* host) {
    writeCounts();
    nextDestroyInstance(instance, host);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info, const VkAllocationCallbacks* host,
                                            VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
    nextDeviceProc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const VkResult result = nextCreateDevice(physical, info, host, device);
    if (result != VK_SUCCESS) return result;
    const auto find = [&]<class Function>(Function& function, const char* name) {
        function = reinterpret_cast<Function>(nextDeviceProc(*device, name));
    };
    find(nextAllocate, allocate.name);
    find(nextSubmit, submit.name);
    find(nextAwait, await.name);
    find(nextCompile, compile.name);
    return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProc(VkInstance instance, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProc(VkDevice device, const char* name);

PFN_vkVoidFunction ours(std::string_view name) {
    const auto as = [](auto* function) { return reinterpret_cast<PFN_vkVoidFunction>(function); };
    if (name == "vkGetInstanceProcAddr") return as(&getInstanceProc);
    if (name == "vkGetDeviceProcAddr") return as(&getDeviceProc);
    if (name == "vkCreateInstance") return as(&createInstance);
    if (name == "vkDestroyInstance") return as(&destroyInstance);
    if (name == "vkCreateDevice") return as(&createDevice);
    if (name == "vkGetPhysicalDeviceQueueFamilyProperties") return as(&getQueueFamilyProperties);
    if (name == "vkGetPhysicalDeviceProperties") return as(&getProperties);
    if (name == "vkGetPhysicalDeviceProperties2") return as(&getProperties2);
    if (name == allocate.name) return as(&allocateMemory);
    if (name == submit.name) return as(&queueSubmit2);
    if (name == await.name) return as(&waitForFences);
    if (name == compile.name) return as(&createComputePipelines);
    return nullptr;
}

PFN_vkVoidFunction getInstanceProc(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction function = ours(name);
    return function != nullptr || nextInstanceProc == nullptr ? function : nextInstanceProc(instance, name);
}

PFN_vkVoidFunction getDeviceProc(VkDevice device, const char* name) {
    const PFN_vkVoidFunction function = ours(name);
    return function != nullptr ? function : nextDeviceProc(device, name);
}

}  // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    if (version->loaderLayerInterfaceVersion < 2) return VK_ERROR_INITIALIZATION_FAILED;
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = &getInstanceProc;
    version->pfnGetDeviceProcAddr = &getDeviceProc;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
