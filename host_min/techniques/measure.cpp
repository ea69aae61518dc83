// SPDX-License-Identifier: MIT
#include "host_min/techniques/measure.hpp"

#include <algorithm>

#include "host_min/interrupt.hpp"

namespace gno::host {

std::vector<PassTime> medianOf(const std::vector<std::vector<PassTime>>& runs) {
    std::vector<PassTime> result = runs.front();
    for (size_t pass = 0; pass < result.size(); ++pass) {
        std::vector<double> times;
        for (const auto& run : runs) times.push_back(run[pass].ms);
        std::sort(times.begin(), times.end());
        const size_t half = times.size() / 2;
        result[pass].ms = times.size() % 2 ? times[half] : (times[half - 1] + times[half]) / 2;
    }
    return result;
}

std::vector<PassTime> measure(const Device& device, uint32_t repeat, bool warmUp, const std::function<void(Recording&)>& record) {
    const auto once = [&] {
        throwIfInterrupted();
        Recording recording(device);
        record(recording);
        return recording.submit();
    };
    if (warmUp) once();
    std::vector<std::vector<PassTime>> runs;
    for (uint32_t i = 0; i < std::max(repeat, 1u); ++i) runs.push_back(once());
    return medianOf(runs);
}

}  // namespace gno::host
