// SPDX-License-Identifier: MIT
#include "run_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ensemble_report.hpp"
#include "estimate_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"
#include "step_bias_report.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

std::string drift_text(const Drift& drift, std::uint64_t samples) {
  if (samples < min_samples_reported) return not_known(samples);
  std::string rate = estimate_text(drift.rate, drift.known, samples, 3, "kJ/mol/ps");
  if (drift.known != Known::yes) return rate;
  return fmt::format("{}, {} (p-value {:.2g})", rate, verdict(drift), drift.p_value);
}

void print_ratio(const RunSummary& s) {
  fmt::print("R                     ");
  if (s.samples < min_samples_reported) {
    fmt::print("{}\n", not_known(s.samples));
  } else if (s.potential_fluctuation.value == 0) {
    fmt::print("not defined: the potential energy is constant\n");
  } else {
    fmt::print(
        "{}   (rms of the {} energy, {:.4g}, divided by that of the potential energy, {:.4g} "
        "kJ/mol)\n",
        estimate_text({100 * s.ratio.value, 100 * s.ratio.error}, s.ratio.known, s.samples, 4, "%"),
        s.ensemble.settings.constant_energy() ? "total" : "conserved", s.total_fluctuation.value,
        s.potential_fluctuation.value);
    if (s.rounding > 0)
      fmt::print(
          "R of rounding         {:.2g} %, estimated{}\n", 100 * s.rounding,
          s.ratio.value < rounding_margin * s.rounding
              ? "; R is dominated by rounding: precision = \"double\" shows the R of the scheme"
              : "");
  }
}

/// A mean over the run, per molecule.
void print_energy(const char* name, const SeriesEstimate& e, std::uint64_t samples) {
  fmt::print("{:<22}{}\n", name,
             estimate_text({e.value, e.error}, e.known, samples, 7, "kJ/mol per molecule"));
}

double percent(double x) { return 100 * x; }

/// "; in this run 0.4 % of the rms fluctuation of the potential energy, too little to matter".
std::string size_text(const RunSummary& s) {
  if (s.samples < min_samples_reported || s.potential_fluctuation.value == 0) return "";
  return fmt::format("; in this run {:.2g} % of the rms fluctuation of the potential energy{}",
                     percent(s.relative_drift()), drift_matters(s) ? "" : ", too little to matter");
}

void print_drift(const RunSummary& s) {
  const char* energy = s.ensemble.settings.constant_energy() ? "total" : "conserved";
  fmt::print("energy drift          {}{}{}{}\n",
             s.ensemble.settings.constant_energy() ? "" : "of the conserved energy: ",
             drift_text(s.drift, s.samples), size_text(s),
             s.walk_known ? "" : "; part of it is the random walk of rounding in mixed precision");
  if (s.walk > 0)
    fmt::print(
        "random walk           of the {} energy, {:.2g} kJ/mol per sqrt(ps): R of {:.2g} % in "
        "this run, growing as the square root of its length\n",
        energy, std::sqrt(s.walk), percent(s.ratio_of_walk()));
  if (s.shadow)
    fmt::print("shadow energy drift   {}{}; rms fluctuation {}\n",
               drift_text(s.shadow->drift, s.shadow->samples),
               s.shadow->time_gain
                   ? fmt::format(", detected {:.2g} times sooner", *s.shadow->time_gain)
                   : "",
               estimate_text({s.shadow->fluctuation.value, s.shadow->fluctuation.error},
                             s.shadow->fluctuation.known, s.shadow->samples, 3, "kJ/mol"));
}

void print_kinetic(const char* name, const TemperatureEstimates& T, const RunSummary& s) {
  const DegreesOfFreedom& n = s.degrees_of_freedom;
  Known worst = Known::yes;
  const auto text = [&](double degrees_of_freedom, const SeriesEstimate& value) {
    if (degrees_of_freedom == 0) return std::string("-");
    if (value.known != Known::yes) worst = value.known;
    return kelvin(value);
  };
  const std::string all = text(n.all(), T.all), translation = text(n.translation, T.translation);
  std::string rotation;
  for (std::size_t k = 0; k < 3; ++k)
    rotation += (k == 0 ? " " : ", ") + text(n.rotation[k], T.rotation[k]);
  fmt::print("{:<22}{} K: translation {}, rotation{} K{}\n", name, all, translation, rotation,
             missing_error(worst, s.samples));
}

