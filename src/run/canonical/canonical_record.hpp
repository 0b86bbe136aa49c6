// SPDX-License-Identifier: MIT
// The record of a canonical study.
#pragma once

#include <string>

#include "polhode/run/canonical/canonical_study.hpp"
#include "run/study/run_record.hpp"

namespace polhode {

/// A text with everything that determines the runs of a canonical study, so that records of a
/// different study are not used.
std::string canonical_identity(const Config& config, const System& system);

using CanonicalRecord = RunRecord<CanonicalRun>;

}  // namespace polhode
