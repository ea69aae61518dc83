// SPDX-License-Identifier: MIT
#include "validation/hard_cases/hard_case.hpp"

namespace gno::hard {

const std::vector<HardCase>& hardCases() {
    static const std::vector<HardCase> all = [] {
        std::vector<HardCase> list;
        for (const auto& family :
             {lights(), rooms(), slivers(), ties(), interpenetration(), bigAndSmall(), scale(), emptiness(), clusters(), cells()})
            list.insert(list.end(), family.begin(), family.end());
        return list;
    }();
    return all;
}

}  // namespace gno::hard