void print_temperatures(const RunSummary& s) {
  const DegreesOfFreedom& n = s.degrees_of_freedom;
  print_kinetic("temperature", s.temperatures, s);
  if (s.temperatures_at_bath) print_kinetic("  of half steps", *s.temperatures_at_bath, s);
  if (std::any_of(s.configurational.begin(), s.configurational.end(),
                  [](const auto& known) { return known.has_value(); })) {
    Known worst = Known::yes;
    for (const auto& known : s.configurational)
      if (known && known->known != Known::yes) worst = known->known;
    const auto text = [&](std::size_t k) {
      const auto& known = s.configurational[k];
      return known ? kelvin(*known) : std::string("-");
    };
    fmt::print("configurational       translation {}, rotation {}, {}, {} K{}\n", text(0), text(1),
               text(2), text(3), worst == Known::yes ? "" : ", errors not known: " + reason(worst));
  }
  fmt::print("degrees of freedom    {:.0f}: translation {:.0f}, rotation {:.0f} {:.0f} {:.0f}\n",
             n.all(), n.translation, n.rotation[0], n.rotation[1], n.rotation[2]);
}

void print_evaluations(const RunSummary& s, bool nested) {
  fmt::print("force evaluations     {} ({:.4g} per ps)", s.force_evaluations,
             static_cast<double>(s.force_evaluations) / s.length);
  if (s.derivatives > 0) fmt::print(", and {} of their derivative", s.derivatives);
  if (nested) {
    fmt::print(", near forces {} ({:.4g} per ps)", s.near_evaluations,
               static_cast<double>(s.near_evaluations) / s.length);
    if (s.near_derivatives > 0) fmt::print(", and {} of their derivative", s.near_derivatives);
  }
  if (s.measurements > 1) fmt::print(", and {} for energies only", s.measurements);
  if (s.ensemble.barostat)
    fmt::print(", {} for moves of the box", s.ensemble.barostat->evaluations);
  if (s.minimisation_evaluations > 0)
    fmt::print(", {} for the minimisation", s.minimisation_evaluations);
  fmt::print("\nneighbour list        {} rebuilds\n", s.list_rebuilds);
}

void print_speed(const RunSummary& s, bool nested, const ExecutionSettings& execution) {
  const double all = s.timings.all();
  fmt::print(
      "time                  {:.2f} s: forces {:.0f} %, {}list {:.0f} %, drifts and kicks {:.0f} "
      "%, "
      "energies and output {:.0f} %\n",
      all, percent(s.timings.forces / all),
      nested ? fmt::format("near forces {:.0f} %, ", percent(s.timings.near / all)) : "",
      percent(s.timings.list / all), percent(s.timings.motion / all),
      percent(s.timings.measurement / all));
  fmt::print("speed                 {:.4g} ns/day with {} {}, instruction set {}\n", s.ns_per_day,
             execution.threads, execution.threads == 1 ? "thread" : "threads",
             execution.instruction_set);
}

/// "R = 0.31 ± 0.02 % over 15 ps", or the bias.
std::string guaranteed_text(const GuaranteeCheck& k) {
  const auto text = [&](const char* name, double unit, const char* unit_text) {
    return fmt::format("{} {} {}", name, with_error(k.value.value / unit, k.value.error / unit),
                       unit_text);
  };
  switch (k.guarantee.accuracy.of) {
    case RequiredOf::ratio:
      return fmt::format("{} over {:.3g} ps", text("R =", 0.01, "%"), k.guarantee.length);
    case RequiredOf::temperature_difference:
      return text("bias of T_rot - T_trans", 1, "K");
    case RequiredOf::energy:
      return text("bias of the potential energy", 1, "kJ/mol per molecule");
    case RequiredOf::pressure:
      return text("bias of the pressure", 1 / in_bar(1), "bar");
    case RequiredOf::density:
      return text("bias of the density", 0.01, "%");
  }
  return "";
}

