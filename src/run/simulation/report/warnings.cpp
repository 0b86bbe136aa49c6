// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "forces/pairs/cutoff_treatment.hpp"
#include "integrate/stability.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/report/truncation_walk.hpp"
#include "run/simulation/report/warning_rules.hpp"
#include "run/simulation/system/stable_step.hpp"

namespace polhode {
namespace {

/// Bounds below which a deviation is harmless even if it is significant. Each bound is relative to
/// the quantity that its comment names.
constexpr double min_temperature_difference = 0.01;  // relative to the requested temperature
constexpr double min_ignored_difference = 0.02;      // relative to the requested temperature, if
                                                     // this temperature had no effect on the run
constexpr double min_drift_share = 0.5;              // relative to R
constexpr double min_drift_ratio = 0.001;            // relative to the fluctuation of the potential
                                                     // energy
constexpr double min_truncation_share = 1.0 / 3;     // relative to R: its square contributes 10 %
constexpr double min_truncation_ratio = 0.001;       // relative to the fluctuation of the potential
                                                     // energy
constexpr double min_walk_share = 0.5;               // relative to R²
constexpr double min_walk_ratio = 0.005;             // relative to the fluctuation of the potential
                                                     // energy
constexpr double min_fall = 0.02;                    // relative to the kinetic energy
constexpr double max_pressure_kbar = 5;

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

std::string temperature_remedy(const TargetTemperature& target) {
  if (target.kept)
    return "equilibrate longer, or use a stronger thermostat (larger friction or shorter "
           "time_constant); if the deviation remains, use a shorter step";
  if (target.ignored)
    return "the velocities of the initial configuration were used: write velocities = \"new\" in "
           "[system], and equilibrate";
  return "equilibrate longer: equilibrate = \"20 ps\" in [run]";
}

/// The standard deviation of the mean temperature of runs at constant energy, with momenta drawn or
/// rescaled at a temperature T [K]. The standard deviation of the mean temperature is at most
/// T/√(2n) for n degrees of freedom.
///
/// At the start, the kinetic energy is the mean at T, and the potential energy has the canonical
/// variance k_B T² C. All degrees of freedom share the deviation of the potential energy, so the
/// temperature has the variance T² C k_B/(C + n k_B/2)². The variance is largest for C = n k_B/2,
/// the value of harmonic oscillators.
double temperature_scatter(double temperature, double degrees_of_freedom) {
  return temperature / std::sqrt(2 * degrees_of_freedom);
}

std::optional<Warning> temperature_warning(const RunSummary& s, const TargetTemperature& target) {
  const double n = s.degrees_of_freedom.all();
  if (n == 0 || s.samples == 0) return std::nullopt;
  // If the error is not known, the fluctuation of the temperature is used instead.
  const double T = target.value;
  const SeriesEstimate mean = s.temperatures_at_bath.value_or(s.temperatures).all;
  const double error = mean.known == Known::yes ? three_sigma(mean) : far * T * std::sqrt(2 / n);
  // The scatter due to the initial momenta counts only if they were drawn at temperature T and no
  // thermostat changes them.
  const double scatter = target.ignored || target.kept ? 0 : temperature_scatter(T, n);
  const double bound =
      std::max((target.ignored ? min_ignored_difference : min_temperature_difference) * T,
               std::hypot(far * scatter, error));
  const double difference = mean.value - T;
  if (!(std::abs(difference) > bound)) return std::nullopt;
  return Warning{
      "temperature", mean.value, bound,
      fmt::format("the mean temperature {}is {:.4g} K instead of {:g} K: {:.3g} K {}, {} {:.2g} K",
                  s.temperatures_at_bath ? "of half steps " : "", mean.value, T,
                  std::abs(difference), difference > 0 ? "too hot" : "too cold",
                  target.ignored || target.kept
                      ? "more than the bound of"
                      : "but runs of a system of this size deviate by at most",
                  bound),
      temperature_remedy(target)};
}

std::string conserved_energy(const RunSummary& s) {
  return s.ensemble.settings.constant_energy() ? "the total energy" : "the conserved energy";
}

/// Whether the conserved energy gives no information about the bias of averages. Hybrid Monte Carlo
/// corrects the bias by rejections. With a bath within the steps, averages over positions are much
/// more accurate than averages over momenta [leimkuhler2013].
bool is_corrected(const RunSummary& s) {
  return s.ensemble.hybrid_monte_carlo || s.temperatures_at_bath;
}

/// The ratio R without the contribution of the random walk. With a thermostat, the random walk is
/// not included. The random walk grows with the length of the run, but causes no bias, because the
/// thermostat absorbs the energy.
double stationary_ratio(const RunSummary& s) {
  if (s.ensemble.settings.constant_energy()) return s.ratio.value;
  return std::sqrt(std::max(0.0, std::pow(s.ratio.value, 2) - std::pow(s.ratio_of_walk(), 2)));
}

std::optional<Warning> ratio_warning(const RunSummary& s) {
  const double R = stationary_ratio(s);
  if (s.samples < min_samples_reported || is_corrected(s) || !(R > max_ratio)) return std::nullopt;
  return Warning{
      "R", R, max_ratio,
      fmt::format(
          "R is {:.3g} % (bound: {:g} %): {} is conserved so poorly that averages are biased",
          100 * R, 100 * max_ratio, conserved_energy(s)),
      "use a shorter step, or write accuracy = \"1 %\" in [integrator], which chooses the step"};
}

/// The R that the energy drift would give without other fluctuations. The rms deviation of a
/// straight line from its mean is the total rise divided by √12.
double ratio_of_drift(const RunSummary& s) { return s.relative_drift() / std::sqrt(12.0); }

double bound_of_drift(const RunSummary& s) {
  return std::max(min_drift_share * s.ratio.value, min_drift_ratio);
}

std::optional<Warning> drift_warning(const RunSummary& s) {
  if (s.drift.known != Known::yes || is_corrected(s) || s.drift.p_value > significance_level ||
      !(s.potential_fluctuation.value > 0))
    return std::nullopt;
  const double drifted = ratio_of_drift(s), bound = bound_of_drift(s);
  if (!(drifted > bound)) return std::nullopt;
  return Warning{
      "drift", drifted, bound,
      fmt::format("{} drifts by {:.3g} ± {:.2g} kJ/mol/ps, which contributes {:.2g} % to R (bound: "
                  "{:.2g} %)",
                  conserved_energy(s), s.drift.rate.value, s.drift.rate.error, 100 * drifted,
                  100 * bound),
      "use a shorter step, a smoother cutoff (smoothness in [forces]), or double precision"};
}

bool is_shifted(const ForceSettings& forces) {
  return cutoff_treatment(forces) == CutoffTreatment::site_shift;
}

std::string truncation_remedy(const ForceSettings& forces) {
  const bool of_charges = !vanishes_at_cutoff(forces.electrostatics) &&
                          forces.truncation != Truncation::molecule_switch;
  return fmt::format("use {}{}a {} or a shorter step",
                     of_charges ? "truncation = \"molecule-switch\" or electrostatics = \"pme\" in "
                                  "[forces], "
                                : "",
                     !is_shifted(forces) && forces.smoothness < 3 ? "smoothness = 3, " : "",
                     is_shifted(forces) ? "longer cutoff" : "longer switching range");
}

/// A warning about the random walk that truncation causes.
/// @param ratio  R of the random walk
/// @param bound  bound that R exceeds
Warning truncation_warning(const ForceSettings& forces, const std::string& scheme, double ratio,
                           double bound) {
  const int n = is_shifted(forces) ? 1 : forces.smoothness;
  return {"truncation", ratio, bound,
          fmt::format("the truncated potential has only {} continuous derivative{}; with {} the "
                      "energy therefore performs a random walk, and R grows with the run length, "
                      "here to about {:.2g} % (bound: {:.2g} %)",
                      n, n == 1 ? "" : "s", scheme, 100 * ratio, 100 * bound),
          truncation_remedy(forces)};
}

double truncation_bound(const RunSummary& s) {
  return std::max(min_truncation_share * s.ratio.value, min_truncation_ratio);
}

/// A warning about a random walk of the energy. The warning is given only at constant energy,
/// because a thermostat absorbs the energy. The warning is not given if truncation explains the
/// random walk, because truncation has a separate warning.
std::optional<Warning> walk_warning(const RunSummary& s) {
  const double walked = s.ratio_of_walk();
  const double bound = std::max(std::sqrt(min_walk_share) * s.ratio.value, min_walk_ratio);
  if (!s.ensemble.settings.constant_energy() || s.samples < min_samples_reported ||
      s.truncation > truncation_bound(s) || !(walked > bound))
    return std::nullopt;
  return Warning{
      "walk", walked, bound,
      fmt::format(
          "the total energy performs a random walk of {:.2g} kJ/mol per sqrt(ps); the contribution "
          "to R, {:.2g} % in this run (bound: {:.2g} %), grows with the run length",
          std::sqrt(s.walk), 100 * walked, 100 * bound),
      "use a shorter step, electrostatics = \"pme\" or a larger smoothness in [forces], or a "
      "thermostat"};
}

std::optional<Warning> relaxation_warning(const RunSummary& s) {
  const Drift& slope = s.potential_drift;
  const double fall = -slope.rate.value * s.length;
  const double kinetic =
      s.degrees_of_freedom.all() * units::boltzmann * s.temperatures.all.value / 2;
  if (slope.known != Known::yes || slope.p_value > significance_level ||
      !(fall > min_fall * kinetic))
    return std::nullopt;
  return Warning{
      "relaxation", fall, min_fall * kinetic,
      fmt::format(
          "the potential energy still falls by {:.3g} kJ/mol in this run, {:.2g} % of the kinetic "
          "energy (bound: {:g} %; p-value {:.2g}), so averages are not at equilibrium",
          fall, 100 * fall / kinetic, 100 * min_fall, slope.p_value),
      "equilibrate longer, or start a new run from the final state of this run"};
}

std::optional<Warning> pressure_warning(const RunSummary& s) {
  const double pressure = in_bar(s.pressure.value) / 1000,
               bound = max_pressure_kbar;  // pressure and its bound [kbar]
  const double error = s.pressure.known == Known::yes ? in_bar(three_sigma(s.pressure)) / 1000 : 0;
  if (s.samples < min_samples_reported || s.ensemble.barostat ||
      !(std::abs(pressure) - error > bound))
    return std::nullopt;
  return Warning{
      "pressure", pressure, bound,
      fmt::format("the mean pressure is {:.3g} kbar, outside ± {:g} kbar: {}", pressure, bound,
                  pressure > 0 ? "at this pressure an ordinary liquid is compressed by about 17 %"
                               : "liquids cavitate long before this pressure"),
      pressure > 0 ? "use a lower density, or equilibrate if molecules still overlap"
                   : "use a higher density"};
}

bool is_plain(Electrostatics electrostatics) {
  return electrostatics == Electrostatics::coulomb ||
         electrostatics == Electrostatics::reaction_field;
}

}  // namespace

std::string line_of(const Warning& warning) {
  return fmt::format("warning: {}; {}", warning.text, warning.remedy);
}

void append(std::vector<Warning>& all, std::initializer_list<std::optional<Warning>> more) {
  for (const std::optional<Warning>& warning : more)
    if (warning) all.push_back(*warning);
}

bool drift_matters(const RunSummary& s) { return ratio_of_drift(s) > bound_of_drift(s); }

std::optional<Warning> cutoff_of_ions(const System& system) {
  if (!is_plain(system.forces.electrostatics)) return std::nullopt;
  const Molecule* ion = nullptr;
  // Largest net charge due to rounding [e]. For a neutral molecule of 200 sites, charges with four
  // decimals add up to at most 0.01 e. Two charges of 0.01 e that are 1 nm apart have an energy of
  // 0.014 kJ/mol, 0.6 % of kT at 300 K.
  constexpr double neutral = 0.01;
  for (const auto& part : system.topology.parts)
    if (part.count > 0 && std::abs(part.molecule.charge()) > neutral &&
        (!ion || std::abs(part.molecule.charge()) > std::abs(ion->charge())))
      ion = &part.molecule;
  if (!ion || system.topology.size() < 2) return std::nullopt;
  return Warning{
      "ions", ion->charge(), neutral,
      fmt::format("'{}' has a charge of {:+.3g} e, and {} between ions are truncated at {:g} nm, "
                  "where they are still strong: ions gather at that distance",
                  ion->name, ion->charge(),
                  system.forces.electrostatics == Electrostatics::coulomb
                      ? "Coulomb forces"
                      : "the forces of a reaction field",
                  system.forces.cutoff),
      "write electrostatics = \"pme\" in [forces]"};
}

std::optional<Warning> rough_truncation(const System& system, const TrajectorySettings& settings) {
  const double n = degrees_of_freedom(system.topology).all();
  if (settings.ensemble.hybrid_monte_carlo || system.temperature == 0 || n == 0)
    return std::nullopt;
  const double walk =
      walk_fluctuation(truncation_walk(system.topology, system.forces, system.state.box.volume(),
                                       system.temperature, settings.scheme, settings.step),
                       settings.length);
  const double ratio = walk / (units::boltzmann * system.temperature * std::sqrt(n / 2));
  if (!(ratio > min_truncation_ratio)) return std::nullopt;
  return truncation_warning(system.forces, name_of({settings.scheme, settings.inner}), ratio,
                            min_truncation_ratio);
}

std::optional<Warning> distant_sites(const System& system) {
  // Largest plausible bond length [nm]. The bound is above the longest actual bonds, 0.47 nm in
  // coarse-grained chains. If ångström are mistaken for nm, even the shortest bond (0.74 Å in H2)
  // exceeds the bound.
  constexpr double max_bond = 0.6;
  for (const auto& part : system.topology.parts) {
    std::vector<Site> atoms;
    for (const Site& site : part.molecule.sites)
      if (site.mass > 0) atoms.push_back(site);
    if (atoms.size() < 2) continue;
    for (std::size_t k = 0; k < atoms.size(); ++k) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < atoms.size(); ++other)
        if (other != k) nearest = std::min(nearest, norm(atoms[other].r - atoms[k].r));
      if (nearest > max_bond)
        return Warning{"bond", nearest, max_bond,
                       fmt::format("in '{}' the site '{}' is {:.3g} nm from the nearest other site "
                                   "with mass, but bonds are at most {:g} nm long",
                                   part.molecule.name, atoms[k].name, nearest, max_bond),
                       "if the positions are in angstrom, write A instead of nm"};
    }
  }
  return std::nullopt;
}

