// SPDX-License-Identifier: MIT
#include "run_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode::cli {
namespace {

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

/// With fewer samples there is neither a fluctuation nor a slope.
constexpr std::uint64_t fewest_samples = 3;

std::string not_known(std::uint64_t samples) {
  return fmt::format("not known from {} samples", samples);
}

/// Why an error is missing; empty if it is not.
std::string missing_error(Known known, std::uint64_t samples) {
  switch (known) {
    case Known::yes:
      return "";
    case Known::too_few_samples:
      return fmt::format(", its error is {}", not_known(samples));
    case Known::too_short:
      return ", the run is too short to estimate its error";
  }
  return "";
}

/// A value with its error, in a unit that both are given in.
std::string with_error(const Estimate& e, Known known, std::uint64_t samples, int digits,
                       const char* unit) {
  if (known == Known::yes)
    return fmt::format("{:.{}g} ± {:.2g} {}", e.value, digits, e.error, unit);
  return fmt::format("{:.{}g} {}{}", e.value, digits, unit, missing_error(known, samples));
}

std::string verdict(const Drift& drift) {
  switch (drift.known) {
    case Known::yes:
      return drift.significant() ? "significant" : "not significant";
    case Known::too_few_samples:
      return "too few samples";
    case Known::too_short:
      return "run too short";
  }
  return "";
}

std::string drift_text(const Drift& drift, std::uint64_t samples) {
  if (samples < fewest_samples) return not_known(samples);
  const std::string rate = with_error(drift.rate, drift.known, samples, 3, "kJ/mol/ps");
  if (drift.known != Known::yes) return rate;
  return fmt::format("{}, {} (p-value {:.2g})", rate, verdict(drift), drift.p_value);
}

void print_ratio(const RunSummary& s) {
  fmt::print("R                     ");
  if (s.samples < fewest_samples) {
    fmt::print("{}\n", not_known(s.samples));
  } else if (s.potential_fluctuation == 0) {
    fmt::print("not defined: the potential energy is constant\n");
  } else {
    fmt::print(
        "{}   (rms of total energy {:.4g} over that of the potential {:.4g} kJ/mol)\n",
        with_error({100 * s.ratio.value, 100 * s.ratio.error}, s.ratio.known, s.samples, 4, "%"),
        s.total_fluctuation, s.potential_fluctuation);
    if (s.rounding > 0)
      fmt::print(
          "R of rounding         {:.2g} %, estimated{}\n", 100 * s.rounding,
          s.ratio.value < rounding_margin * s.rounding
              ? "; R is dominated by rounding: precision = \"double\" shows the R of the scheme"
              : "");
  }
}

/// A number where it is known.
nlohmann::json number_if(bool known, double value) {
  return known && std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

/// Keys of a drift; error, p-value and significance are null if they are not known, and the verdict
/// gives the reason.
nlohmann::json drift_json(const Drift& drift, std::uint64_t samples) {
  const bool known = drift.known == Known::yes;
  return {{"drift_kJ_per_mol_ps", number_if(samples >= fewest_samples, drift.rate.value)},
          {"drift_error", number_if(known, drift.rate.error)},
          {"drift_p_value", number_if(known, drift.p_value)},
          {"drift_significant", known ? nlohmann::json(drift.significant()) : nlohmann::json()},
          {"drift_verdict", verdict(drift)}};
}

}  // namespace

void print_summary(const RunSummary& s, const TrajectorySettings& t,
                   const ExecutionSettings& execution) {
  const auto percent = [](double x) { return 100 * x; };
  fmt::print("{} molecules, {} steps of {:g} fs with {}, {:.4g} ps, energies every {:g} fs\n\n",
             s.molecules, s.steps, t.step * units::fs_per_ps, name_of({t.scheme, t.inner}),
             s.length, s.sample * units::fs_per_ps);
  print_ratio(s);
  fmt::print("drift                 {}{}\n", drift_text(s.drift, s.samples),
             s.walk_known ? "" : "; part of it is the random walk of rounding in mixed precision");
  if (s.shadow)
    fmt::print("shadow energy drift   {}{}; rms fluctuation {:.3g} kJ/mol\n",
               drift_text(s.shadow->drift, s.shadow->samples),
               s.shadow->time_gain
                   ? fmt::format(", detected {:.2g} times sooner", *s.shadow->time_gain)
                   : "",
               s.shadow->fluctuation);
  fmt::print("potential energy      {:.4f} kJ/mol per molecule\n", s.potential);
  fmt::print("total energy          {:.4f} kJ/mol per molecule\n", s.total);
  const auto kelvin = [](double degrees_of_freedom, double T) {
    return degrees_of_freedom > 0 ? fmt::format("{:.2f}", T) : "-";
  };
  fmt::print("temperature           {} K: translation {}, rotation",
             kelvin(s.degrees_of_freedom.all(), s.temperatures.all),
             kelvin(s.degrees_of_freedom.translation, s.temperatures.translation));
  for (std::size_t k = 0; k < 3; ++k)
    fmt::print(" {}", kelvin(s.degrees_of_freedom.rotation[k], s.temperatures.rotation[k]));
  fmt::print(" K");
  if (std::any_of(s.configurational.begin(), s.configurational.end(),
                  [](const auto& known) { return known.has_value(); })) {
    const auto text = [&](std::size_t k) {
      const auto& known = s.configurational[k];
      if (!known) return std::string("-");
      return known->known == Known::yes ? fmt::format("{:.2f} ± {:.2g}", known->value, known->error)
                                        : fmt::format("{:.2f} (error not known)", known->value);
    };
    fmt::print("\nconfigurational       translation {}, rotation {}, {}, {} K", text(0), text(1),
               text(2), text(3));
  }
  const DegreesOfFreedom& n = s.degrees_of_freedom;
  fmt::print("\ndegrees of freedom    {:.0f}: translation {:.0f}, rotation {:.0f} {:.0f} {:.0f}",
             n.all(), n.translation, n.rotation[0], n.rotation[1], n.rotation[2]);
  fmt::print(
      "\npressure              {:.0f}{} bar{}", in_bar(s.pressure.value),
      s.pressure.known == Known::yes ? fmt::format(" ± {:.0f}", in_bar(s.pressure.error)) : "",
      missing_error(s.pressure.known, s.samples));
  fmt::print("\ntotal momentum        {:.2g} u nm/ps\n", s.momentum);
  fmt::print("force evaluations     {} ({:.4g} per ps)", s.force_evaluations,
             static_cast<double>(s.force_evaluations) / s.length);
  if (s.derivatives > 0) fmt::print(", and {} of their derivative", s.derivatives);
  if (t.inner) {
    fmt::print(", near forces {} ({:.4g} per ps)", s.near_evaluations,
               static_cast<double>(s.near_evaluations) / s.length);
    if (s.near_derivatives > 0) fmt::print(", and {} of their derivative", s.near_derivatives);
  }
  if (s.measurements > 1) fmt::print(", and {} for energies only", s.measurements);
  fmt::print("\nneighbour list        {} rebuilds\n", s.list_rebuilds);
  const double all = s.timings.all();
  fmt::print(
      "time                  {:.2f} s: forces {:.0f} %, {}list {:.0f} %, drifts and kicks {:.0f} "
      "%, "
      "energies and output {:.0f} %\n",
      all, percent(s.timings.forces / all),
      t.inner ? fmt::format("near forces {:.0f} %, ", percent(s.timings.near / all)) : "",
      percent(s.timings.list / all), percent(s.timings.motion / all),
      percent(s.timings.measurement / all));
  fmt::print("speed                 {:.4g} ns/day with {} {}, instruction set {}\n", s.ns_per_day,
             execution.threads, execution.threads == 1 ? "thread" : "threads",
             execution.instruction_set);
}

void print_json(const RunSummary& s, const TrajectorySettings& t,
                const ExecutionSettings& execution, const RunFileNames& files,
                const std::optional<GuaranteeCheck>& check, bool stopped) {
  nlohmann::json report = {
      {"molecules", s.molecules},
      {"scheme", text_of({t.scheme, t.inner})},
      {"step_fs", t.step * units::fs_per_ps},
      {"steps", s.steps},
      {"length_ps", s.length},
      {"sample_fs", s.sample * units::fs_per_ps},
      {"interrupted", stopped},
      {"samples", s.samples},
      {"R", number_if(s.samples >= fewest_samples, s.ratio.value)},
      {"R_error", number_if(s.ratio.known == Known::yes, s.ratio.error)},
      {"R_rounding", s.rounding},
      {"rms_total_kJ_per_mol", s.total_fluctuation},
      {"rms_potential_kJ_per_mol", s.potential_fluctuation},
      {"potential_kJ_per_mol", s.potential},
      {"total_kJ_per_mol", s.total},
      {"temperature_K", s.temperatures.all},
      {"temperature_translation_K", s.temperatures.translation},
      {"temperature_rotation_K", s.temperatures.rotation},
      {"degrees_of_freedom_translation", s.degrees_of_freedom.translation},
      {"degrees_of_freedom_rotation", s.degrees_of_freedom.rotation},
      {"pressure_bar", in_bar(s.pressure.value)},
      {"pressure_error_bar", number_if(s.pressure.known == Known::yes, in_bar(s.pressure.error))},
      {"momentum", s.momentum},
      {"force_evaluations", s.force_evaluations},
      {"derivative_evaluations", s.derivatives},
      {"near_evaluations", s.near_evaluations},
      {"near_derivative_evaluations", s.near_derivatives},
      {"force_evaluations_for_energies", s.measurements},
      {"list_rebuilds", s.list_rebuilds},
      {"seconds",
       {{"all", s.timings.all()},
        {"forces", s.timings.forces},
        {"near", s.timings.near},
        {"list", s.timings.list},
        {"motion", s.timings.motion},
        {"energies_and_output", s.timings.measurement}}},
      {"ns_per_day", s.ns_per_day},
      {"threads", execution.threads},
      {"instruction_set", execution.instruction_set},
      {"files", files.all()}};
  report.update(drift_json(s.drift, s.samples));
  report["walk_of_rounding_known"] = s.walk_known;
  if (s.shadow) {
    report["shadow"] = drift_json(s.shadow->drift, s.shadow->samples);
    report["shadow"]["samples"] = s.shadow->samples;
    report["shadow"]["rms_kJ_per_mol"] = s.shadow->fluctuation;
    report["shadow"]["time_gain"] =
        s.shadow->time_gain ? nlohmann::json(*s.shadow->time_gain) : nlohmann::json();
  }
  if (s.configurational[0])
    for (const auto& known : s.configurational)
      report["temperature_configurational_K"].push_back(
          known ? nlohmann::json{{"value", known->value},
                                 {"error", number_if(known->known == Known::yes, known->error)}}
                : nlohmann::json());
  report["guarantee"] = check ? as_json(*check) : nlohmann::json();
  fmt::print("{}\n", report.dump(2));
}

}  // namespace polhode::cli
