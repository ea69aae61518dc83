// SPDX-License-Identifier: MIT
#include "host_min/techniques/technique.hpp"

#include <fmt/format.h>

#include "host_min/error.hpp"
#include "host_min/techniques/query_pass.hpp"

namespace gno::host {

std::string Technique::overLimit(const DeviceFacts&, const FrameLoad&, const Settings&) const { return {}; }

TechniqueResult Technique::run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) const {
    const std::string missing = missingFor(info(), inputs.device().facts());
    if (!missing.empty()) throw InputError(fmt::format("technique {}: the device lacks {}", info().name, missing));
    const Structure& structure =
        structures.get<Structure>(fmt::format("{} {}", structureKey(inputs, settings, options), name(options.precision)), inputs,
                                  {options.repeat, options.warmUp, options.counters}, [&] { return makeStructure(inputs, settings, options); });
    TechniqueResult result;
    result.passes = structure.passes();
    result.hostWaits = structure.waits();
    result.reruns = structure.reruns();
    ask(inputs, query(structure, inputs, settings, options), options, result);
    read(structure, inputs, settings, options, result);
    return result;
}

}  // namespace gno::host