std::optional<Warning> velocities_of_file(const System& system, const Config& config) {
  const double n = degrees_of_freedom(system.topology).all();
  if (system.new_velocities || !config.gives("system.temperature") || config.run.equilibrate > 0 ||
      !config.ensemble.constant_energy() || n == 0)
    return std::nullopt;
  constexpr double far_from_canonical = 4;
  const double target = config.system.temperature;
  const double bound = far_from_canonical * target * std::sqrt(2 / n);
  if (!(std::abs(system.file_temperature - target) > bound)) return std::nullopt;
  return Warning{
      "velocities", system.file_temperature, bound,
      fmt::format(
          "the velocities of the initial configuration correspond to {:.4g} K, "
          "but the run file requests {:g} K (chance explains a difference of at most {:.2g} K)",
          system.file_temperature, target, bound),
      "write velocities = \"new\" in [system], or equilibrate"};
}

std::optional<Warning> step_near_stability(const System& system, const TrajectorySettings& settings,
                                           Workers& workers) {
  if (system.temperature == 0)
    return std::nullopt;  // the Einstein frequency is meaningful only in a liquid
  const double max_step = max_stable_step(system, system.state, settings, workers);
  if (!(settings.step > max_step)) return std::nullopt;
  const double bound = near_stability * stability_limit(settings.scheme);
  const double reached = bound * settings.step / max_step;
  return Warning{"step", reached, bound,
                 fmt::format("the step of {:g} fs is near the stability limit of {}: the step "
                             "times the frequency of the fastest motions is {:.2g} (bound: {:.2g})",
                             settings.step * units::fs_per_ps,
                             name_of({settings.scheme, settings.inner}), reached, bound),
                 "use at most " + rounded_fs(max_step)};
}

