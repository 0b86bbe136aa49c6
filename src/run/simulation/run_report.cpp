// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/run_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "polhode/io/ensemble_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode {
namespace {

using nlohmann::json;

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

/// A number if it is known.
json number_if(bool known, double value) {
  return known && std::isfinite(value) ? json(value) : json();
}

/// Keys of an energy drift; error, p-value and significance are null if they are not known, and the
/// verdict gives the reason.
json drift_json(const Drift& drift, std::uint64_t samples) {
  const bool known = drift.known == Known::yes;
  return {{"drift_kJ_per_mol_ps", number_if(samples >= min_samples_reported, drift.rate.value)},
          {"drift_error", number_if(known, drift.rate.error)},
          {"drift_p_value", number_if(known, drift.p_value)},
          {"drift_significant", known ? json(drift.significant()) : json()},
          {"drift_verdict", verdict(drift)}};
}

/// The size of the energy drift, and the random walk; null if they are not known.
json walk_json(const RunSummary& s) {
  const bool known = s.samples >= min_samples_reported && s.potential_fluctuation.value > 0;
  const double n = s.degrees_of_freedom.all(), kT = units::boltzmann * s.temperatures.all.value;
  return {{"drift_in_run_over_rms_potential", number_if(known, s.relative_drift())},
          {"drift_kT_per_ns_per_degree_of_freedom",
           number_if(known && n > 0, s.drift.rate.value * units::ps_per_ns / (kT * n))},
          {"random_walk_kJ_per_mol_per_sqrt_ps", number_if(s.walk > 0, std::sqrt(s.walk))},
          {"R_of_random_walk", number_if(s.walk > 0, s.ratio_of_walk())}};
}

/// A value with its error, in this unit; each null if it is not known, with the reason.
json estimate_json(const SeriesEstimate& e, double unit) {
  json report{{"value", number_if(true, e.value / unit)},
              {"error", number_if(e.known == Known::yes, e.error / unit)}};
  if (e.known != Known::yes) report["error_not_known"] = reason(e.known);
  return report;
}

/// Keys of averages, each followed by its error, and why errors are not known.
class Averages {
 public:
  /// "temperature_K" and "temperature_error_K".
  void add(const std::string& name, const std::string& unit, const SeriesEstimate& e) {
    put(name + "_" + unit, name + "_error_" + unit, e);
  }
  void put(const std::string& key, const std::string& error_key, const SeriesEstimate& e) {
    report_[key] = number_if(true, e.value);
    report_[error_key] = number_if(e.known == Known::yes, e.error);
    if (e.known != Known::yes) reasons_[error_key] = reason(e.known);
  }
  void add(const TemperatureEstimates& T) {
    add("temperature", "K", T.all);
    add("temperature_translation", "K", T.translation);
    json values = json::array(), errors = json::array();
    for (const SeriesEstimate& axis : T.rotation) {
      values.push_back(number_if(true, axis.value));
      errors.push_back(number_if(axis.known == Known::yes, axis.error));
      if (axis.known != Known::yes) reasons_["temperature_rotation_error_K"] = reason(axis.known);
    }
    report_["temperature_rotation_K"] = values;
    report_["temperature_rotation_error_K"] = errors;
  }
  json json_report() const {
    json all = report_;
    all["errors_not_known"] = reasons_;
    return all;
  }

