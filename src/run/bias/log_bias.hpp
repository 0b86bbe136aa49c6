// SPDX-License-Identifier: MIT
// The time-step bias of averages from the energies that any program printed at constant energy
// (docs/theory.md, Eqs. (47) and (51)).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/slope.hpp"
#include "polhode/run/quantities.hpp"
#include "run/bias/engine_log.hpp"
#include "run/given.hpp"

namespace polhode {

/// The options that a front end received for the bias of a log, as texts.
struct BiasRequest {
  Given total, potential, temperature, energy_unit, start, stop;

  static std::vector<RequestOption<BiasRequest>> options();
};

/// A column of the log with its mean and time-step bias.
struct ColumnBias {
  std::string name, unit;
  SeriesEstimate mean;       ///< mean of the log
  SeriesEstimate bias;       ///< time-step bias of the mean at constant energy
  SeriesEstimate corrected;  ///< mean without the bias
};

/// The time-step bias of all averages of a log.
struct LogBias {
  std::string format, energy_unit;
  std::string energy;     ///< column of the energy that exact dynamics conserves
  bool has_bath = false;  ///< whether the run had a thermostat
  std::size_t samples = 0;
  double temperature = 0;  ///< temperature of kT [K], or in units of the well depth
  double R = 0;  ///< fluctuation of the total energy over the fluctuation of the potential energy
  double resolution = 0;       ///< smallest difference between printed total energies
  SeriesEstimate fluctuation;  ///< standard deviation of the total energy about its linear fit
  Drift drift;                 ///< drift of the total energy per time, or per sample without times
  std::vector<ColumnBias> columns;
  /// Time-step bias of the potential energy at constant temperature, with a slow rescaling or
  /// Nosé-Hoover thermostat, Eq. (51); empty without potential energies.
  std::optional<SeriesEstimate> at_constant_temperature;
  std::vector<std::string> notes, warnings;
};

/// Computes the time-step bias of all averages of a log.
/// @throws Error  if the total energy or the temperature is missing, if the energy was not
///   constant, or if the energies have too few digits
LogBias log_bias(const EngineLog& log, const BiasRequest& request);

Quantities quantities(const LogBias& bias);

}  // namespace polhode
