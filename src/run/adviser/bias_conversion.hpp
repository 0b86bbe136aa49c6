// SPDX-License-Identifier: MIT
// The time-step bias in the ensemble of a run. The bias in the run's ensemble is converted from the
// bias at constant energy that the adviser's runs predict (docs/theory.md, Eqs. (51) and (52)).
#pragma once

#include <functional>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/adviser/resumable_run.hpp"

namespace polhode {

/// The response of averages to a change of the kinetic energy (that is, of the temperature), at
/// constant volume.
struct IsochoricResponse {
  SeriesEstimate energy;    ///< response of the potential energy to the kinetic energy [1]
  SeriesEstimate pressure;  ///< response of the pressure to the kinetic energy [1/nm³]
};

/// Settings of the runs at constant temperature whose fluctuations give the response.
struct ResponseRuns {
  double step = 0;    ///< time step of hoa2 [ps]
  double length = 0;  ///< length of each run [ps]
};

/// Measures the response by runs with a rescaling thermostat, one run for each initial
/// configuration. Fluctuations are computed about the common means of all runs. The first quarter
/// of each run is discarded.
/// @param stop  function called after every step; the runs end if the function returns true
IsochoricResponse isochoric_response(const std::vector<System>& starts, double temperature,
                                     const ResponseRuns& runs,
                                     const std::function<bool()>& stop = {},
                                     Workers& workers = Workers::serial());

/// Converts a bias at constant energy to the bias in another ensemble.
class BiasConversion {
 public:
  /// @param ensemble  ensemble with a thermostat, for which fixed_means() is known
  BiasConversion(const System& system, const EnsembleSettings& ensemble,
                 const IsochoricResponse& response);

  /// Converts the biases of the potential energy and of the pressure. With a barostat, the pressure
  /// bias is the bias, at constant volume, of the pressure that the barostat controls. The volume
  /// changes in response to this pressure bias.
  void apply(Outcome& run) const;

 private:
  FixedMeans fixed_;
  IsochoricResponse response_;
  double molecules_, volume_, kinetic_;
  double translation_;                         // translational part of the kinetic energy
  double pressure_ = 0, compressibility_ = 0;  // pressure and compressibility of the barostat
};

/// Whether the bias of a quantity, such as the potential energy, differs between constant energy
/// and the ensemble. The bias of the temperature difference is the same at constant energy and in
/// other ensembles.
bool needs_conversion(Quality quality, const EnsembleSettings& ensemble);

/// Measures the response to the temperature, in runs from given initial configurations, for the
/// conversion to the ensemble of a run file. The measured response is reported as a note.
BiasConversion bias_conversion(const Config& config, const std::vector<ResumableRun>& starts,
                               const ResponseRuns& runs, const Callbacks& callbacks,
                               const std::function<bool()>& stop, Workers& workers);

}  // namespace polhode
