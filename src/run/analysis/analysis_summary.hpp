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

/// What the frames do not contain.
struct SummarySettings {
  std::optional<FitWindow> fit;       ///< of the diffusion coefficient; default: from a fifth of
                                      ///< the lags on
  std::optional<double> temperature;  ///< [K]; default: that of the velocities
  /// Of the run file [K], where the frames have no velocities.
  std::optional<double> run_temperature{};
  bool constant_energy = false;     ///< of the run, whose temperature may then be another
  std::optional<double> viscosity;  ///< [u/(nm ps)]; default: the published one, if there is one
  std::optional<double> surroundings_permittivity;  ///< permittivity of the surroundings:
                                                    ///< `tin_foil`, or that of the reaction field
  std::string no_surroundings;                      ///< why there is none

  /// Takes the permittivity of the surroundings from the forces of the run.
  void set_surroundings(const ForceSettings& forces);
  /// Takes from the run file the permittivity of the surroundings, and the temperature.
  void set_run(const Config& config);
};

/// Factor of diffusion coefficients in nm²/ps to those in 10⁻⁹ m²/s.
inline constexpr double in_1e9_m2_per_s = 1000;

/// The results of all observables.
struct AnalysisSummary {
  std::optional<double> temperature;  ///< [K]
  std::string temperature_source;     ///< "as given", "of the velocities", "of the run file"; or ""
  Quantities quantities;              ///< in text and JSON
  std::vector<AnalysisFile> files;    ///< curves
  std::vector<std::string> notes;     ///< those of the analysis, and what could not be computed
};

AnalysisSummary summary(const Analysis& analysis, const SummarySettings& settings,
                        Workers& workers = Workers::serial());

}  // namespace polhode
