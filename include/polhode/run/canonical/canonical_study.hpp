// SPDX-License-Identifier: MIT
// Which scheme samples the canonical ensemble best: the bias of averages against cost for schemes
// with a bath, and for hybrid Monte Carlo, which has none.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Bounds of biases. Strict bounds are about 0.1 % of the energy of liquid water, 1 K and 1 % of
/// the first peak of g(r), chosen before any data. Loose bounds are 0.5 %, 1 % and 2 %, chosen when
/// only the errors of first data were known.
enum class BiasCriterion { strict, loose };

/// "strict" or "loose".
const char* in_words(BiasCriterion criterion);

/// A quantity whose bias is measured.
struct CanonicalQuantity {
  const char* name;  ///< name in files
  const char* label;
  const char* unit;
  double strict, loose;  ///< bounds on the bias, in that unit
  constexpr double bound(BiasCriterion criterion) const {
    return criterion == BiasCriterion::strict ? strict : loose;
  }
};

/// The quantities, in the order of all arrays below.
inline constexpr std::array<CanonicalQuantity, 6> canonical_quantities = {{
    {"potential", "<U> per molecule", "kJ/mol", 0.05, 0.2},
    {"configurational_translation", "T_conf, translation", "K", 1, 3},
    {"configurational_rotation", "T_conf, rotation", "K", 1, 3},
    {"kinetic_translation", "T_kin, translation", "K", 1, 3},
    {"kinetic_rotation", "T_kin, rotation", "K", 1, 3},
    {"g_peak", "first peak of g(r)", "1", 0.03, 0.06},
}};

template <class T>
using ByQuantity = std::array<T, canonical_quantities.size()>;

/// A scheme with a step, to be measured.
struct CanonicalMethod {
  std::string name;     ///< name in tables and figures
  std::string text;     ///< name or stages in records
  Scheme scheme;        ///< has a bath, unless it makes proposals of hybrid Monte Carlo
  bool hybrid = false;  ///< hybrid Monte Carlo
  double step = 0;      ///< [ps]
  double cost() const { return scheme.cost() / step; }  ///< force evaluations per ps
};

/// One run of a method.
struct CanonicalRun {
  std::string scheme;           ///< CanonicalMethod::text
  double step = 0;              ///< [ps]
  int start = 0;                ///< index of the initial configuration
  bool stable = true;           ///< false: it blew up, and the numbers below are meaningless
  ByQuantity<double> means{};   ///< means over the run; not a number for undefined quantities
  double correlation_time = 0;  ///< τ of U, integrated [ps]; not a number if the run is too short
  double acceptance = 1;        ///< acceptance of hybrid Monte Carlo
  double weight = 1;            ///< mean of exp(−ΔH/kT) of hybrid Monte Carlo
};

/// Whether the magnitude of a bias is below a bound: its 95 % interval lies within ± the bound, or
/// outside, or the data do not decide.
enum class Accuracy { below, above, undecided };

/// "below the bound", "above the bound" or "undecided".
const char* in_words(Accuracy accuracy);

/// @param runs  from which the error comes: its interval is from Student's t distribution
Accuracy accuracy_of(const Estimate& bias, double bound, int runs);

/// All runs of a method.
struct CanonicalPoint {
  CanonicalMethod method;
  int runs = 0;
  bool stable = true;                        ///< no run blew up
  ByQuantity<std::optional<Estimate>> mean;  ///< mean over the runs
  ByQuantity<std::optional<Estimate>> bias;  ///< bias, with the error of the reference included
  Estimate correlation_time;                 ///< τ of U [ps]; not a number if unknown
  Estimate acceptance, weight;
  Estimate evaluations_per_sample() const;  ///< 2τ times the cost
  /// Accuracy of a quantity; nothing if its bias is unknown.
  std::optional<Accuracy> accuracy(std::size_t quantity, BiasCriterion criterion) const;
  /// Above if any quantity is above its bound, below if all are below, otherwise undecided.
  Accuracy accuracy(BiasCriterion criterion) const;
};

/// The schemes of a canonical study if the run file names none of its own.
std::vector<NamedScheme> canonical_schemes();

/// The methods that a study measures, by schemes and steps. Schemes without a bath make the
/// proposals of hybrid Monte Carlo; such a method is named "hmc-SCHEME".
/// @throws Error  as check_hybrid(), or if a method occurs twice
std::vector<CanonicalMethod> canonical_methods(const StudySettings& settings);

/// Time at the begin of each run of this length that is not measured, so that averages forget the
/// canonical start [ps].
constexpr double relaxation(double length) { return 0.2 * length; }

/// Performs the runs that are not in `known` yet, from initial configurations that hybrid Monte
/// Carlo draws, and reports each run when it ends. Each run uses one thread, and there are as many
/// in parallel as workers.
void perform_canonical_runs(const Config& config, const std::vector<CanonicalRun>& known,
                            const std::function<void(const CanonicalRun&)>& finished,
                            const Callbacks& callbacks, Workers& workers = Workers::serial());

/// Points from runs. The temperature is the reference of all temperatures. The reference of other
/// quantities is the mean of all runs of hybrid Monte Carlo, which is exact with any step. A point
/// of hybrid Monte Carlo is compared with its other steps.
/// @param temperature  [K]
std::vector<CanonicalPoint> canonical_points(const std::vector<CanonicalMethod>& methods,
                                             const std::vector<CanonicalRun>& runs,
                                             double temperature);

}  // namespace polhode