 private:
  json report_ = json::object(), reasons_ = json::object();
};

/// Null where it is not known.
json step_bias_json(const RunSummary& s) {
  if (!s.step_bias) return {};
  const StepBias& bias = *s.step_bias;
  json axes = json::array(), configurational;
  for (const SeriesEstimate& axis : bias.axes) axes.push_back(estimate_json(axis, 1));
  if (s.configurational_bias[0])
    for (const auto& known : s.configurational_bias)
      configurational.push_back(known ? estimate_json(*known, 1) : json());
  return {{"temperature_translation_K", estimate_json(bias.translation, 1)},
          {"temperature_rotation_all_K", estimate_json(bias.rotation, 1)},
          {"temperature_rotation_K", axes},
          {"rotation_minus_translation_K", estimate_json(bias.difference, 1)},
          {"potential_kJ_per_mol", estimate_json(bias.potential, static_cast<double>(s.molecules))},
          {"pressure_bar", estimate_json(bias.pressure, unit("bar", Dimension::pressure))},
          {"volume_nm3", estimate_json(bias.volume, 1)},
          {"density_kg_per_m3", estimate_json(bias.density, unit("kg/m3", Dimension::density))},
          {"compressibility_per_bar",
           estimate_json(bias.compressibility, unit("1/bar", Dimension::compressibility))},
          {"temperature_configurational_K", configurational}};
}

json segment_json(const Segment& s) {
  return {{"number", s.number},
          {"first_step", s.first_step},
          {"earlier_ps", s.earlier},
          {"changes", s.changes.empty() ? json() : json(s.changes)}};
}

json run_settings(const RunReport& r) {
  const RunSummary& s = r.summary;
  return {{"molecules", s.molecules},
          {"scheme", name_of({r.settings.scheme, r.settings.inner})},
          {"text", text_of({r.settings.scheme, r.settings.inner})},
          {"step_fs", r.settings.step * units::fs_per_ps},
          {"steps", s.steps},
          {"length_ps", s.length},
          {"sample_fs", s.sample * units::fs_per_ps},
          {"interrupted", r.interrupted},
          {"samples", s.samples},
          {"segment", segment_json(s.segment)},
          {"files", r.files.all()}};
}

json energies_json(const RunSummary& s) {
  Averages averages;
  averages.put("R", "R_error", s.ratio);
  averages.add("rms_total", "kJ_per_mol", s.total_fluctuation);
  averages.add("rms_potential", "kJ_per_mol", s.potential_fluctuation);
  averages.add("potential", "kJ_per_mol", s.potential);
  averages.add("total", "kJ_per_mol", s.total);
  averages.add(s.temperatures);
  averages.add("pressure", "bar", scaled(s.pressure, in_bar(1)));
  json report = averages.json_report();
  if (s.samples < min_samples_reported) report["R"] = json();
  report.update({{"R_rounding", number_if(true, s.rounding)},
                 {"R_truncation", number_if(true, s.truncation)},
                 {"degrees_of_freedom_translation", s.degrees_of_freedom.translation},
                 {"degrees_of_freedom_rotation", s.degrees_of_freedom.rotation},
                 {"momentum", s.momentum},
                 {"walk_of_rounding_known", s.walk_known}});
  return report;
}

json half_steps_json(const TemperatureEstimates& T) {
  Averages averages;
  averages.add(T);
  return averages.json_report();
}

json costs_json(const RunReport& r) {
  const RunSummary& s = r.summary;
  return {
      {"force_evaluations", s.force_evaluations},
      {"derivative_evaluations", s.derivatives},
      {"near_evaluations", s.near_evaluations},
      {"near_derivative_evaluations", s.near_derivatives},
      {"force_evaluations_for_energies", s.measurements},
      {"force_evaluations_of_moves", s.ensemble.barostat ? s.ensemble.barostat->evaluations : 0},
      {"force_evaluations_of_minimisation", s.minimisation_evaluations},
      {"list_rebuilds", s.list_rebuilds},
      {"seconds",
       {{"all", s.timings.all()},
        {"forces", s.timings.forces},
        {"near", s.timings.near},
        {"list", s.timings.list},
        {"motion", s.timings.motion},
        {"energies_and_output", s.timings.measurement}}},
      {"ns_per_day", s.ns_per_day},
      {"threads", r.execution.threads},
      {"instruction_set", r.execution.instruction_set}};
}

json shadow_json(const ShadowSummary& shadow) {
  json report = drift_json(shadow.drift, shadow.samples);
  report["random_walk_kJ_per_mol_per_sqrt_ps"] =
      number_if(shadow.drift.walk > 0, std::sqrt(shadow.drift.walk));
  report["samples"] = shadow.samples;
  const SeriesEstimate& rms = shadow.fluctuation;
  report["rms_kJ_per_mol"] = rms.value;
  report["rms_error_kJ_per_mol"] = number_if(rms.known == Known::yes, rms.error);
  if (rms.known != Known::yes) report["error_not_known"] = reason(rms.known);
  report["time_gain"] = shadow.time_gain ? json(*shadow.time_gain) : json();
  return report;
}

json barostat_json(const BarostatSummary& s) {
  return {{"density_kg_per_m3", estimate_json(s.density, unit("kg/m3", Dimension::density))},
          {"volume_nm3", estimate_json(s.volume, 1)},
          {"compressibility_per_bar",
           estimate_json(s.compressibility, unit("1/bar", Dimension::compressibility))},
          {"volume_drift_nm3_per_ps", number_if(true, s.volume_drift.rate.value)},
          {"interval_fs", s.interval * units::fs_per_ps},
          {"beyond_shape", s.beyond_shape},
          {"moves", s.moves},
          {"accepted", s.accepted},
          {"acceptance", estimate_json(s.accepted_share, 1)},
          {"work_kJ_per_mol", s.work}};
}

json hybrid_monte_carlo_json(const HybridMonteCarloSummary& s) {
  return {{"trajectories", s.trajectories},
          {"accepted", s.accepted},
          {"acceptance", estimate_json(s.accepted_share, 1)},
          {"mean_weight", estimate_json(s.weight, 1)},
          {"mean_bounded_weight", estimate_json(s.bounded_weight, 1)},
          {"correlation_time_ps", estimate_json(s.correlation_time, 1)},
          {"effective_samples", estimate_json(s.effective_samples, 1)},
          {"work_kJ_per_mol", s.work}};
}

/// Null at constant energy.
json ensemble_json(const EnsembleSummary& s) {
  if (s.settings.constant_energy()) return {};
  json report{{"description", description(s.settings)},
              {"heat_kJ_per_mol", s.heat},
              {"barostat", s.barostat ? barostat_json(*s.barostat) : json()},
              {"hybrid_monte_carlo",
               s.hybrid_monte_carlo ? hybrid_monte_carlo_json(*s.hybrid_monte_carlo) : json()}};
  for (const auto& [key, value] : ensemble_texts(s.settings)) report["settings"][key] = value;
  return report;
}

json warnings_json(const std::vector<Warning>& warnings) {
  json list = json::array();
  for (const Warning& w : warnings)
    list.push_back({{"kind", w.kind},
                    {"value", w.value},
                    {"bound", w.bound},
                    {"text", w.text},
                    {"remedy", w.remedy}});
  return list;
}

json guarantee_json(const std::optional<GuaranteeCheck>& k) {
  if (!k) return {};
  json report{{"accuracy", k->guarantee.accuracy.bound},
              {"requested", text_of(k->guarantee.accuracy)},
              {"length_ps", k->guarantee.length},
              {"R_expected", k->guarantee.expected.value},
              {"met", k->met()}};
  const bool ratio = k->guarantee.accuracy.of == RequiredOf::ratio;
  report[ratio ? "R" : "bias"] = k->value.value;
  report[ratio ? "R_error" : "bias_error"] = k->value.error;
  return report;
}

}  // namespace

