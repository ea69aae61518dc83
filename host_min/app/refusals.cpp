// SPDX-License-Identifier: MIT
#include "host_min/app/refusals.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "host_min/error.hpp"
#include "host_min/vulkan/faults.hpp"

namespace gno::host {
namespace {

std::string named(const Technique& technique, const std::string& why) {
    const std::string start = fmt::format("technique {}: ", technique.info().name);
    return why.starts_with(start) ? why : start + why;
}

}  // namespace

bool Refusals::holds(const Technique& technique, const FrameLoad& load) {
    if (refused_.contains(&technique)) return false;
    const std::string why = technique.overLimit(device_, load, Settings(technique.info().settings, settings_));
    if (!why.empty()) leaveOut(technique, why, true);
    return why.empty();
}

bool Refusals::run(const Technique& technique, const std::function<void()>& work) {
    const auto goneBy = [&](auto error) { gone_ = std::make_exception_ptr(std::move(error)); };
    try {
        withVulkanFaults(work);
        return true;
    } catch (const Interrupted&) {
        throw;
    } catch (const LimitError& error) {
        leaveOut(technique, error.what(), true);
    } catch (const InputError& error) {
        leaveOut(technique, error.what(), false);
    } catch (const RoomError& error) {
        leaveOut(technique, error.what(), false);
    } catch (const std::bad_alloc&) {
        leaveOut(technique, "out of memory: use a smaller --size or scene", false);
    } catch (const DeviceLost& error) {
        goneBy(DeviceLost(named(technique, error.what())));
    } catch (const WorkError& error) {
        goneBy(WorkError(named(technique, error.what())));
    }
    return false;
}

void Refusals::leaveOut(const Technique& technique, const std::string& why, bool isLimit) {
    refused_.insert(&technique);
    if (isLimit && asked_ != Asked::byName) {
        progress_.clear();
        fmt::print("left out {}: {}\n", technique.info().name, why);
        return;
    }
    failures_ += (failures_.empty() ? "" : "; ") + named(technique, why);
}

void Refusals::finish() const {
    if (gone_ != nullptr) std::rethrow_exception(gone_);
    if (!failures_.empty()) throw InputError(failures_);
}

}  // namespace gno::host
