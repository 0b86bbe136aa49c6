// SPDX-License-Identifier: MIT
// The error of the step at the frames of a trajectory, from the energies file of its run.
#pragma once

#include <optional>
#include <string>

#include "polhode/io/settings/config.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"
#include "polhode/run/simulation/files/energy_file.hpp"

namespace polhode {

/// The file with the time-step errors of a run.
struct StepErrorSettings {
  std::string energies;  ///< file of the run
  FixedMeans fixed = FixedMeans::energy;
  double temperature = 0;  ///< temperature of the thermostat [K]
};

/// Settings for the energies file of a run.
/// @throws Error  with the reason, if the bias of the step is not known in the ensemble of the run
StepErrorSettings step_error_settings(const std::string& energies, const Config& config);

/// Finds the time-step errors of frames. Each frame has the time of a row of the energies; rows are
/// read once, along with the frames.
class StepErrors {
 public:
  /// @throws Error  if the file cannot be read, or is no energies file
  StepErrors(const StepErrorSettings& settings, const Topology& topology);

  /// The time-step error at the sample that a frame belongs to; empty if it is not known there.
  /// Call it for frames in the order of time.
  /// @param has_velocities  whether the kinetic energy of the frame can be compared as well
  /// @throws Error  if not exactly one row has the time of the frame, within the rounding of
  ///                times in files. Also if volume, kinetic energy or ensemble differ from the
  ///                row
  std::optional<StepError> at(const State& frame, bool has_velocities);

 private:
  void check(const EnergyRow& row, const State& frame, bool has_velocities) const;

  StepErrorSettings settings_;
  Bodies bodies_;
  EnergyReader rows_;
  std::optional<EnergyRow> row_, next_;
};

}  // namespace polhode
