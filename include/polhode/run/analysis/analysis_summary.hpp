// SPDX-License-Identifier: MIT
// The numbers of an analysis: coefficients, times and peaks derived from its curves.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/forces/laws/setting_names.hpp"
#include "polhode/io/config.hpp"
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

struct AxisRelaxation {
  std::string axis;
  std::array<std::optional<RelaxationTimes>, 2> rank;  ///< P1, P2; empty if C has not decayed
};

/// Dynamics of the bodies of one part of the topology.
struct PartSummary {
  std::string molecule;
  std::size_t count = 0;
  std::optional<SeriesEstimate> diffusion;  ///< from displacements, in this box [nm²/ps]
  Convergence diffusion_convergence;
  std::optional<SeriesEstimate> green_kubo;  ///< from velocities, integrated over all lags [nm²/ps]
  Convergence green_kubo_convergence;
  std::vector<AxisRelaxation> axes;

  /// D in an infinite box; empty where it or its correction is unknown.
  std::optional<SeriesEstimate> corrected(const struct AnalysisSummary& summary) const;
};

struct AnalysisSummary {
  std::optional<double> temperature;  ///< [K]
  std::string temperature_source;     ///< "as given", "of the velocities", "of the run file"; or ""
  FitWindow fit;                      ///< of the diffusion coefficient [ps]
  std::optional<double> viscosity;    ///< [u/(nm ps)]
  std::string viscosity_source;       ///< "as given", or the publication; else why there is none
  std::optional<double> finite_size_correction;  ///< Yeh-Hummer finite-size correction, to be added
                                                 ///< to diffusion [nm²/ps]
  std::vector<PartSummary> parts;
  std::vector<std::optional<RadialDistribution::Peak>> peaks;  ///< one per pair; none: no peak
  std::optional<TotalDipole::Result> dielectric;
  /// What the step changes in these, if its error is known at the frames.
  std::vector<std::optional<RadialDistribution::Peak>> peaks_bias;
  std::optional<TotalDipole::StepBias> dielectric_bias;
  std::vector<std::string> notes;  ///< those of the analysis, and what could not be computed
};

/// The relaxation time of a number in a text, and whether it is that of the window of lags.
struct RelaxationName {
  const char* text;
  bool window = false;
};
inline constexpr RelaxationName max_lag{"maximum lag", true}, decay_time{"decay to 1/e³ within"},
    dipole_relaxation{"relaxation"};

/// Why a number is not a result, and what to do: "not converged: length 20 ps, relaxation 5.6 ps;
/// a run of at least 170 ps is needed".
std::string not_converged(const Convergence& c, const RelaxationName& relaxation);
/// The same for a relaxation time whose function has not decayed within the window of lags.
inline constexpr const char* not_decayed =
    "not converged: the function does not fall to 1/e³ within the window of lags; use a longer "
    "window, and a run of at least eight windows";

AnalysisSummary summary(Analysis& analysis, const SummarySettings& settings,
                        Workers& workers = Workers::serial());

}  // namespace polhode
