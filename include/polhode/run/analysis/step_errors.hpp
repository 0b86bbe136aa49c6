// SPDX-License-Identifier: MIT
// The time-step error at the frames of a trajectory, from the energies file of the run.
#pragma once

#include <optional>
#include <string>

#include "polhode/io/settings/config.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"
#include "polhode/run/simulation/files/energy_file.hpp"

namespace polhode {

/// The energies file that contains the time-step errors, and the settings that are needed to read
/// them.
struct StepErrorSettings {
  std::string energies;  ///< path of the energies file
  FixedMeans fixed = FixedMeans::energy;
  double temperature = 0;  ///< temperature of the thermostat [K]
};

/// Reads the settings for the energies file of a run.
/// @throws Error  with the reason, if the time-step bias is not known in the ensemble of the run
StepErrorSettings step_error_settings(const std::string& energies, const Config& config);

/// Finds the time-step errors of frames in an energies file. The time-step error of a frame is in
/// the row with the same time. Each row is read only once, when a frame with its time is reached.
class StepErrors {
 public:
  /// @throws Error  if the file cannot be read, or is not an energies file
  StepErrors(const StepErrorSettings& settings, const Topology& topology);

  /// The time-step error of a frame; empty if the row of the frame does not contain it. Frames must
  /// be passed in the order of time.
  /// @param has_velocities  whether the frame has a kinetic energy that can be compared with the
  ///   row
  /// @throws Error  unless exactly one row has the time of the frame, within the round-off of times
  ///   in files. Also throws if the frame and the row differ in volume, kinetic energy or ensemble
  std::optional<StepError> at(const State& frame, bool has_velocities);

 private:
  void check(const EnergyRow& row, const State& frame, bool has_velocities) const;

  StepErrorSettings settings_;
  Bodies bodies_;
  EnergyReader rows_;
  std::optional<EnergyRow> row_, next_;
};

}  // namespace polhode
