// SPDX-License-Identifier: MIT
// Run-file settings that are also command-line options and Python keywords of a job.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "polhode/io/settings/overlay.hpp"

namespace polhode {

struct JobSetting {
  const char* name;                ///< name such as "hybrid_steps", for the option --hybrid-steps
                                   ///< and the keyword hybrid_steps
  const char* key;                 ///< key of the setting, such as "hybrid_monte_carlo.steps"
  const char* note = "";           ///< text that is appended to the meaning of the key
  const char* old_name = nullptr;  ///< older name of the option, which is also accepted

  /// The meaning of the setting in a few words: the meaning of its key, and the note.
  std::string meaning() const;
  /// Whether the value of the setting is a list of texts.
  bool is_list() const;
};

/// The settings of a job.
/// @param job  name of the job, such as "run" or "study"
std::span<const JobSetting> settings_of_job(std::string_view job);

/// Settings that a job overrides in the run file by default. For example, a quick study overrides
/// the number and length of runs, and a preparation overrides the thermostat.
/// @param quick  whether the quick version is requested
Overlay overlay_of_job(std::string_view job, bool quick = false);

}  // namespace polhode
