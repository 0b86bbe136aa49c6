// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/analysis_summary.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

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

void find_viscosity(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  if (settings.viscosity) {
    s.viscosity = settings.viscosity;
    s.viscosity_source = "as given";
    return;
  }
  s.viscosity_source = "there is no published viscosity for these molecules; give it";
  if (a.topology.parts.size() != 1) return;
  for (const PublishedViscosity& known : published) {
    if (a.topology.parts.front().molecule.name != known.model) continue;
    if (!s.temperature || std::abs(*s.temperature - published_temperature) > near) {
      s.viscosity_source =
          fmt::format("the published viscosity is for {:g} K; give that of this temperature",
                      published_temperature);
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
    const BlockMeans integral = running_integral(a.velocity->linear(part, workers), a.interval);
    p.green_kubo = series_estimates(integral).back();
    p.green_kubo_convergence = integral_convergence(integral, a.interval);
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
  if (s.dielectric)
    s.dielectric_bias =
        a.dipole->step_bias(settings.temperature, *settings.surroundings_permittivity, n, *a.fixed);
}

}  // namespace

std::string not_converged(const Convergence& c, const std::string& relaxation) {
  return fmt::format(
      "not converged: length {:.3g} {}, {} {:.2g} {}; a run of at least {:.2g} {} is "
      "needed",
      c.length, c.unit, relaxation, c.relaxation, c.unit, c.needed, c.unit);
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
      no_surroundings =
          "dipole fluctuations give no dielectric constant if electrostatics is truncated or "
          "switched; pme or a reaction field is needed";
  }
}

std::optional<SeriesEstimate> PartSummary::corrected(const AnalysisSummary& summary) const {
  if (!diffusion || !summary.finite_size_correction) return std::nullopt;
  return SeriesEstimate{diffusion->value + *summary.finite_size_correction, diffusion->error,
                        diffusion->known};
}

AnalysisSummary summary(Analysis& a, const SummarySettings& settings, Workers& workers) {
  AnalysisSummary s;
  s.notes = a.notes;
  const double kinetic = a.conditions->temperature().value;
  if (settings.temperature)
    s.temperature = settings.temperature;
  else if (kinetic > 0)
    s.temperature = kinetic;
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
