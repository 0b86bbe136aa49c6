// SPDX-License-Identifier: MIT
// The paper's study: accuracy against cost for each scheme over a ladder of steps, from independent
// runs (vanzon2008, Fig. 1).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/io/config.hpp"
#include "polhode/measure/configurational_temperature.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/run/rounding.hpp"
#include "polhode/run/system.hpp"

namespace polhode {

/// Between energies [ps]: several times per 10 fs, as the fast librations alias otherwise.
inline constexpr double longest_sample = 0.0025;

/// One run: a scheme with a step from one of the starts.
struct StudyRun {
  std::string scheme;
  double step = 0;         ///< [ps]
  int start = 0;           ///< which of the starts; the same ones serve every scheme
  bool stable = true;      ///< false: it blew up, and the numbers below are void
  double ratio = 0;        ///< R
  double drift = 0;        ///< [kJ/mol/ps]
  double total = 0;        ///< rms fluctuation of the total energy [kJ/mol]
  double potential = 0;    ///< rms fluctuation of the potential energy [kJ/mol]
  double temperature = 0;  ///< mean over the run [K]
  double rounding = 0;     ///< R of rounding alone, estimated; 0 in double precision
  /// Means over the run of kinds of motion; nothing in records that do not know them.
  std::optional<Temperatures> parts;
  double near_weight = 0;  ///< time of near forces over all forces; 0 without an inner scheme
  /// Configurational temperatures over the run [K], 0 for motions without forces; nothing where
  /// they were not asked for.
  std::optional<ByMotion<double>> configurational{};
};

/// A point of the figure: all runs of a scheme with one step.
struct EfficiencyPoint {
  std::string scheme;
  double step = 0;  ///< [ps]
  /// Force evaluations per ps; with an inner scheme those of all forces, and those of the near ones
  /// by their weight.
  double cost = 0;
  double near_weight = 0;  ///< time of near forces over all forces, mean; 0 without an inner scheme
  int runs = 0;
  bool stable = true;      ///< no run blew up
  Estimate ratio;          ///< R with its standard error over the runs
  Drift drift;             ///< of the series, as the paper has it
  double temperature = 0;  ///< [K]
  double rounding = 0;     ///< R of rounding alone, mean; 0 in double precision
  /// T of rotation about each principal axis less that of translation, over the runs that know
  /// them [K]; nothing without such freedoms.
  std::array<std::optional<Estimate>, 3> excess;
  /// Configurational temperature of each motion less its kinetic one, likewise [K].
  ByMotion<std::optional<Estimate>> configurational_excess;
  /// No run blew up, and the drift is not significant.
  bool usable() const { return stable && drift.chance >= significance; }
  /// R is no longer that of the scheme.
  bool at_rounding() const { return stable && ratio.value < rounding_margin * rounding; }
};

/// The (scheme, step) pairs that a study measures.
struct StudyPoint {
  std::string name;  ///< of the scheme, or its text, as the run file has it
  NestedScheme scheme;
  double step;  ///< [ps]
  /// Force evaluations per ps.
  /// @param near_weight  what one of the near forces counts
  double cost(double near_weight) const;
};
std::vector<StudyPoint> study_points(const StudySettings& settings);

struct StudyProgress {
  std::function<void(double done, const std::string& what)> report;  ///< fraction of the work
  std::function<bool()> stop;
};

/// Of what is random in one of a series of starts, and in runs from it: the run file's seed + 1 +
/// index.
std::uint64_t start_seed(const Config& config, std::size_t index);

/// One of a series of starts: the system with momenta of its own, drawn from its start_seed(),
/// equilibrated for `length` [ps]. Void where `stop` ended it.
System decorrelated_start(const System& base, const Config& config, std::size_t index,
                          double length, const std::function<bool()>& stop);

/// Runs what is not in `known` yet, as many runs at once as there are workers, and reports each run
/// as it ends. A run is one thread's.
void run_study(const Config& config, const std::vector<StudyRun>& known,
               const std::function<void(const StudyRun&)>& finished, const StudyProgress& progress,
               Workers& workers = Workers::serial());

/// Points from runs, in the order of schemes and steps.
std::vector<EfficiencyPoint> efficiency_points(const std::vector<StudyPoint>& points,
                                               const std::vector<StudyRun>& runs);

}  // namespace polhode
