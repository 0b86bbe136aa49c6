// SPDX-License-Identifier: MIT
// The record of a study of energy conservation.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/study/study.hpp"
#include "run/study/run_record.hpp"

namespace polhode {

/// Everything that determines the runs of a study, as text: records of a different study are not
/// reused.
std::string study_identity(const Config& config, const System& system);

/// Records of any version of the program can be read.
using StudyRecord = RunRecord<StudyRun>;

}  // namespace polhode