void print_guarantee(const GuaranteeCheck& k) {
  const std::string what = fmt::format("{}; the accuracy guarantee is {}", guaranteed_text(k),
                                       text_of(k.guarantee.accuracy));
  fmt::print("accuracy guarantee    {}: {}\n", k.met() ? "met" : "NOT MET", what);
  if (!k.met())
    log("warning: the accuracy guarantee of [integrator] accuracy was not met: {}; give a smaller "
        "accuracy, or set the step yourself\n",
        what);
}

/// ", asked for: 1 bar"; empty without a barostat.
std::string pressure_asked(const EnsembleSettings& settings) {
  return settings.barostat
             ? fmt::format(", asked for: {:g} bar", in_bar(settings.barostat->pressure))
             : "";
}

void print_text(const RunReport& r) {
  const RunSummary& s = r.summary;
  const bool nested = r.settings.inner.has_value();
  fmt::print("{} molecules, {} steps of {:g} fs with {}, {:.4g} ps, energies every {:g} fs\n\n",
             s.molecules, s.steps, r.settings.step * units::fs_per_ps,
             name_of({r.settings.scheme, r.settings.inner}), s.length, s.sample * units::fs_per_ps);
  print_ensemble(s.ensemble);
  if (!s.ensemble.hybrid_monte_carlo) {
    print_ratio(s);
    print_drift(s);
  }
  print_energy("potential energy", s.potential, s.samples);
  print_energy("total energy", s.total, s.samples);
  print_temperatures(s);
  fmt::print("pressure              {} bar{}{}\n",
             s.pressure.known == Known::yes
                 ? with_error(in_bar(s.pressure.value), in_bar(s.pressure.error))
                 : fmt::format("{:.0f}", in_bar(s.pressure.value)),
             missing_error(s.pressure.known, s.samples), pressure_asked(s.ensemble.settings));
  print_ensemble_results(s);
  print_step_bias(s);
  fmt::print("total momentum        {:.2g} u nm/ps\n", s.momentum);
  print_evaluations(s, nested);
  print_speed(s, nested, r.execution);
  if (r.guarantee) print_guarantee(*r.guarantee);
  print_files(r.files.all());
  print_warnings(r.warnings);
}

/// The files of an interrupted run, and how to resume it.
void note_end(const RunResult& result, const std::string& checkpoint) {
  switch (result.end) {
    case RunEnd::complete:
      return;
    case RunEnd::interrupted:
      return log("interrupted after {} steps; the results so far follow, and --continue resumes\n",
                 result.report->summary.steps);
    case RunEnd::interrupted_equilibrating:
      return log(
          "interrupted during the equilibration; '{}' is its checkpoint, and --continue resumes\n",
          checkpoint);
    case RunEnd::interrupted_choosing_step:
      return log("interrupted while choosing the step; no file was written\n");
  }
}

std::string checkpoint_of(const Simulation& simulation) {
  return RunFileNames(simulation.config().output).checkpoints.newest;
}

}  // namespace

void print_warnings(const std::vector<Warning>& warnings) {
  if (warnings.empty()) return;
  fmt::print("\nWARNINGS: something is probably wrong with this run\n");
  for (const Warning& w : warnings)
    fmt::print("  {:<18}  {}\n  {:<18}  -> {}\n", w.kind, w.text, "", w.remedy);
}

int print_run(const RunResult& result, const Simulation& simulation, bool json) {
  note_end(result, checkpoint_of(simulation));
  if (result.report && json)
    fmt::print("{}\n", run_json(*result.report));
  else if (result.report)
    print_text(*result.report);
  return result.end == RunEnd::complete ? 0 : 130;
}

void note_resumable(const Simulation& simulation) {
  if (simulation.resumable_step())
    log("'{}' is the checkpoint of step {}, from which --continue resumes\n",
        checkpoint_of(simulation), *simulation.resumable_step());
}

}  // namespace polhode::cli