std::string verdict(const Drift& drift) {
  if (drift.known != Known::yes) return reason(drift.known);
  return drift.significant() ? "significant" : "not significant";
}

std::string reason(Known known) {
  switch (known) {
    case Known::yes:
      return "";
    case Known::too_few_samples:
      return "too few samples";
    case Known::too_short:
      return "run too short";
    case Known::not_defined:
      return "not defined";
    case Known::grows:
      return "grows with the length of the run";
  }
  return "";
}

std::string run_json(const RunReport& r) {
  json report = run_settings(r);
  report.update(energies_json(r.summary));
  report.update(costs_json(r));
  report.update(drift_json(r.summary.drift, r.summary.samples));
  report.update(walk_json(r.summary));
  report["step_bias"] = step_bias_json(r.summary);
  report["ensemble"] = ensemble_json(r.summary.ensemble);
  if (r.summary.shadow) report["shadow"] = shadow_json(*r.summary.shadow);
  if (const auto& T = r.summary.temperatures_at_bath) report["half_steps"] = half_steps_json(*T);
  if (r.summary.configurational[0])
    for (const auto& known : r.summary.configurational)
      report["temperature_configurational_K"].push_back(known ? estimate_json(*known, 1) : json());
  report["warnings"] = warnings_json(r.warnings);
  report["guarantee"] = guarantee_json(r.guarantee);
  return report.dump(2);
}

}  // namespace polhode
