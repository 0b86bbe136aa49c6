// SPDX-License-Identifier: MIT
// The record of a study of energy conservation.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/study/study.hpp"
#include "run/study/run_record.hpp"

namespace polhode {

/// A text with everything that determines the runs of a study, so that records of a different study
/// are not used.
std::string study_identity(const Config& config, const System& system);

/// The record of a study; records of any version of the program can be read.
using StudyRecord = RunRecord<StudyRun>;

}  // namespace polhode
