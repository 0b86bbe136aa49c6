// SPDX-License-Identifier: MIT
// The record of a canonical study.
#pragma once

#include <string>

#include "polhode/run/canonical/canonical_study.hpp"
#include "run/study/run_record.hpp"

namespace polhode {

/// Everything that determines the runs of a canonical study, as text: records of a different study
/// are not reused.
std::string canonical_identity(const Config& config, const System& system);

using CanonicalRecord = RunRecord<CanonicalRun>;

}  // namespace polhode
