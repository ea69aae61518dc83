// SPDX-License-Identifier: MIT
// main() of every device test: driver, version and subgroup width on line one; a message of the validation layer fails the program.
#include <gtest/gtest.h>

#include <cstdio>

#include "host_min/vulkan/device.hpp"
#include "validation/support/device_test.hpp"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const gno::host::Device& device = gno::test::passes().device();
    const gno::host::DeviceFacts& facts = device.facts();
    std::printf("%s, %s %s, subgroup width %u\n", facts.deviceName.c_str(), facts.driverName.c_str(), facts.driverInfo.c_str(), facts.subgroupSize);
    const int status = RUN_ALL_TESTS();
    const auto messages = device.validationMessages();
    if (messages > 0) std::printf("FAILED: %llu messages of the validation layer\n", static_cast<unsigned long long>(messages));
    return status != 0 || messages > 0 ? 1 : 0;
}
