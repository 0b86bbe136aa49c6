// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/analysis_summary.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "polhode/io/output_units.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode {
namespace {

struct PublishedViscosity {
  std::string_view model;
  std::string_view value;
};

// At 298 K and 1 bar, gonzalez2010.
constexpr PublishedViscosity published[] = {
    {"tip3p", "0.321 mPa s"}, {"tip4p", "0.494 mPa s"},      {"tip5p", "0.699 mPa s"},
    {"spce", "0.729 mPa s"},  {"tip4p-2005", "0.855 mPa s"},
};
constexpr double published_temperature = 298;  // [K]
constexpr double near = 5;                     // [K]: the viscosity of water changes by 2 % in 1 K

constexpr const char* of_run_file = "of the run file";

void find_temperature(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  const double kinetic = a.conditions->temperature().value;
  const auto take = [&](double temperature, const char* source) {
    s.temperature = temperature;
    s.temperature_source = source;
  };
  if (settings.temperature)
    take(*settings.temperature, "as given");
  else if (kinetic > 0)
    take(kinetic, "of the velocities");
  else if (settings.run_temperature)
    take(*settings.run_temperature, of_run_file);
  if (s.temperature_source == of_run_file && settings.constant_energy)
    s.notes.push_back(
        fmt::format("the frames have no velocities, so the temperature is {:g} K, of the run file; "
                    "a run at constant energy may have another, which its summary states: give "
                    "that temperature",
                    *s.temperature));
}

void find_viscosity(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  if (settings.viscosity) {
    s.viscosity = settings.viscosity;
    s.viscosity_source = "as given";
    return;
  }
  s.viscosity_source =
      "there is no published viscosity for these molecules; give it as 'viscosity', \"0.9 mPa s\"";
  if (a.topology.parts.size() != 1) return;
  for (const PublishedViscosity& known : published) {
    if (a.topology.parts.front().molecule.name != known.model) continue;
    if (!s.temperature || std::abs(*s.temperature - published_temperature) > near) {
      s.viscosity_source = fmt::format(
          "the published viscosity of {}, {}, is for {:g} K and 1 bar, gonzalez2010; give that at "
          "{} as 'viscosity'",
          known.model, known.value, published_temperature,
          s.temperature ? fmt::format("{:.4g} K", *s.temperature) : "the temperature");
      return;
    }
    s.viscosity = quantity(known.value, Dimension::viscosity, "viscosity");
    s.viscosity_source =
        fmt::format("of {} at {:g} K and 1 bar, gonzalez2010", known.model, published_temperature);
  }
}

bool cubic(const Box& box) {
  const Vec3<double> e = box.edge;
  return std::max({e.x, e.y, e.z}) <= box.shortest_edge() * (1 + 1e-4);
}

std::optional<SeriesEstimate> diffusion_of(Analysis& a, std::size_t part, AnalysisSummary& s,
                                           const SummarySettings& settings, Workers& workers) {
  if (!a.displacement || a.topology.parts[part].count == 0) return std::nullopt;
  const BlockMeans squared = a.displacement->mean_square(part, workers);
  const double max_lag = static_cast<double>(squared.mean().size() - 1) * a.interval;
  s.fit = settings.fit.value_or(FitWindow{max_lag / 5, max_lag});
  const SeriesEstimate D = diffusion(squared, a.interval, s.fit);
  if (!std::isnan(D.value)) return D;
  if (part == 0)
    s.notes.push_back(
        fmt::format("no diffusion coefficient: fewer than two lags between {:g} and {:g} ps; the "
                    "maximum is {:g} ps",
                    s.fit.from, s.fit.to, max_lag));
  return std::nullopt;
}

std::vector<AxisRelaxation> relaxations_of(Analysis& a, std::size_t part, Workers& workers) {
  std::vector<AxisRelaxation> axes;
  if (!a.reorientation || a.topology.parts[part].count == 0) return axes;
  for (std::size_t axis = 0; axis < a.reorientation->axes(part).size(); ++axis) {
    AxisRelaxation r{a.reorientation->axes(part)[axis].name, {}};
    for (const int rank : {1, 2})
      r.rank[static_cast<std::size_t>(rank - 1)] =
          relaxation_times(a.reorientation->legendre(part, axis, rank, workers), a.interval);
    axes.push_back(std::move(r));
  }
  return axes;
}

PartSummary part_summary(Analysis& a, std::size_t part, AnalysisSummary& s,
                         const SummarySettings& settings, Workers& workers) {
  const auto& [molecule, count] = a.topology.parts[part];
  PartSummary p;
  p.molecule = molecule.name;
  p.count = count;
  p.diffusion = diffusion_of(a, part, s, settings, workers);
  if (p.diffusion)
    p.diffusion_convergence =
        diffusion_convergence(a.displacement->mean_square(part, workers), a.interval, s.fit);
  if (a.velocity && count > 0 && a.topology.size() > 1) {
    const BlockMeans C = a.velocity->linear(part, workers);
    p.green_kubo = series_estimates(running_integral(C, a.interval)).back();
    p.green_kubo_convergence = integral_convergence(C, a.interval);
  }
  p.axes = relaxations_of(a, part, workers);
  return p;
}

void find_correction(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  find_viscosity(s, a, settings);
  if (!cubic(a.box))
    s.viscosity_source = "the finite-size correction is for cubic boxes only";
  else if (!s.temperature)
    s.viscosity_source = "no temperature: the frames have no velocities; give a temperature";
  else if (s.viscosity)
    s.finite_size_correction = yeh_hummer_correction(*s.temperature, *s.viscosity,
                                                     std::cbrt(a.conditions->volume().value));
}

void find_dielectric(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  if (!settings.surroundings_permittivity)
    s.notes.push_back("no dielectric: " + settings.no_surroundings);
  else if (!s.temperature)
    s.notes.push_back("no dielectric constant: the frames have no velocities; give a temperature");
  else
    s.dielectric =
        a.dipole->result(*s.temperature, *settings.surroundings_permittivity, a.mean_interval());
}

/// Of the same numbers.
void find_step_bias(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  const double n = degrees_of_freedom(a.topology).all();
  for (std::size_t k = 0; k < s.peaks.size(); ++k)
    s.peaks_bias.push_back(a.radial->first_peak_bias(k, n, *a.fixed));
  if (s.dielectric)  // velocities have their own bias, and a given temperature has none
    s.dielectric_bias = a.dipole->step_bias(
        settings.temperature || !a.has_velocities ? s.temperature : std::nullopt,
        *settings.surroundings_permittivity, n, *a.fixed);
}

/// The unit of the second digit of a positive number.
double second_digit(double x) { return std::pow(10, std::floor(std::log10(x)) - 1); }

/// The next number with two digits that is not less; a relative 1e-9 is rounding.
double rounded_up(double x) {
  return x > 0 ? second_digit(x) * std::ceil(x / second_digit(x) - 1e-8) : x;
}

double rounded_down(double x) {
  return x > 0 ? second_digit(x) * std::floor(x / second_digit(x) + 1e-8) : x;
}

}  // namespace

