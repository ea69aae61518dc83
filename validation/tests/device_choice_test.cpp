// SPDX-License-Identifier: MIT
// Which device is chosen, and what is said of those that are not: made-up devices, no Vulkan.
#include <gtest/gtest.h>

#include <functional>

#include "host_min/error.hpp"
#include "host_min/vulkan/requirements.hpp"

namespace gno::host {
namespace {

DeviceFacts lavapipe(const std::string& version) {
    DeviceFacts facts;
    facts.deviceName = "llvmpipe (LLVM 15.0.6, 256 bits)";
    facts.driverName = "llvmpipe";
    facts.driverInfo = "Mesa " + version + " (LLVM 15.0.6)";
    facts.isLavapipe = true;
    return facts;
}

DeviceFacts gpu(const std::string& name, const std::string& driverInfo = "Mesa 22.3.6") {
    DeviceFacts facts;
    facts.deviceName = name;
    facts.driverName = "a GPU's own driver";
    facts.driverInfo = driverInfo;
    return facts;
}

/// The refusal's text; empty when a device is chosen.
std::string refusal(const std::vector<DeviceFacts>& devices, const std::string& wanted = {}) {
    try {
        chooseDevice(devices, wanted);
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return {};
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(DeviceChoice, NoneAtAll) {
    const std::string text = refusal({});
    EXPECT_TRUE(says(text, "no Vulkan device found")) << text;
    EXPECT_TRUE(says(text, "mesa-vulkan-drivers")) << text;
    EXPECT_TRUE(says(refusal({}, "llvmpipe"), "no Vulkan device found"));
}

TEST(DeviceChoice, OldLavapipeIsRefusedWithTheReasonAndTheCure) {
    for (const char* version : {"22.3.6", "24.0.9", "23.99.0", "20.3.5"}) {
        const std::string text = refusal({lavapipe(version)});
        EXPECT_TRUE(says(text, std::string("Mesa ") + version)) << text;
        EXPECT_TRUE(says(text, "silently wrong")) << text;
        EXPECT_TRUE(says(text, "24.1")) << text;
        EXPECT_TRUE(says(text, "bookworm-backports")) << text;
        EXPECT_TRUE(says(text, "setup.sh")) << text;
    }
}

TEST(DeviceChoice, LavapipeWithoutAVersionIsRefused) {
    DeviceFacts facts = lavapipe("");
    for (const char* info : {"", "git-1234abc", "Mesa", "Mesa ", "Mesa x.y", "Mesa 25"}) {
        facts.driverInfo = info;
        EXPECT_TRUE(says(refusal({facts}), "newer lavapipe")) << info;
    }
}

TEST(DeviceChoice, NewLavapipeIsAccepted) {
    for (const char* version : {"24.1", "24.1.0", "24.3.4", "25.0.7-2~bpo12+1", "100.0.0"}) EXPECT_EQ(refusal({lavapipe(version)}), "") << version;
}

TEST(DeviceChoice, AGpuWithOldMesaIsAccepted) {
    EXPECT_EQ(refusal({gpu("AMD Radeon RX 6800 (RADV NAVI21)", "Mesa 22.3.6")}), "");
    EXPECT_EQ(refusal({gpu("NVIDIA GeForce RTX 3060", "535.161.07")}), "");
}

TEST(DeviceChoice, MesaVersion) {
    using Version = std::pair<int, int>;
    EXPECT_EQ(mesaVersion("Mesa 25.0.7-2~bpo12+1 (LLVM 15.0.6)"), Version(25, 0));
    EXPECT_EQ(mesaVersion("Mesa 24.1"), Version(24, 1));
    EXPECT_EQ(mesaVersion("Mesa 22.3.6"), Version(22, 3));
    EXPECT_EQ(mesaVersion("Mesa 24.1.0-devel (git-0123456789)"), Version(24, 1));
    EXPECT_EQ(mesaVersion("something, Mesa 9.10.11"), Version(9, 10));
    for (const char* none : {"", "535.161.07", "Mesa", "Mesa ", "Mesa 25", "Mesa x.1", "mesa 25.0", "Mesa 99999999999.1"})
        EXPECT_EQ(mesaVersion(none), Version(0, 0)) << none;
}

struct Lack {
    const char* field;  ///< as the refusal must name it
    std::function<void(DeviceFacts&)> take;
};

const std::vector<Lack> kLacks{
    {"apiVersion", [](DeviceFacts& f) { f.apiVersionMinor = 2; }},
    {"dynamicRendering", [](DeviceFacts& f) { f.dynamicRendering = false; }},
    {"synchronization2", [](DeviceFacts& f) { f.synchronization2 = false; }},
    {"VK_QUEUE_COMPUTE_BIT", [](DeviceFacts& f) { f.hasGraphicsAndComputeQueue = false; }},
    {"maxStorageBufferRange", [](DeviceFacts& f) { f.maxStorageBufferRange = (1u << 27) - 1; }},
    {"maxBoundDescriptorSets", [](DeviceFacts& f) { f.maxBoundDescriptorSets = 3; }},
    {"maxPushConstantsSize", [](DeviceFacts& f) { f.maxPushConstantsSize = 127; }},
    {"maxColorAttachments", [](DeviceFacts& f) { f.maxColorAttachments = 3; }},
};

TEST(DeviceChoice, EachMissingFeatureIsNamedAndNothingElse) {
    for (const Lack& lack : kLacks) {
        DeviceFacts facts = gpu("Old GPU");
        lack.take(facts);
        const auto missing = missingRequirements(facts);
        ASSERT_EQ(missing.size(), 1u) << lack.field;
        EXPECT_TRUE(says(missing.front(), lack.field)) << missing.front();
        const std::string text = refusal({facts});
        for (const Lack& other : kLacks) EXPECT_EQ(says(text, other.field), &other == &lack) << other.field << ": " << text;
        EXPECT_TRUE(says(text, "Old GPU")) << text;
    }
    EXPECT_TRUE(missingRequirements(gpu("Good")).empty());
}

TEST(DeviceChoice, TimeStampsAreNoCondition) {
    DeviceFacts facts = gpu("Without");
    facts.timestampValidBits = 0;
    EXPECT_EQ(refusal({facts}), "");
    EXPECT_THROW(requireTimestamps(facts), InputError);
    EXPECT_NO_THROW(requireTimestamps(gpu("With")));
}

TEST(DeviceChoice, AllMissingFeaturesAreNamed) {
    DeviceFacts facts = gpu("Ancient");
    for (const Lack& lack : kLacks) lack.take(facts);
    const std::string text = refusal({facts});
    for (const Lack& lack : kLacks) EXPECT_TRUE(says(text, lack.field)) << lack.field << ": " << text;
}

TEST(DeviceChoice, VulkanTwoHasWhatVulkanOneDotThreeHas) {
    DeviceFacts facts = gpu("Future");
    facts.apiVersionMajor = 2;
    facts.apiVersionMinor = 0;
    EXPECT_EQ(refusal({facts}), "");
}

TEST(DeviceChoice, TheFirstThatQualifies) {
    DeviceFacts bad = gpu("Bad");
    bad.synchronization2 = false;
    const std::vector<DeviceFacts> devices{lavapipe("22.3.6"), bad, gpu("Good"), lavapipe("25.0.7")};
    EXPECT_EQ(chooseDevice(devices, ""), 2u);
}

TEST(DeviceChoice, ByNumber) {
    DeviceFacts bad = gpu("Bad 1");
    bad.synchronization2 = false;
    const std::vector<DeviceFacts> devices{gpu("First"), bad, gpu("GeForce 0"), lavapipe("25.0.7")};
    EXPECT_EQ(chooseDevice(devices, "0"), 0u);
    EXPECT_EQ(chooseDevice(devices, "2"), 2u);
    EXPECT_EQ(chooseDevice(devices, "3"), 3u);
    const std::string refused = refusal(devices, "1");
    EXPECT_TRUE(says(refused, "Bad 1 lacks synchronization2")) << refused;  // and no other one is taken in its place
    const std::string unknown = refusal(devices, "4");
    EXPECT_TRUE(says(unknown, "GNOMON_DEVICE=4") && says(unknown, "gnomon device")) << unknown;
    EXPECT_NE(refusal(devices, "99999999999999999999999"), "");
}

TEST(DeviceChoice, ByPartOfTheName) {
    const std::vector<DeviceFacts> devices{gpu("NVIDIA GeForce RTX 3060"), gpu("AMD Radeon"), lavapipe("25.0.7")};
    EXPECT_EQ(chooseDevice(devices, "llvmpipe"), 2u);
    EXPECT_EQ(chooseDevice(devices, "LLVMPIPE"), 2u);
    EXPECT_EQ(chooseDevice(devices, "radeon"), 1u);
    EXPECT_EQ(chooseDevice(devices, "RTX 3060"), 0u);
    const std::string unknown = refusal(devices, "voodoo");
    EXPECT_TRUE(says(unknown, "GNOMON_DEVICE=voodoo") && says(unknown, "gnomon device")) << unknown;
}

TEST(DeviceChoice, TwoOfOneNameTheOneThatQualifies) {
    DeviceFacts old = gpu("Radeon");
    old.dynamicRendering = false;
    EXPECT_EQ(chooseDevice(std::vector{old, gpu("Radeon")}, "radeon"), 1u);
    const std::string both = refusal({old, lavapipe("22.3.6")});
    EXPECT_TRUE(says(both, "Radeon lacks dynamicRendering") && says(both, "llvmpipe")) << both;
}

}  // namespace
}  // namespace gno::host
