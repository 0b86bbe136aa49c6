// SPDX-License-Identifier: MIT
// The bias of a step in the ensemble of a run, from the bias at constant energy that the adviser's
// runs predict (docs/theory.md, Eqs. (51) and (52)).
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

/// How averages at constant volume change with the kinetic energy, that is with the temperature.
struct IsochoricResponse {
  SeriesEstimate energy;    ///< of the potential energy [1]
  SeriesEstimate pressure;  ///< of the pressure [1/nm³]
};

/// Measured from the fluctuations of runs at constant temperature.
struct ResponseRuns {
  double step = 0;    ///< of hoa2 [ps]
  double length = 0;  ///< of each run [ps]
};

/// From runs with a rescaling thermostat, one from each initial configuration, about their common
/// means; the first quarter of each is not counted.
/// @param stop  ends the runs when it returns true; asked after every step
IsochoricResponse isochoric_response(const std::vector<System>& starts, double temperature,
                                     const ResponseRuns& runs,
                                     const std::function<bool()>& stop = {},
                                     Workers& workers = Workers::serial());

/// Turns the bias at constant energy into that of an ensemble.
class BiasConversion {
 public:
  /// @param ensemble  for which fixed_means() is known, with a thermostat
  BiasConversion(const System& system, const EnsembleSettings& ensemble,
                 const IsochoricResponse& response);

  /// Replaces the biases of the potential energy and of the pressure. With a barostat the pressure
  /// is the one that it holds, at constant volume: the bias that the volume takes up.
  void apply(Outcome& run) const;

 private:
  FixedMeans fixed_;
  IsochoricResponse response_;
  double molecules_, volume_, kinetic_;
  double translation_;                         // part of the kinetic energy
  double pressure_ = 0, compressibility_ = 0;  // of the barostat
};

/// Whether a bias of this quality at constant energy is another one in the ensemble: the difference
/// of temperatures is the same.
bool needs_conversion(Quality quality, const EnsembleSettings& ensemble);

/// For the ensemble of a run file, from runs that begin with these initial configurations; a note
/// gives the response.
BiasConversion bias_conversion(const Config& config, const std::vector<ResumableRun>& starts,
                               const ResponseRuns& runs, const Callbacks& callbacks,
                               const std::function<bool()>& stop, Workers& workers);

}  // namespace polhode
