// SPDX-License-Identifier: MIT
// Ends a trajectory whose energies or forces are no longer meaningful.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "polhode/base/error.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// An error that ends the trajectory but keeps the results up to this point.
struct BlowUp : RunError {
  BlowUp(const std::string& what, std::string why) : RunError(what), cause(std::move(why)) {}
  std::string cause;
};

/// Stores the positions that a report of a blow-up needs. From the initial positions, the report
/// computes a step that would have been short enough to avoid the blow-up. The positions before the
/// last step show the molecules that collided.
class BlowUpReport {
 public:
  /// Constructs the report; all arguments are kept by reference.
  BlowUpReport(const System& system, const TrajectorySettings& settings, Workers& workers);

  /// Stores the positions; must be called before each step.
  void before_step();

  /// Ends the trajectory with a report.
  /// @param step   number of the step that failed
  /// @param cause  cause of the failure
  /// @throws BlowUp  with the molecules that collided, and the remedy
  [[noreturn]] void blow_up(std::size_t step, std::string cause) const;

  /// Ends the trajectory because an energy or a force is not finite. The report has a note if a
  /// potential is not defined below a smallest distance (inner limit).
  [[noreturn]] void not_finite(std::size_t step, const std::string& cause) const;

 private:
  const System& system_;
  const TrajectorySettings& settings_;
  Workers& workers_;
  State first_, before_;
};

}  // namespace polhode
