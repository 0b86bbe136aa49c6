// SPDX-License-Identifier: MIT
// Compares how well schemes sample the canonical ensemble: the bias of averages against cost, for
// schemes with a bath and for hybrid Monte Carlo. Hybrid Monte Carlo has no bias.
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

/// The two levels of bounds on biases. Strict bounds are about 0.1 % of the energy of liquid water,
/// 1 K, and 1 % of the first peak of g(r). Strict bounds were chosen before any data existed. Loose
/// bounds are about 0.5 % of the energy of liquid water, 3 K, and 2 % of the first peak of g(r).
/// Loose bounds were chosen when only the errors of the first data were known.
enum class BiasCriterion { strict, loose };

/// A quantity whose bias is measured in a canonical study.
struct CanonicalQuantity {
  const char* name;  ///< name of the quantity in files
  const char* label;
  const char* unit;
  double strict, loose;  ///< bounds on the bias, in the unit of the quantity
  constexpr double bound(BiasCriterion criterion) const {
    return criterion == BiasCriterion::strict ? strict : loose;
  }
};

/// The quantities of a canonical study, in the order of all arrays indexed by quantity.
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

/// A method of a canonical study: a scheme with a time step.
struct CanonicalMethod {
  std::string name;  ///< name in tables and figures
  std::string text;  ///< name or stages of the scheme in records
  Scheme scheme;  ///< scheme with a bath, or a scheme without a bath for proposals of hybrid Monte
                  ///< Carlo
  bool hybrid = false;  ///< whether hybrid Monte Carlo uses the scheme to propose trajectories
  double step = 0;      ///< time step [ps]
  double cost() const { return scheme.cost() / step; }  ///< force evaluations per ps
};

/// One run of a method in a canonical study.
struct CanonicalRun {
  std::string scheme;           ///< text of the method: CanonicalMethod::text
  double step = 0;              ///< time step [ps]
  int start = 0;                ///< index of the initial configuration
  bool stable = true;           ///< whether the run was stable; if false it blew up, and the
                                ///< numbers below are meaningless
  ByQuantity<double> means{};   ///< means over the run; NaN for undefined quantities
  double correlation_time = 0;  ///< integrated autocorrelation time of the potential energy [ps];
                                ///< NaN if the run is too short
  double acceptance = 1;        ///< acceptance rate of hybrid Monte Carlo
  double weight = 1;            ///< mean weight exp(−ΔH/kT) of hybrid Monte Carlo
};

/// The comparison of a bias with a bound. The bias is below the bound if its 95 % interval lies
/// between −bound and +bound, and above the bound if the interval lies outside this range. In all
/// other cases, the comparison is undecided.
enum class Accuracy { below, above, undecided };

/// Compares a bias with a bound.
/// @param runs  number of runs from which the error was computed, which determines the degrees of
///   freedom of Student's t distribution
Accuracy accuracy_of(const Estimate& bias, double bound, int runs);

/// The results of all runs of a method.
struct CanonicalPoint {
  CanonicalMethod method;
  int runs = 0;
  bool stable = true;                        ///< whether no run blew up
  ByQuantity<std::optional<Estimate>> mean;  ///< mean of each quantity over the runs
  ByQuantity<std::optional<Estimate>> bias;  ///< bias of each quantity; the error of a bias
                                             ///< includes the error of the reference
  Estimate correlation_time;                 ///< integrated autocorrelation time of the potential
                                             ///< energy [ps]; NaN if unknown
  Estimate acceptance, weight;
  Estimate evaluations_per_sample() const;  ///< Force evaluations per independent sample: twice the
                                            ///< autocorrelation time [ps], times the force
                                            ///< evaluations per ps.
  /// The accuracy of a quantity; empty if its bias is unknown.
  std::optional<Accuracy> accuracy(std::size_t quantity, BiasCriterion criterion) const;
  /// The accuracy of the method: above if any bias is above its bound, below if all biases are
  /// below their bounds, and otherwise undecided.
  Accuracy accuracy(BiasCriterion criterion) const;
};

/// The default schemes of a canonical study, used if the run file names none.
std::vector<NamedScheme> canonical_schemes();

/// The methods that a study measures: each scheme at each step. Schemes without a bath make the
/// proposals of hybrid Monte Carlo; such a method is named "hmc-SCHEME".
/// @throws Error  under the same conditions as check_hybrid(), or if a method occurs twice
std::vector<CanonicalMethod> canonical_methods(const StudySettings& settings);

/// The length [ps] of the initial part of a run that averages exclude, because the initial
/// configuration still affects this part. `length` is the length of the run.
constexpr double relaxation(double length) { return 0.2 * length; }

/// Performs the runs that are not in `known` yet, and reports each run when it ends. The initial
/// configurations are drawn by hybrid Monte Carlo. Each run uses one thread, and each worker
/// performs one run at a time.
void perform_canonical_runs(const Config& config, const std::vector<CanonicalRun>& known,
                            const std::function<void(const CanonicalRun&)>& finished,
                            const Callbacks& callbacks, Workers& workers = Workers::serial());

/// Computes the points of a study from its runs. The reference of all temperatures is the given
/// temperature. The reference of other quantities is the mean over all hybrid Monte Carlo runs,
/// because hybrid Monte Carlo is exact at any step. A point of hybrid Monte Carlo is compared with
/// the runs at other steps.
/// @param temperature  temperature of the ensemble [K]
std::vector<CanonicalPoint> canonical_points(const std::vector<CanonicalMethod>& methods,
                                             const std::vector<CanonicalRun>& runs,
                                             double temperature);

}  // namespace polhode
