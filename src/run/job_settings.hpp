// SPDX-License-Identifier: MIT
// The settings of the run file that a job takes by names of its own, as options of its verb and as
// keywords of its function in Python.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "polhode/io/settings/overlay.hpp"

namespace polhode {

struct JobSetting {
  const char* name;                ///< "hybrid_steps": --hybrid-steps, or the keyword hybrid_steps
  const char* key;                 ///< "hybrid_monte_carlo.steps"
  const char* note = "";           ///< what it means besides its key, after the meaning
  const char* old_name = nullptr;  ///< an option that is accepted, too

  /// Its meaning in a few words: those of the key, and the note.
  std::string meaning() const;
  /// Whether it takes one or more texts.
  bool is_list() const;
};

/// @param job  "run", "study"
std::span<const JobSetting> settings_of_job(std::string_view job);

/// What a job changes in a run file before anything is given: a quick study has fewer and shorter
/// runs, and a preparation a thermostat of its own.
/// @param quick  whether the quick version is requested
Overlay overlay_of_job(std::string_view job, bool quick = false);

}  // namespace polhode
