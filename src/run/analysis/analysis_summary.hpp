// SPDX-License-Identifier: MIT
// The numbers of an analysis: coefficients, times and peaks derived from its curves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "forces/laws/setting_names.hpp"
#include "measure/dielectric.hpp"
#include "measure/displacement.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/analysis/analysis.hpp"

namespace polhode {

/// Settings of a summary that the frames do not contain.
struct SummarySettings {
  std::optional<FitWindow> fit;       ///< fit window of the diffusion coefficient; by default, lags
                                      ///< from a fifth of the longest lag on
  std::optional<double> temperature;  ///< temperature [K]; by default, the temperature of the
                                      ///< velocities
  /// Temperature of the run file [K], which is used if the frames have no velocities.
  std::optional<double> run_temperature{};
  bool constant_energy = false;  ///< whether the run is at constant energy, so that its
                                 ///< temperature may differ from the setting
  std::optional<double>
      viscosity;  ///< viscosity [u/(nm ps)]; by default, the published value if available
  std::optional<double> surroundings_permittivity;  ///< permittivity of the surroundings:
                                                    ///< `tin_foil`, or the permittivity of the
                                                    ///< reaction field
  std::string no_surroundings;                      ///< reason why there is no permittivity of the
                                                    ///< surroundings

  /// Takes the permittivity of the surroundings from the forces of the run.
  void set_surroundings(const ForceSettings& forces);
  /// Takes the permittivity of the surroundings and the temperature from the run file.
  void set_run(const Config& config);
};

/// Conversion factor of diffusion coefficients from nm²/ps to 10⁻⁹ m²/s.
inline constexpr double in_1e9_m2_per_s = 1000;

/// The results of all observables of an analysis.
struct AnalysisSummary {
  std::optional<double> temperature;  ///< temperature [K]
  std::string temperature_source;     ///< source of the temperature: "as given", "of the
                                      ///< velocities", "of the run file", or ""
  Quantities quantities;              ///< quantities in text and JSON
  std::vector<AnalysisFile> files;    ///< files with curves
  std::vector<std::string> notes;     ///< notes of the analysis, and on missing results
};

AnalysisSummary summary(const Analysis& analysis, const SummarySettings& settings,
                        Workers& workers = Workers::serial());

}  // namespace polhode