std::string not_converged(const Convergence& c, const RelaxationName& relaxation) {
  const std::string longer = fmt::format("a run of at least {:g} {}", rounded_up(c.needed), c.unit);
  switch (c.obstacle) {
    case Obstacle::slope_changes:
      return fmt::format(
          "not converged: the slope of the mean-square displacement differs between the halves of "
          "the fit, up to {:.2g} ps; use a longer window, a fit from a longer lag, or {}",
          c.relaxation, longer);
    case Obstacle::integral_changes:
      return fmt::format(
          "not converged: the integral up to half of the window differs from that up to {:.2g} ps; "
          "use a longer window, or {}",
          c.relaxation, longer);
    case Obstacle::interval:
      return fmt::format(
          "not converged: the frames are too far apart for an integral over velocities; write them "
          "every {:g} fs or more often",
          rounded_down(units::fs_per_ps * c.interval));
    case Obstacle::none:
    case Obstacle::length:
    case Obstacle::no_error:
    case Obstacle::still_moving:
      break;
  }
  const bool shorter = relaxation.window && c.obstacle == Obstacle::length;
  return fmt::format("not converged: length {:.3g} {}, {} {:.2g} {}; {} is needed{}", c.length,
                     c.unit, relaxation.text, c.relaxation, c.unit, longer,
                     shorter ? fmt::format(", or a window of at most {:g} ps",
                                           rounded_down(c.length / windows_of_lags))
                             : "");
}

void SummarySettings::set_surroundings(const ForceSettings& forces) {
  switch (forces.electrostatics) {
    case Electrostatics::pme:
      surroundings_permittivity = tin_foil;
      break;
    case Electrostatics::reaction_field:
      surroundings_permittivity = forces.dielectric;
      break;
    case Electrostatics::coulomb:
    case Electrostatics::damped_shifted_force:
      surroundings_permittivity.reset();
      no_surroundings =
          "dipole fluctuations give no dielectric constant if electrostatics is truncated or "
          "switched; pme or a reaction field is needed";
  }
}

void SummarySettings::set_run(const Config& config) {
  set_surroundings(config.forces);
  constant_energy = config.ensemble.constant_energy();
  // The default of a run at constant energy says nothing about its velocities.
  const bool told = config.system.temperature_given || !constant_energy;
  if (told && config.system.temperature > 0) run_temperature = config.system.temperature;
}

std::optional<SeriesEstimate> PartSummary::corrected(const AnalysisSummary& summary) const {
  if (!diffusion || !summary.finite_size_correction) return std::nullopt;
  return SeriesEstimate{diffusion->value + *summary.finite_size_correction, diffusion->error,
                        diffusion->known};
}

AnalysisSummary summary(Analysis& a, const SummarySettings& settings, Workers& workers) {
  AnalysisSummary s;
  s.notes = a.notes;
  find_temperature(s, a, settings);
  if (a.radial)
    for (std::size_t k = 0; k < a.pairs.size(); ++k) s.peaks.push_back(a.radial->first_peak(k));
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part)
    s.parts.push_back(part_summary(a, part, s, settings, workers));
  if (a.displacement) find_correction(s, a, settings);
  if (a.dipole) find_dielectric(s, a, settings);
  if (a.frames_with_step_error > 0) find_step_bias(s, a, settings);
  return s;
}

}  // namespace polhode
