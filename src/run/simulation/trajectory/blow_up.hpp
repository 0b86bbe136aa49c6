// SPDX-License-Identifier: MIT
// What ends a trajectory whose energies or forces are no longer meaningful.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "polhode/base/error.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// Ends the trajectory but keeps its results.
struct BlowUp : RunError {
  BlowUp(const std::string& what, std::string why) : RunError(what), cause(std::move(why)) {}
  std::string cause;
};

/// Knows the positions that a report of a blow-up needs: at the start, for a step that would have
/// been short enough, and before the last step, for the molecules that collided.
class BlowUpReport {
 public:
  /// All are kept by reference.
  BlowUpReport(const System& system, const TrajectorySettings& settings, Workers& workers);

  /// To be called before each step.
  void before_step();

  /// @param step   that failed
  /// @param cause  why
  /// @throws BlowUp  with the molecules that collided, and the remedy
  [[noreturn]] void blow_up(std::size_t step, std::string cause) const;

  /// The same for an energy or a force that is not finite, with a note if a law has an inner limit.
  [[noreturn]] void not_finite(std::size_t step, const std::string& cause) const;

 private:
  const System& system_;
  const TrajectorySettings& settings_;
  Workers& workers_;
  State first_, before_;
};

}  // namespace polhode
