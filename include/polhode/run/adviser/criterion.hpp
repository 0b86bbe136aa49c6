// SPDX-License-Identifier: MIT
// The user's requirement for a run, as a number with a bound: the energy fluctuation ratio R, the
// energy drift, or the bias of an average.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/enum_names.hpp"
#include "polhode/io/settings/requirement.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// Results of one test run with a scheme and step.
struct Outcome {
  std::string failure;        ///< reason why the run blew up; empty if it did not
  double ratio = 0;           ///< energy fluctuation ratio R
  double drift = 0;           ///< drift of the total energy per molecule [kJ/mol/ps]
  Temperatures temperatures;  ///< mean temperatures over the run
  /// Configurational temperatures over the run [K]; 0 for motions without forces, and empty if they
  /// were not requested.
  std::optional<ByMotion<double>> configurational{};
  /// Relative temperature bias T_k/T − 1 of translation and of rotation about each principal axis;
  /// 0 without such motion.
  std::array<double, 4> bias{};
  double temperature_difference = 0;  ///< predicted time-step bias of T_rot − T_trans [K]
  double translation_bias = 0;        ///< time-step bias of the kinetic energy of translation
                                      ///< [kJ/mol]
  double energy_bias = 0;             ///< time-step bias of the potential energy per molecule
                                      ///< [kJ/mol]
  double pressure_bias = 0;           ///< time-step bias of the pressure [kJ/mol/nm³]
  /// Standard errors common to all runs. These errors come from the conversion of the biases of
  /// energy and pressure to the ensemble of the run file.
  double energy_bias_error = 0, pressure_bias_error = 0;
  double rounding = 0;  ///< estimate of R if round-off were the only error; 0 in double precision
};

Outcome outcome(const System& system, const Trajectory& trajectory);

enum class Quality {
  ratio,             ///< energy fluctuation ratio R of a run [1]
  drift,             ///< |drift| of the total energy per molecule [kJ/mol/ps]
  temperature_bias,  ///< largest |T_k/T − 1| of translation and of rotation about each axis [1]
  temperature_difference,  ///< magnitude of the bias of T_rot − T_trans [K]
  energy_bias,             ///< |bias| of the potential energy per molecule [kJ/mol]
  pressure_bias            ///< |bias| of the pressure [kJ/mol/nm³]
};

template <>
inline constexpr std::array<std::string_view, 6> enum_names<Quality> = {
    "R",           "energy drift", "temperature bias", "bias of the temperature difference",
    "energy bias", "pressure bias"};

struct Criterion {
  Quality quality = Quality::ratio;
  double bound = 0;
};

/// @throws Error  if a density is bounded and the barostat has no compressibility, or if a bias is
///   bounded in an ensemble in which the bias is not known
Criterion criterion_of(const Requirement& requirement, const EnsembleSettings& ensemble);

/// @throws Error  if a difference between temperatures of rotation and translation is bounded, but
///   no molecule rotates
void check_criterion(const Criterion& criterion, const Topology& topology);

/// Probability with which each new run is to meet the requirement. The aim is that 95 of 100 new
/// runs meet the requirement. If each run meets the requirement with a probability of 0.975, fewer
/// than 95 of 100 runs do so in only 5 % of cases.
inline constexpr double guarantee_probability = 0.975;

/// The value that the bounded number (R, drift or bias) exceeds only with probability 1 −
/// guarantee_probability. For R, the result is a bound for a new run. A single run is too noisy to
/// show an energy drift or a bias. For a drift or bias, the bound applies to the mean over
/// infinitely many runs. For the largest of several biases, the error probability is divided
/// equally among the biases. The standard error that all runs have in common is doubled and added
/// in quadrature. The bound is infinite if a run blew up.
double upper_bound(Quality quality, const std::vector<Outcome>& runs);

/// The upper bound of the quality that a criterion bounds. The prediction of a bias requires a
/// small R: with the bound on R that causes a warning, the result is at least the bound of the
/// criterion.
double upper_bound(const Criterion& criterion, const std::vector<Outcome>& runs);

/// The smallest upper_bound() of R that the full-length runs can still have, given the R of their
/// first part. R grows with the length of a run. The scatter of R decreases at most as the square
/// root of the length, as for independent parts.
/// @param part  first part as a fraction of the length, above 0 and at most 1
double optimistic_bound(const std::vector<Outcome>& runs, double part);

/// Whether full-length runs can still meet the bound, given the results of their first part. The
/// result is true for an energy drift or a bias, which a part of a run does not determine.
bool may_meet(const Criterion& criterion, const std::vector<Outcome>& runs, double part);

/// Whether the energies of the runs drift with a p-value below `significance_level`, as in a study.
bool drifts(const std::vector<Outcome>& runs, double significance_level = significance);
/// Whether a run blew up.
bool blew_up(const std::vector<Outcome>& runs);

/// Runs of the same scheme and step, one run for each initial configuration.
struct AdviserPoint {
  double step = 0;    ///< [ps]
  double length = 0;  ///< length of each run [ps]
  std::vector<Outcome> runs;
  double bound = 0;     ///< upper_bound() of the runs
  bool usable = false;  ///< no run blew up, and the energies do not drift

  Estimate ratio() const;  ///< R, mean over the runs
  Estimate drift() const;  ///< energy drift per molecule, mean over the runs [kJ/mol/ps]
  /// T_k/T − 1 of translation (0) or of rotation about an axis (1 to 3), mean over the runs; error
  /// 0 without such motion.
  Estimate bias(std::size_t kind) const;
  double max_rounding() const;  ///< largest round-off limit of R, estimated
};

/// A number from each run, such as R.
/// @param member  member of Outcome, or function of a run
template <class Member>
std::vector<double> each(const std::vector<Outcome>& runs, const Member& member) {
  std::vector<double> values;
  for (const Outcome& run : runs) values.push_back(std::invoke(member, run));
  return values;
}

}  // namespace polhode