std::vector<Warning> warnings_of_results(const RunSummary& s,
                                         const std::optional<TargetTemperature>& target) {
  std::vector<Warning> all;
  append(all, {target ? temperature_warning(s, *target) : std::nullopt, ratio_warning(s),
               drift_warning(s), walk_warning(s), relaxation_warning(s), pressure_warning(s)});
  for (const Warning& warning : ensemble_warnings(s)) all.push_back(warning);
  return all;
}

std::vector<Warning> warnings(const RunSummary& s, const System& system,
                              const TrajectorySettings& settings, const Config& config,
                              Workers& workers) {
  // Velocities from a file may have any temperature, unless the run file gives a temperature.
  const bool of_file = !system.new_velocities && config.run.equilibrate == 0;
  std::optional<TargetTemperature> target;
  if (config.system.temperature == 0)
    target.reset();  // a thermostat cools the system
  else if (!settings.ensemble.constant_energy())
    target = {.value = config.system.temperature, .kept = true};
  else if (!of_file || config.gives("system.temperature"))
    target = {.value = config.system.temperature, .ignored = of_file};
  std::vector<Warning> all = warnings_of_results(s, target);
  const double bound = truncation_bound(s);
  if (!is_corrected(s) && s.truncation > bound)
    all.push_back(truncation_warning(system.forces, name_of({settings.scheme, settings.inner}),
                                     s.truncation, bound));
  append(all, {step_near_stability(system, settings, workers), cutoff_of_ions(system),
               distant_sites(system)});
  return all;
}

}  // namespace polhode
