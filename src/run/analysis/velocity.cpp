// SPDX-License-Identifier: MIT
// Autocorrelation of velocities and angular velocities, with spectra and diffusion coefficients.
#include <fmt/core.h>

#include <cstring>

#include "convergence_results.hpp"
#include "curves.hpp"
#include "io/settings/output_units.hpp"
#include "measure/velocity_correlation.hpp"
#include "run/analysis/analysis_summary.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

constexpr double wavenumber = 1e12 / 29979245800.0;  // conversion of 1/ps to wavenumbers [1/cm]
constexpr double max_interval = 0.02;                // maximum interval between frames for spectra
                                                     // [ps]

std::string why_no_velocities(const FirstFrames& f) {
  return f.analysis.has_velocities ? "" : "the frames have no velocities";
}

struct NamedCorrelation {
  std::size_t part;
  std::string name;
  BlockMeans curve;
  bool linear;
};

std::vector<NamedCorrelation> named_correlations(VelocityCorrelation& velocity,
                                                 const AllFrames& all) {
  std::vector<NamedCorrelation> curves;
  for (std::size_t part = 0; part < all.analysis.topology.parts.size(); ++part) {
    curves.push_back({part, "v", velocity.linear(part, all.workers), true});
    for (const std::size_t axis : velocity.turning_axes(part))
      curves.push_back({part,
                        velocity.linear_body(part) ? "omega" : fmt::format("omega {}", axis + 1),
                        velocity.angular(part, axis, all.workers), false});
  }
  return curves;
}

/// Adds a curve of a part to a table and to the panel of the part.
void add_to_panel(AnalysisFile& file, const Analysis& a, const NamedCorrelation& one,
                  const std::string& unit, const std::vector<SeriesEstimate>& values) {
  draw(file.figure.panels[one.part],
       one.linear ? one.name : "ω" + one.name.substr(std::strlen("omega")),
       add(file.table, of_part(a, one.part, one.name), unit, values), values);
}

/// The files of autocorrelation functions. The functions are divided by the value at lag 0. This
/// value is in a separate column.
std::vector<AnalysisFile> files_of(const Analysis& a, const std::vector<NamedCorrelation>& curves) {
  const std::size_t lags = curves.front().curve.mean().size();
  AnalysisFile time = file_of_lags(
      "velocity", lags, a.interval,
      {{}, "autocorrelation of velocities and angular velocities", "lag  (ps)", "C(t)/C(0)"});
  const Spectrum first = spectrum(curves.front().curve, a.interval);
  AnalysisFile spectra = file_over(
      "spectrum", "frequency", "THz", first.frequency.size(),
      [&](std::size_t k) { return first.frequency[k]; },
      {{}, "spectra of velocities and angular velocities", "frequency  (THz)", "I  (ps)"});
  for (std::size_t part = 0; part < a.topology.parts.size(); ++part)
    for (AnalysisFile* file : {&time, &spectra})
      file->figure.panels.push_back({title_of_part(a, part), {}});
  spectra.table.columns.push_back({"wavenumber", "1/cm"});
  for (std::size_t k = 0; k < first.frequency.size(); ++k)
    spectra.table.rows[k].emplace_back(first.frequency[k] * wavenumber);
  for (const NamedCorrelation& one : curves) {
    const std::string name = of_part(a, one.part, one.name);
    add_to_panel(time, a, one, "1", series_estimates(normalized(one.curve)));
    add(time.table, name + " product", one.linear ? "nm2/ps2" : "1/ps2",
        series_estimates(one.curve));
    if (one.linear)
      add(time.table, name + " integral", "nm2/ps",
          series_estimates(running_integral(one.curve, a.interval)));
    add_to_panel(spectra, a, one, "ps", spectrum(one.curve, a.interval).intensity);
  }
  finish(time.figure, false);
  finish(spectra.figure, true);
  return {std::move(time), std::move(spectra)};
}

/// The Green-Kubo diffusion coefficient, from the integral of the velocity autocorrelation function
/// over all lags.
Quantities green_kubo(const BlockMeans& C, double interval, const std::string& molecule) {
  const SeriesEstimate D =
      scaled(series_estimates(running_integral(C, interval)).back(), in_1e9_m2_per_s);
  const Convergence c = integral_convergence(C, interval);
  return {{"D_green_kubo", "1e-9 m2/s", converging(D, c, max_lag)},
          row("D of " + molecule, c.converged()
                                      ? short_text(D) + " 1e-9 m2/s in this box, from velocities"
                                      : "from velocities: " + not_converged(c, max_lag))};
}

ObservableResults velocity_results(VelocityCorrelation& velocity, const AllFrames& all) {
  const Analysis& a = all.analysis;
  if (a.interval > max_interval)
    all.notes.push_back(
        fmt::format("velocities of light molecules reverse within 20 fs, so an interval of {:g} fs "
                    "between frames is too long: spectra are aliased above {:.3g} THz",
                    units::fs_per_ps * a.interval, 0.5 / a.interval));
  const std::vector<NamedCorrelation> curves = named_correlations(velocity, all);
  ObservableResults results;
  results.parts.resize(a.topology.parts.size());
  for (const NamedCorrelation& one : curves) {
    const auto& [molecule, count] = a.topology.parts[one.part];
    if (one.linear && count > 0 && a.topology.size() > 1)
      results.parts[one.part] = green_kubo(one.curve, a.interval, molecule.name);
  }
  results.files = files_of(a, curves);
  return results;
}

}  // namespace

ObservableKind velocity() {
  ObservableKind kind = correlated<VelocityCorrelation>("velocity", {"velocity", "spectrum"},
                                                        why_no_velocities, velocity_results);
  kind.needs_velocities = true;
  return kind;
}

}  // namespace polhode
