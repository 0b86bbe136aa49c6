// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/run_report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "averages.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/report/warning_rules.hpp"

namespace polhode {
namespace {

double percent(double x) { return 100 * x; }

/// A number that is known only if a condition is true, and is NaN otherwise.
double known_if(bool known, double value) {
  return known ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string energy_name(const RunSummary& s) {
  return s.ensemble.settings.constant_energy() ? "total" : "conserved";
}

Quantities of_settings(const RunReport& r) {
  const RunSummary& s = r.summary;
  const NestedScheme scheme{r.settings.scheme, r.settings.inner};
  const Segment& segment = s.segment;
  return {{"molecules", "", s.molecules, "number of molecules"},
          {"scheme", "", name_of(scheme), "name of the scheme, or its stages"},
          {"text", "", text_of(scheme), "stages of the scheme as text"},
          {"processed", "", r.settings.processed,
           "whether energies and frames are read through a postprocessor"},
          {"step", "fs", r.settings.step * units::fs_per_ps, "time step"},
          {"steps", "", s.steps, "number of steps"},
          {"length", "ps", s.length, "simulated time"},
          detail({"sample", "fs", s.sample * units::fs_per_ps,
                  "interval between samples of the energies", "energies every", ""}),
          {"interrupted", "", r.interrupted, "whether the run was suspended before its end"},
          {"samples", "", s.samples, "number of samples of the energies"},
          {"segment", "",
           Quantities{
               {"number", "", segment.number, "number of the segment to which all results belong"},
               {"first_step", "", segment.first_step, "step at which the segment begins"},
               {"earlier", "ps", segment.earlier, "time simulated before the segment"},
               {"changes", "", segment.changes.empty() ? Value() : Value(segment.changes),
                "changes made at the beginning of the segment; null if there were none"}}},
          {"files", "", r.files.all(), "names of the files that were written"}};
}

/// The result of a drift test as text: "significant", "not significant", or the reason why the
/// significance is not known.
std::string verdict(const Drift& drift) {
  if (drift.known != Known::yes) return reason(drift.known);
  return drift.significant() ? "significant" : "not significant";
}

/// A drift as text, such as "0.012 ± 0.004 kJ/mol/ps, not significant (p-value 0.2)".
std::string drift_text(const Drift& drift, std::uint64_t samples) {
  if (samples < min_samples_reported) return not_known(Known::too_few_samples);
  const SeriesEstimate rate{drift.rate.value, drift.rate.error, drift.known};
  std::string text = text_of(rate, "kJ/mol/ps") + missing_error(drift.known);
  if (drift.known != Known::yes) return text;
  return fmt::format("{}, {} (p-value {:.2g})", text, verdict(drift), drift.p_value);
}

Quantities of_drift(const Drift& drift, double walk, std::uint64_t samples) {
  const bool known = drift.known == Known::yes;
  return {{"drift", "kJ/mol/ps", known_if(samples >= min_samples_reported, drift.rate.value),
           "slope of a least-squares line fitted to the energy as a function of time"},
          {"drift_error", "", known_if(known, drift.rate.error),
           "standard error of the slope [kJ/mol/ps]"},
          {"drift_p_value", "", known_if(known, drift.p_value),
           "probability of a slope of at least this size without an energy drift"},
          {"drift_significant", "", known ? Value(drift.significant()) : Value(),
           "whether the p-value is below 0.01"},
          {"drift_verdict", "", verdict(drift),
           "`significant`, `not significant`, or the reason why the significance is not known"},
          {"random_walk", "kJ/mol per sqrt(ps)", known_if(walk > 0, std::sqrt(walk)),
           "rms change of the energy in 1 ps by a random walk; null if there is no evidence for a "
           "random walk"}};
}

std::string ratio_text(const RunSummary& s) {
  if (s.samples < min_samples_reported) return not_known(Known::too_few_samples);
  if (s.potential_fluctuation.value == 0) return "not defined: the potential energy is constant";
  return text_of(scaled(s.ratio, 100), "%") + (s.ratio.known == Known::grows
                                                   ? ", which grows with the length of the run"
                                                   : missing_error(s.ratio.known));
}

/// The two fluctuations whose ratio is R, and the size of the energy drift; empty if they are not
/// known.
Quantities conservation_details(const RunSummary& s) {
  if (s.samples < min_samples_reported || s.potential_fluctuation.value == 0) return {};
  return {
      detail(row(
          "rms fluctuations",
          fmt::format(
              "{} energy {:.4g} kJ/mol, potential energy {:.4g} kJ/mol; R is the ratio of the two",
              energy_name(s), s.total_fluctuation.value, s.potential_fluctuation.value))),
      detail(row("drift in this run",
                 fmt::format("{} energy: {:.2g} % of the rms fluctuation of the potential energy{}",
                             energy_name(s), percent(s.relative_drift()),
                             drift_matters(s) ? "" : ", too little to matter")))};
}

/// Rows on energy conservation. For hybrid Monte Carlo the list is empty, because no energy is
/// conserved.
Quantities conservation_rows(const RunSummary& s) {
  if (s.ensemble.settings.hybrid_monte_carlo) return {};
  Quantities rows = conservation_details(s);
  rows.push_back(row("R", ratio_text(s)));
  if (s.rounding > 0 && s.samples >= min_samples_reported) {
    const bool dominates = s.ratio.value < rounding_margin * s.rounding;
    rows.push_back(row(
        "round-off limit of R",
        fmt::format("{:.2g} %, estimated{}", percent(s.rounding),
                    dominates
                        ? "; rounding dominates R: precision = \"double\" shows the R of the scheme"
                        : "")));
    rows.back().detail = !dominates;
  }
  const bool harmless = s.drift.known == Known::yes && s.drift.significant() && !drift_matters(s);
  rows.push_back(
      row("energy drift",
          fmt::format(
              "{}{}{}", drift_text(s.drift, s.samples), harmless ? ", too little to matter" : "",
              s.walk_known
                  ? ""
                  : "; the drift includes the random walk caused by rounding in mixed precision")));
  if (s.walk > 0)
    rows.push_back(
        detail(row("random walk",
                   fmt::format("{} energy: {:.2g} kJ/mol per sqrt(ps); R is {:.2g} % in this run "
                               "and grows as the square root of the run length",
                               energy_name(s), std::sqrt(s.walk), percent(s.ratio_of_walk())))));
  return rows;
}

Quantities of_conservation(const RunSummary& s) {
  const bool known = s.samples >= min_samples_reported && s.potential_fluctuation.value > 0;
  const double n = s.degrees_of_freedom.all(), kT = units::boltzmann * s.temperatures.all.value;
  Quantities list = of_drift(s.drift, s.walk, s.samples);
  SeriesEstimate ratio = s.ratio;
  ratio.value = known_if(s.samples >= min_samples_reported, ratio.value);
  append(
      list,
      {{"R", "%", ratio,
        "rms fluctuation of the conserved energy, divided by the rms fluctuation of the potential "
        "energy"},
       {"rms_total", "kJ/mol", s.total_fluctuation, "rms fluctuation of the conserved energy"},
       {"rms_potential", "kJ/mol", s.potential_fluctuation,
        "rms fluctuation of the potential energy"},
       {"R_rounding", "%", s.rounding, "estimated round-off limit of R; 0 in double precision"},
       {"R_truncation", "%", s.truncation,
        "R predicted for the random walk that the truncation causes"},
       {"R_of_random_walk", "%", known_if(s.walk > 0, s.ratio_of_walk()),
        "R that the random walk would cause if there were no other errors; null if there is no "
        "evidence for "
        "a random walk"},
       {"walk_of_rounding_known", "", s.walk_known,
        "whether the size of the random walk caused by rounding is known"},
       {"drift_in_run_over_rms_potential", "", known_if(known, s.relative_drift()),
        "energy change due to the drift in this run, divided by the rms fluctuation of the "
        "potential energy"},
       {"drift_kT_per_ns_per_degree_of_freedom", "",
        known_if(known && n > 0, s.drift.rate.value * units::ps_per_ns / (kT * n)),
        "energy drift per degree of freedom"}});
  return list;
}

/// Results on the shadow energy; empty if the shadow energy was not sampled.
Quantities of_shadow(const RunSummary& s) {
  if (!s.shadow) return {};
  const ShadowSummary& shadow = *s.shadow;
  const SeriesEstimate& rms = shadow.fluctuation;
  const bool known = rms.known == Known::yes;
  Quantities list = of_drift(shadow.drift, shadow.drift.walk, shadow.samples);
  append(list, {{"samples", "", shadow.samples, "number of samples of the shadow energy"},
                {"rms", "kJ/mol", rms.value, "rms fluctuation of the shadow energy"},
                {"rms_error", "kJ/mol", known_if(known, rms.error),
                 "standard error of the rms fluctuation of the shadow energy"},
                {"time_gain", "", shadow.time_gain,
                 "factor by which the shadow energy shortens the time until an energy drift is "
                 "significant"}});
  if (!known)
    list.push_back(
        {"error_not_known", "", reason(rms.known),
         "reason why the standard error of the rms fluctuation of the shadow energy is not known"});
  Quantities all = {{"shadow", "", std::move(list)}};
  if (!s.ensemble.settings.hybrid_monte_carlo)
    all.push_back(detail(
        row("shadow energy drift",
            fmt::format("{}{}; rms fluctuation {}{}", drift_text(shadow.drift, shadow.samples),
                        shadow.time_gain
                            ? fmt::format(", detected {:.2g} times sooner", *shadow.time_gain)
                            : "",
                        text_of(rms, "kJ/mol"), missing_error(rms.known)))));
  return all;
}

std::string evaluations_text(const RunSummary& s, bool nested) {
  const auto per_ps = [&](std::uint64_t n) {
    return fmt::format("{} ({:.4g} per ps)", n, static_cast<double>(n) / s.length);
  };
  std::string text = per_ps(s.force_evaluations);
  if (s.derivatives > 0)
    text += fmt::format(", and {} evaluations of the derivative", s.derivatives);
  if (nested) text += ", near forces " + per_ps(s.near_evaluations);
  if (nested && s.near_derivatives > 0)
    text += fmt::format(", and {} evaluations of the derivative", s.near_derivatives);
  if (s.measurements > 1)
    text += fmt::format(", and {} evaluations for energies only", s.measurements);
  if (s.ensemble.barostat)
    text += fmt::format(", {} evaluations for moves of the box", s.ensemble.barostat->evaluations);
  if (s.minimisation_evaluations > 0)
    text += fmt::format(", {} evaluations for the minimisation", s.minimisation_evaluations);
  return text;
}

std::string time_text(const Timings& t, bool nested) {
  const double unit = t.all() / 100;
  return fmt::format(
      "{:.2f} s: forces {:.0f} %, {}list {:.0f} %, drifts and kicks {:.0f} %, energies and output "
      "{:.0f} %",
      t.all(), t.forces / unit, nested ? fmt::format("near forces {:.0f} %, ", t.near / unit) : "",
      t.list / unit, t.motion / unit, t.measurement / unit);
}

Quantities of_costs(const RunReport& r) {
  const RunSummary& s = r.summary;
  const bool nested = r.settings.inner.has_value();
  const Timings& t = s.timings;
  const std::uint64_t moves = s.ensemble.barostat ? s.ensemble.barostat->evaluations : 0;
  return {
      detail(row("force evaluations", evaluations_text(s, nested))),
      {"force_evaluations", "", s.force_evaluations, "force evaluations of the scheme"},
      {"derivative_evaluations", "", s.derivatives, "evaluations of the derivative of the forces"},
      {"near_evaluations", "", s.near_evaluations,
       "evaluations of the near forces of an inner scheme"},
      {"near_derivative_evaluations", "", s.near_derivatives,
       "evaluations of the derivative of the near forces"},
      {"force_evaluations_for_energies", "", s.measurements,
       "force evaluations made only for energies"},
      {"force_evaluations_of_moves", "", moves, "force evaluations for moves of the barostat"},
      {"force_evaluations_of_minimisation", "", s.minimisation_evaluations,
       "force evaluations of the minimisation before the trajectory"},
      detail({"list_rebuilds", "", s.list_rebuilds, "number of rebuilds of the neighbour list",
              "neighbour list", " rebuilds"}),
      detail(row("time", time_text(t, nested))),
      {"seconds", "",
       Quantities{
           {"all", "", t.all(), "wall-clock time of the run [s]"},
           {"forces", "", t.forces, "wall-clock time for forces [s]"},
           {"near", "", t.near, "wall-clock time for the near forces of an inner scheme [s]"},
           {"list", "", t.list, "wall-clock time for neighbour lists [s]"},
           {"motion", "", t.motion, "wall-clock time for drifts and kicks [s]"},
           {"energies_and_output", "", t.measurement,
            "wall-clock time for energies and output [s]"}}},
      detail({"ns_per_day", "", s.ns_per_day, "simulated time per day of wall-clock time", "speed",
              fmt::format(" ns/day with {} {}, instruction set {}", r.execution.threads,
                          r.execution.threads == 1 ? "thread" : "threads",
                          r.execution.instruction_set)}),
      {"threads", "", r.execution.threads, "number of threads"},
      {"instruction_set", "", r.execution.instruction_set, "instruction set of the kernels"}};
}

/// The check of the accuracy guarantee; null if no bound was requested.
Quantity of_guarantee(const std::optional<GuaranteeCheck>& k) {
  if (!k) return {"guarantee", "", {}};
  const std::string name = k->guarantee.accuracy.of == RequiredOf::ratio ? "R" : "bias";
  return {"guarantee", "",
          Quantities{{"accuracy", "", k->guarantee.accuracy.bound, "requested bound"},
                     {"requested", "", text_of(k->guarantee.accuracy), "requested bound as text"},
                     {"length", "ps", k->guarantee.length,
                      "length of the runs for which the accuracy is guaranteed"},
                     {"R_expected", "", k->guarantee.expected.value,
                      "value of the bounded quantity in the runs that confirmed the choice"},
                     {"met", "", k->met(), "whether this run meets the bound"},
                     row("accuracy guarantee",
                         fmt::format("{}: {}", k->met() ? "met" : "NOT MET", guarantee_text(*k))),
                     {name, "", k->value.value, name + " of this run"},
                     {name + "_error", "", k->value.error, "standard error of " + name}}};
}

}  // namespace

Quantities run_quantities(const RunReport& r) {
  const RunSummary& s = r.summary;
  Quantities all = {
      row("", fmt::format("{} molecules, {} steps of {:g} fs with {}: {:.4g} ps in {:.2f} s "
                          "({} ns/day)",
                          s.molecules, s.steps, r.settings.step * units::fs_per_ps,
                          name_of({r.settings.scheme, r.settings.inner}), s.length, s.timings.all(),
                          s.ns_per_day < 100 ? fmt::format("{:.3g}", s.ns_per_day)
                                             : fmt::format("{:.0f}", s.ns_per_day))),
      row("", "")};
  append(all, of_settings(r));
  if (!s.ensemble.settings.constant_energy())
    all.push_back(row("ensemble", description(s.ensemble.settings)));
  if (r.settings.processed) all.push_back(row("states read", "through the postprocessor"));
  append(all, of_averages(s));
  append(all, conservation_rows(s));
  append(all, of_conservation(s));
  append(all, of_shadow(s));
  append(all, of_costs(r));
  append(all, of_step_bias(s));
  append(all, {of_guarantee(r.guarantee), row_of_files(r.files.all())});
  append(all, of_warnings(r.warnings));
  return all;
}

std::string run_json(const RunReport& report) {
  return json_text(flattened(run_quantities(report)));
}

}  // namespace polhode
