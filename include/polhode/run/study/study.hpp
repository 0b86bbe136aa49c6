// SPDX-License-Identifier: MIT
// The study of the paper, which compares the accuracy and cost of schemes over a range of time
// steps, from independent runs [vanzon2008, Fig. 1].
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/measure/configurational_temperature.hpp"
#include "polhode/measure/slope.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The largest allowed interval between energy samples [ps]. Several samples per 10 fs are needed,
/// because fast librations would otherwise be aliased.
inline constexpr double max_sample_interval = 0.0025;

/// One run of a study, with one scheme and time step, starting from one of the initial
/// configurations.
struct StudyRun {
  std::string scheme;    ///< name of the scheme as in StudyPoint::record_name()
  double step = 0;       ///< time step [ps]
  int start = 0;         ///< index of the initial configuration; every scheme uses the same
                         ///< configurations
  bool stable = true;    ///< whether the run was stable; if false, the run blew up, and the numbers
                         ///< below are meaningless
  double ratio = 0;      ///< energy fluctuation ratio R
  double drift = 0;      ///< drift of the total energy [kJ/mol/ps]
  double total = 0;      ///< rms fluctuation of the total energy [kJ/mol]
  double potential = 0;  ///< rms fluctuation of the potential energy [kJ/mol]
  double temperature = 0;  ///< mean temperature over the run [K]
  double rounding = 0;     ///< R due to round-off only, estimated; 0 in double precision
  /// Mean temperatures of each kind of motion; empty for old records without these temperatures.
  std::optional<Temperatures> parts;
  double near_weight = 0;  ///< time of a near-force evaluation, relative to an evaluation of all
                           ///< forces; 0 without an inner scheme
  /// Configurational temperatures over the run [K], 0 for motions without forces; empty if they
  /// were not requested.
  std::optional<ByMotion<double>> configurational{};
};

/// The bound above which an energy drift matters, in units of the rms fluctuation of the total
/// energy. The energy change that the drift causes during a run is compared with this bound. In
/// units of the rms fluctuation of the potential energy, the bound is R.
inline constexpr double drift_bound = 1;

/// A point of the efficiency figure: all runs with the same scheme and step.
struct EfficiencyPoint {
  std::string scheme;
  int order = 0;      ///< order of the scheme; 0 if unknown
  double step = 0;    ///< time step [ps]
  double length = 0;  ///< length of each run [ps]
  /// Force evaluations per ps; with an inner scheme, evaluations of all forces plus evaluations of
  /// near forces times their weight.
  double cost = 0;
  double near_weight = 0;  ///< mean of StudyRun::near_weight
  int runs = 0;
  bool stable = true;      ///< whether no run blew up
  Estimate ratio;          ///< mean R with its standard error over the runs
  double total = 0;        ///< rms fluctuation of the total energy, mean over the runs [kJ/mol]
  Drift drift;             ///< energy drift over the series of runs, as defined in the paper
  double temperature = 0;  ///< mean temperature [K]
  double rounding = 0;     ///< mean R due to round-off only; 0 in double precision
  /// Temperature of rotation about each principal axis minus temperature of translation, over the
  /// runs with both temperatures [K]; empty without such degrees of freedom.
  std::array<std::optional<Estimate>, 3> excess;
  /// Configurational minus kinetic temperature of each kind of motion, over the runs with both
  /// temperatures [K].
  ByMotion<std::optional<Estimate>> configurational_excess;
  /// The energy change that the drift causes during a run, in units of the rms fluctuation of the
  /// total energy.
  double relative_drift() const;
  /// The upper end of the 95 % interval of relative_drift(); infinite with fewer than two runs.
  double relative_drift_bound() const;
  /// Whether the energy drift is significant and above `drift_bound`.
  bool drifts() const;
  /// Whether the runs are stable, and their energy drift, even if significant, is below
  /// `drift_bound` with 95 % confidence.
  bool conserves() const { return stable && relative_drift_bound() < drift_bound; }
  /// Whether round-off dominates R.
  bool at_rounding() const { return stable && ratio.value < rounding_margin * rounding; }
};

/// A pair of scheme and step that a study measures.
struct StudyPoint {
  std::string name;  ///< name of the scheme in tables and figures; see label_of()
  NestedScheme scheme;
  double step;  ///< time step [ps]
  /// The name of the scheme in records of runs. In records, a user-given name is followed by the
  /// stages of the scheme. Different schemes with the same name can thus be distinguished in the
  /// records.
  std::string record_name() const;
  /// Force evaluations per ps.
  /// @param near_weight  cost of a near-force evaluation relative to a full force evaluation
  double cost(double near_weight) const;
};
std::vector<StudyPoint> study_points(const StudySettings& settings);

/// The random seed for an initial configuration of a series, and for the runs from this
/// configuration. This seed is the sum of the seed in the run file, 1, and the index of the
/// configuration.
std::uint64_t start_seed(const Config& config, std::size_t index);

/// Prepares an initial configuration of a series: draws momenta with start_seed() and equilibrates
/// for `length` [ps]. The configuration is not usable if `stop` interrupted the equilibration.
System prepare_start(const System& base, const Config& config, std::size_t index, double length,
                     const std::function<bool()>& stop);

/// Performs the runs that are not in `known` yet, and reports each run when it ends. Each run uses
/// one thread, and each worker performs one run at a time.
void perform_study_runs(const Config& config, const std::vector<StudyRun>& known,
                        const std::function<void(const StudyRun&)>& finished,
                        const Callbacks& callbacks, Workers& workers = Workers::serial());

/// Computes the points of a study from its runs, in the order of schemes and steps.
/// @param length  length of each run [ps]
std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs, double length);

}  // namespace polhode
