// SPDX-License-Identifier: MIT
#include "run_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode::cli {
namespace {

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

std::string verdict(const Drift& drift) {
  return drift.chance < significance ? "significant" : "not significant";
}

}  // namespace

void print_summary(const RunSummary& s, const TrajectorySettings& t, const Means& means) {
  const auto percent = [](double x) { return 100 * x; };
  fmt::print("{} molecules, {} steps of {:g} fs with {}, {:.4g} ps, energies every {:g} fs\n\n",
             s.molecules, s.steps, t.step * 1000, name_of({t.scheme, t.inner}), s.length,
             s.sample * 1000);
  fmt::print(
      "R                     {:.4g} ± {:.2g} %   (rms of total energy {:.4g} over that of the "
      "potential {:.4g} kJ/mol)\n",
      percent(s.ratio.value), percent(s.ratio.error), s.total_fluctuation, s.potential_fluctuation);
  if (s.rounding > 0)
    fmt::print("R of rounding         {:.2g} %, estimated{}\n", percent(s.rounding),
               s.ratio.value < rounding_margin * s.rounding
                   ? "; R is not the scheme's any more: precision = \"double\" gives it"
                   : "");
  fmt::print("drift                 {:.3g} ± {:.2g} kJ/mol/ps, {} (chance {:.2g})\n",
             s.drift.rate.value, s.drift.rate.error, verdict(s.drift), s.drift.chance);
  if (s.shadow)
    fmt::print(
        "drift of the shadow   {:.3g} ± {:.2g} kJ/mol/ps, {} (chance {:.2g}), which shows {:.2g} "
        "times sooner; its rms is {:.3g} kJ/mol\n",
        s.shadow->drift.rate.value, s.shadow->drift.rate.error, verdict(s.shadow->drift),
        s.shadow->drift.chance, s.shadow->sooner, s.shadow->fluctuation);
  fmt::print("potential energy      {:.4f} kJ/mol per molecule\n", s.potential);
  fmt::print("total energy          {:.4f} kJ/mol per molecule\n", s.total);
  const auto kelvin = [](double freedoms, double T) {
    return freedoms > 0 ? fmt::format("{:.2f}", T) : "-";
  };
  fmt::print("temperature           {} K: translation {}, rotation",
             kelvin(s.freedoms.all(), s.temperatures.all),
             kelvin(s.freedoms.translation, s.temperatures.translation));
  for (std::size_t k = 0; k < 3; ++k)
    fmt::print(" {}", kelvin(s.freedoms.rotation[k], s.temperatures.rotation[k]));
  fmt::print(" K");
  if (std::any_of(s.configurational.begin(), s.configurational.end(),
                  [](const auto& known) { return known.has_value(); })) {
    const auto text = [&](std::size_t k) {
      const auto& known = s.configurational[k];
      return known ? fmt::format("{:.2f} ± {:.2g}", known->value, known->error) : "-";
    };
    fmt::print("\nconfigurational       translation {}, rotation {}, {}, {} K", text(0), text(1),
               text(2), text(3));
  }
  const Freedoms& n = s.freedoms;
  fmt::print("\nfreedoms              {:.0f}: translation {:.0f}, rotation {:.0f} {:.0f} {:.0f}",
             n.all(), n.translation, n.rotation[0], n.rotation[1], n.rotation[2]);
  fmt::print("\npressure              {:.0f} ± {:.0f} bar", in_bar(s.pressure.value),
             in_bar(s.pressure.error));
  fmt::print("\ntotal momentum        {:.2g} u nm/ps\n", s.momentum);
  fmt::print("force evaluations     {} ({:.4g} per ps)", s.force_evaluations,
             static_cast<double>(s.force_evaluations) / s.length);
  if (s.derivatives > 0) fmt::print(", and {} of their derivative", s.derivatives);
  if (t.inner) {
    fmt::print(", of near forces {} ({:.4g} per ps)", s.near_evaluations,
               static_cast<double>(s.near_evaluations) / s.length);
    if (s.near_derivatives > 0) fmt::print(", and {} of their derivative", s.near_derivatives);
  }
  if (s.measurements > 1) fmt::print(", and {} for energies alone", s.measurements);
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
             means.threads, means.threads == 1 ? "thread" : "threads", means.target);
}

void print_json(const RunSummary& s, const TrajectorySettings& t, const Means& means,
                const RunFileNames& files, const std::optional<Kept>& kept, bool stopped) {
  nlohmann::json report = {{"molecules", s.molecules},
                           {"scheme", text_of({t.scheme, t.inner})},
                           {"step_fs", t.step * 1000},
                           {"steps", s.steps},
                           {"length_ps", s.length},
                           {"sample_fs", s.sample * 1000},
                           {"interrupted", stopped},
                           {"R", s.ratio.value},
                           {"R_error", s.ratio.error},
                           {"R_rounding", s.rounding},
                           {"rms_total_kJ_per_mol", s.total_fluctuation},
                           {"rms_potential_kJ_per_mol", s.potential_fluctuation},
                           {"drift_kJ_per_mol_ps", s.drift.rate.value},
                           {"drift_error", s.drift.rate.error},
                           {"drift_chance", s.drift.chance},
                           {"drift_significant", s.drift.chance < significance},
                           {"potential_kJ_per_mol", s.potential},
                           {"total_kJ_per_mol", s.total},
                           {"temperature_K", s.temperatures.all},
                           {"temperature_translation_K", s.temperatures.translation},
                           {"temperature_rotation_K", s.temperatures.rotation},
                           {"freedoms_translation", s.freedoms.translation},
                           {"freedoms_rotation", s.freedoms.rotation},
                           {"pressure_bar", in_bar(s.pressure.value)},
                           {"pressure_error_bar", in_bar(s.pressure.error)},
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
                           {"threads", means.threads},
                           {"target", means.target},
                           {"files", files.all()}};
  if (s.shadow)
    report["shadow"] = {{"rms_kJ_per_mol", s.shadow->fluctuation},
                        {"drift_kJ_per_mol_ps", s.shadow->drift.rate.value},
                        {"drift_error", s.shadow->drift.rate.error},
                        {"drift_chance", s.shadow->drift.chance},
                        {"drift_significant", s.shadow->drift.chance < significance},
                        {"times_sooner", s.shadow->sooner}};
  if (s.configurational[0])
    for (const auto& known : s.configurational)
      report["temperature_configurational_K"].push_back(
          known ? nlohmann::json{{"value", known->value}, {"error", known->error}}
                : nlohmann::json());
  report["promise"] = kept ? as_json(*kept) : nlohmann::json();
  fmt::print("{}\n", report.dump(2));
}

}  // namespace polhode::cli
