// SPDX-License-Identifier: MIT
// From the options of a sweep to its groups and variants. Nothing here knows a technique by name.
#pragma once
#include <vector>

#include "validation/study/job.hpp"
#include "validation/study/scenes.hpp"
#include "validation/study/sweep_options.hpp"

namespace gno::study {

/// Every variant once: the defaults of each technique and precision (with --set), then what --vary and --best add. Throws InputError: an unknown
/// technique, precision or key, a value out of its range, nothing left to measure.
std::vector<Variant> variantsOf(const SweepOptions& options);

/// Every group once, scene by scene. Loads each scene. Throws InputError like variantsOf, and for a scene, camera or light that is not there.
std::vector<GroupJobs> expand(const SweepOptions& options, SceneShelf& shelf);

/// The same options for one group alone.
SweepOptions narrowed(const SweepOptions& options, const Group& group);

}  // namespace gno::study
