// SPDX-License-Identifier: MIT
// One group on the device: its inputs, the exact answers, and how any variant does on them.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "host_min/app/result.hpp"
#include "validation/study/distance.hpp"
#include "validation/study/job.hpp"

namespace gno::study {

/// Told now and then what is being done, and how many runs of a variant begin with it (0 or 1); may throw to stop the work.
using Report = std::function<void(const std::string&, uint32_t)>;

class Subject {
public:
    /// `withSums`: some variant answers for casters that are not opaque. Throws InputError or MemoryError: too large for the device.
    Subject(host::PassCache& passes, const host::SceneFile& file, const Group& group, bool withSums, const Report& report);

    [[nodiscard]] const host::SceneFile& file() const { return file_; }
    [[nodiscard]] const host::FrameInputs& inputs() const { return inputs_; }
    [[nodiscard]] const host::Light& light() const { return frame_.lights[group_.light]; }
    [[nodiscard]] const host::OracleAnswer& answer() const { return answer_; }

    /// One run without warm-up on a structure of its own. `bestValue`: of the setting that is searched, if any.
    [[nodiscard]] host::TechniqueResult run(const Variant& variant, const std::string& bestValue, bool counters) const;
    /// Bare full-screen pass, and the caster pass that all structures begin with, once more each; ms.
    double repeatFloor();

    [[nodiscard]] host::RecordCheck compare(const host::TechniqueResult& result, std::vector<uint32_t>* wrongPixels) const;
    [[nodiscard]] DistanceHistogram distances(const host::TechniqueResult& result, const std::vector<uint32_t>& wrongPixels);

private:
    const host::SceneFile& file_;
    const Group group_;
    host::Frame frame_;
    host::FrameInputs inputs_;
    host::OracleAnswer answer_;
    std::vector<host::OracleSample> samples_;
    std::optional<std::vector<int64_t>> opaqueDistances_, sumDistances_;  ///< made when somebody is wrong
};

}  // namespace gno::study
