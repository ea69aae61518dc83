// SPDX-License-Identifier: MIT
// One technique's limit is not the others': who refuses is left out with a line, and the rest of the run goes on.
#pragma once
#include <exception>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host_min/app/options.hpp"
#include "host_min/output/table.hpp"

namespace gno::host {

/// Of one run of `gnomon shade`. A technique that has refused once is not asked again.
class Refusals {
public:
    enum class Asked { byName, all, automatically };
    /// What is left out is told on standard output, `progress` out of the way.
    Refusals(Asked asked, const DeviceFacts& device, std::span<const std::string> settings, Progress& progress)
        : asked_(asked), device_(device), settings_(settings), progress_(progress) {}

    /// Whether `technique` can be asked for this frame, by what is known before any work. If not, why is told.
    [[nodiscard]] bool holds(const Technique& technique, const FrameLoad& load);

    /// Runs `work` of `technique`. False: it refused (a limit, bad settings, no memory), or the device is lost (gone()); the others' results stand.
    /// Throws Interrupted, and what is no fault of technique or device.
    [[nodiscard]] bool run(const Technique& technique, const std::function<void()>& work);

    /// Nothing more can be asked of the device.
    [[nodiscard]] bool gone() const { return gone_ != nullptr; }
    /// Nothing has gone wrong but limits of techniques that nobody named.
    [[nodiscard]] bool onlyLimits() const { return failures_.empty() && !gone(); }
    [[nodiscard]] const std::set<const Technique*>& refused() const { return refused_; }

    /// At the end, when all results are written: throws what decides the exit code. A limit that one of `all` passed is none, nor is one of `auto`
    /// where another technique took over.
    void finish() const;

private:
    void leaveOut(const Technique& technique, const std::string& why, bool isLimit);

    Asked asked_;
    const DeviceFacts& device_;
    std::span<const std::string> settings_;
    Progress& progress_;
    std::set<const Technique*> refused_;
    std::string failures_;  ///< one line
    std::exception_ptr gone_;
};

}  // namespace gno::host
