// SPDX-License-Identifier: MIT
// The study of the paper: accuracy against cost for each scheme over a range of steps, from
// independent runs [vanzon2008, Fig. 1].
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

/// Largest interval between energies [ps]: several per 10 fs, as fast librations would alias
/// otherwise.
inline constexpr double max_sample_interval = 0.0025;

/// One run: a scheme with a step from one of the initial configurations.
struct StudyRun {
  std::string scheme;      ///< name as in StudyPoint::record_name()
  double step = 0;         ///< [ps]
  int start = 0;           ///< index of the initial configuration; the same ones are used for every
                           ///< scheme
  bool stable = true;      ///< false: it blew up, and the numbers below are meaningless
  double ratio = 0;        ///< R
  double drift = 0;        ///< [kJ/mol/ps]
  double total = 0;        ///< rms fluctuation of the total energy [kJ/mol]
  double potential = 0;    ///< rms fluctuation of the potential energy [kJ/mol]
  double temperature = 0;  ///< mean over the run [K]
  double rounding = 0;     ///< R due to rounding alone, estimated; 0 in double precision
  /// Means over the run for each kind of motion; empty in old records without them.
  std::optional<Temperatures> parts;
  double near_weight = 0;  ///< time of the near forces relative to all forces; 0 without an inner
                           ///< scheme
  /// Configurational temperatures over the run [K], 0 for motions without forces; empty if they
  /// were not requested.
  std::optional<ByMotion<double>> configurational{};
};

/// An energy drift matters if it changes the energy during a run by at least this many rms
/// fluctuations of the energy. In units of the rms fluctuation of the potential energy this is
/// R.
inline constexpr double drift_bound = 1;

/// A point of the figure: all runs of a scheme with one step.
struct EfficiencyPoint {
  std::string scheme;
  int order = 0;      ///< order of the scheme; 0 if unknown
  double step = 0;    ///< [ps]
  double length = 0;  ///< length of each run [ps]
  /// Force evaluations per ps; with an inner scheme, evaluations of all forces plus evaluations of
  /// near forces times their weight.
  double cost = 0;
  double near_weight = 0;  ///< mean of StudyRun::near_weight
  int runs = 0;
  bool stable = true;      ///< no run blew up
  Estimate ratio;          ///< R with its standard error over the runs
  double total = 0;        ///< rms fluctuation of the total energy, mean over the runs [kJ/mol]
  Drift drift;             ///< energy drift over the series of runs, as defined in the paper
  double temperature = 0;  ///< [K]
  double rounding = 0;     ///< R due to rounding alone, mean; 0 in double precision
  /// T of rotation about each principal axis minus T of translation, over the runs that have them
  /// [K]; empty without such degrees of freedom.
  std::array<std::optional<Estimate>, 3> excess;
  /// Configurational minus kinetic temperature of each kind of motion, as for `excess` [K].
  ByMotion<std::optional<Estimate>> configurational_excess;
  /// Change of the energy by its drift during a run, in rms fluctuations of the energy.
  double relative_drift() const;
  /// Upper end of the 95 % interval of relative_drift(); infinite with fewer than two runs.
  double relative_drift_bound() const;
  /// The energy drift is significant, and it matters.
  bool drifts() const;
  /// The drift does not matter, whether it is significant or not, with 95 % confidence.
  bool conserves() const { return stable && relative_drift_bound() < drift_bound; }
  /// R is dominated by rounding.
  bool at_rounding() const { return stable && ratio.value < rounding_margin * rounding; }
};

/// The (scheme, step) pairs that a study measures.
struct StudyPoint {
  std::string name;  ///< name of the scheme in tables and figures, see label_of()
  NestedScheme scheme;
  double step;  ///< [ps]
  /// The scheme in a record of runs: its name, with its stages if the name is user-given. Runs of
  /// other stages with the same name are therefore not mistaken for its runs.
  std::string record_name() const;
  /// Force evaluations per ps.
  /// @param near_weight  cost of a near-force evaluation relative to a full one
  double cost(double near_weight) const;
};
std::vector<StudyPoint> study_points(const StudySettings& settings);

/// Seed of the random numbers of one initial configuration in a series, and of the runs from it:
/// the run file's seed + 1 + index.
std::uint64_t start_seed(const Config& config, std::size_t index);

/// One initial configuration of a series: the system with its own momenta, drawn with its
/// start_seed() and equilibrated for `length` [ps]. Not usable if `stop` interrupted it.
System prepare_start(const System& base, const Config& config, std::size_t index, double length,
                     const std::function<bool()>& stop);

/// Performs the runs that are not in `known` yet, as many in parallel as there are workers, and
/// reports each run when it ends. Each run uses one thread.
void perform_study_runs(const Config& config, const std::vector<StudyRun>& known,
                        const std::function<void(const StudyRun&)>& finished,
                        const Callbacks& callbacks, Workers& workers = Workers::serial());

/// Points from runs, in the order of schemes and steps.
/// @param length  of each run [ps]
std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs, double length);

}  // namespace polhode
