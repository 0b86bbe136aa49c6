// SPDX-License-Identifier: MIT
#include "analyze_report.hpp"

#include <fmt/core.h>

#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

/// "2.300 ± 0.031", or the value with that many decimals and "± ?" if there are too few frames for
/// an error.
std::string text(const SeriesEstimate& e, int digits, double scale = 1) {
  if (e.known == Known::yes) return with_error(e.value * scale, e.error * scale);
  return fmt::format("{:.{}f} {}", e.value * scale, digits,
                     e.known == Known::too_short ? "(error not known from so short a run)" : "± ?");
}

void print_peak(const SitePair& sites, const std::optional<RadialDistribution::Peak>& peak) {
  const auto& [a, b] = sites;
  fmt::print("{:<22}", fmt::format("g {}-{}", a, b));
  if (!peak) {
    fmt::print("no peak within its range\n");
    return;
  }
  fmt::print("first peak {} at {} nm; ", text(peak->height, 3), text(peak->position, 4));
  if (!peak->shell) {
    fmt::print("no minimum within its range\n");
    return;
  }
  const auto& [end, around_first, around_second] = *peak->shell;
  fmt::print("within {:.3f} nm {} {} around each {}", end.value, text(around_first, 2), b, a);
  if (a != b) fmt::print(", {} {} around each {}", text(around_second, 2), a, b);
  fmt::print("\n");
}

std::string bias_size(const SeriesEstimate& bias) {
  return bias.known == Known::yes ? with_error(bias.value, bias.error)
                                  : fmt::format("{:.2g} (error not known)", bias.value);
}

/// "-0.0123 ± 0.0004, without it 2.912"
std::string bias_text(const SeriesEstimate& bias, double value, int digits) {
  return fmt::format("{}, without it {:.{}f}", bias_size(bias), value - bias.value, digits);
}

void print_peak_bias(const RadialDistribution::Peak& bias, const RadialDistribution::Peak& peak) {
  fmt::print("  bias of the step    height {}; position {} nm\n",
             bias_text(bias.height, peak.height.value, 4),
             bias_text(bias.position, peak.position.value, 5));
}

void print_dielectric_bias(const SeriesEstimate& bias, const TotalDipole::Result& dielectric) {
  fmt::print("  bias of the step    {}\n", dielectric.convergence.converged()
                                               ? bias_text(bias, dielectric.constant.value, 2)
                                               : bias_size(bias));
}

void print_part(const PartSummary& part, const AnalysisSummary& s) {
  if (part.diffusion && !part.diffusion_convergence.converged()) {
    fmt::print("D of {:<17}{}\n", part.molecule,
               not_converged(part.diffusion_convergence, max_lag));
  } else if (part.diffusion) {
    fmt::print("D of {:<17}{} 1e-9 m2/s in this box, lags {:g} to {:g} ps\n", part.molecule,
               text(*part.diffusion, 3, in_1e9_m2_per_s), s.fit.from, s.fit.to);
    if (const auto D = part.corrected(s))
      fmt::print("{:<22}{} 1e-9 m2/s corrected for finite size (viscosity {})\n", "",
                 text(*D, 3, in_1e9_m2_per_s), s.viscosity_source);
    else
      fmt::print("{:<22}not corrected for finite size: {}\n", "", s.viscosity_source);
  }
  if (part.green_kubo)
    fmt::print(
        "{:<22}{}\n", fmt::format("D of {}", part.molecule),
        part.green_kubo_convergence.converged()
            ? text(*part.green_kubo, 3, in_1e9_m2_per_s) + " 1e-9 m2/s in this box, from velocities"
            : "from velocities: " + not_converged(part.green_kubo_convergence, max_lag));
  for (const AxisRelaxation& axis : part.axes)
    for (std::size_t k = 0; k < 2; ++k) {
      fmt::print("{:<22}", fmt::format("P{} {} {}", k + 1, part.molecule, axis.axis));
      const auto& t = axis.rank[k];
      if (t && !t->convergence.converged())
        fmt::print("{}\n", not_converged(t->convergence, decay_time));
      else if (t)
        fmt::print("{} ps by integral, {} ps by exponential ({:g} to {:g} ps)\n",
                   text(t->integral, 3), text(t->exponential, 3), t->from, t->to);
      else
        fmt::print("{}\n", not_decayed);
    }
}

}  // namespace

void print_analysis(const AnalysisReport& report) {
  const Analysis& a = report.analysis;
  const AnalysisSummary& s = report.summary;
  fmt::print("{} frames from {:g} to {:g} ps", a.frames, a.first, a.last);
  if (a.interval > 0) fmt::print(", {:.6g} ps apart", a.interval);
  fmt::print(", {} molecules\n\n", a.topology.size());
  fmt::print("density               {} kg/m3\n",
             text(a.conditions->density(), 2, 1 / unit("kg/m3", Dimension::density)));
  if (a.has_velocities)
    fmt::print("temperature           {} K, of the velocities\n",
               text(a.conditions->temperature(), 2));
  else if (s.temperature)
    fmt::print("temperature           {:g} K, {}\n", *s.temperature, s.temperature_source);
  for (std::size_t k = 0; k < s.peaks.size(); ++k) {
    print_peak(a.pairs[k], s.peaks[k]);
    if (a.fixed && s.peaks_bias[k]) print_peak_bias(*s.peaks_bias[k], *s.peaks[k]);
  }
  for (const PartSummary& part : s.parts) print_part(part, s);
  if (const auto& d = s.dielectric; d && !d->convergence.converged())
    fmt::print("dielectric constant   {}; |<M>| is {:.2f} of the rms M\n",
               not_converged(d->convergence, dipole_relaxation), d->mean_over_rms);
  else if (d)
    fmt::print("dielectric constant   {}; Kirkwood factor {}; |<M>| is {:.2f} of the rms M\n",
               text(d->constant, 2), text(d->kirkwood, 2), d->mean_over_rms);
  if (s.dielectric_bias) print_dielectric_bias(s.dielectric_bias->constant, *s.dielectric);
  print_files(report.files);
}

}  // namespace polhode::cli
