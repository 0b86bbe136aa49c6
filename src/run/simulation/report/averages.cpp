// SPDX-License-Identifier: MIT
#include "averages.hpp"

#include <fmt/core.h>

#include <array>

#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

SeriesEstimate in_bar(const SeriesEstimate& p) { return in_unit("bar", Dimension::pressure, p); }
SeriesEstimate in_kg_per_m3(const SeriesEstimate& density) {
  return in_unit("kg/m3", Dimension::density, density);
}
SeriesEstimate in_per_bar(const SeriesEstimate& compressibility) {
  return in_unit("1/bar", Dimension::compressibility, compressibility);
}

std::string text_or_dash(double degrees_of_freedom, const SeriesEstimate& T) {
  return degrees_of_freedom == 0 ? "-" : text_of(T);
}

/// The reason why some printed temperatures have no error although the mean temperature has one;
/// empty otherwise.
std::string missing_errors(const TemperatureEstimates& T, const DegreesOfFreedom& n) {
  if (T.all.known != Known::yes) return "";
  Known worst = n.translation > 0 ? T.translation.known : Known::yes;
  for (std::size_t k = 0; k < n.rotation.size(); ++k)
    if (n.rotation[k] > 0 && T.rotation[k].known != Known::yes) worst = T.rotation[k].known;
  return worst == Known::yes ? "" : "; a missing error is " + not_known(worst);
}

/// @param label  label of the mean; @param motions labels of the temperatures by motion
Quantities of_temperatures(const TemperatureEstimates& T, const DegreesOfFreedom& n,
                           const std::string& label, const std::string& motions) {
  const auto axis = [&](std::size_t k) { return text_or_dash(n.rotation[k], T.rotation[k]); };
  return {{"temperature", "K", T.all, "mean kinetic temperature", label},
          detail(row(motions, fmt::format("translation {}, rotation {}, {}, {} K{}",
                                          text_or_dash(n.translation, T.translation), axis(0),
                                          axis(1), axis(2), missing_errors(T, n)))),
          {"temperature_translation", "K", T.translation, "mean temperature of translation"},
          {"temperature_rotation", "K", T.rotation,
           "mean temperature of rotation about each principal axis"}};
}

std::vector<std::optional<SeriesEstimate>> list_of(
    const ByMotion<std::optional<SeriesEstimate>>& motions) {
  return {motions.begin(), motions.end()};
}

Quantities of_configurational(const ByMotion<std::optional<SeriesEstimate>>& T) {
  Quantities list;
  Known worst = Known::yes;
  std::array<std::string, 4> texts;
  bool any = false;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    texts[k] = T[k] ? text_of(*T[k]) : "-";
    if (!T[k]) continue;
    any = true;
    if (T[k]->known != Known::yes) worst = T[k]->known;
  }
  if (T[0])
    list.push_back(
        {"temperature_configurational", "K", list_of(T),
         "configurational temperatures of translation and of rotation about each principal axis"});
  if (any)
    list.push_back(
        row("configurational", fmt::format("translation {}, rotation {}, {}, {} K{}", texts[0],
                                           texts[1], texts[2], texts[3], missing_error(worst))));
  return list;
}

/// A number of acceptances as text, such as "1200 of 2000 accepted, 60.0 ± 1.1 %".
std::string accepted_text(std::uint64_t some, std::uint64_t all, const SeriesEstimate& share) {
  if (all == 0) return "none yet";
  return fmt::format("{} of {} accepted, {}{}", some, all, text_of(scaled(share, 100), "%"),
                     missing_error(share.known));
}

Quantities of_barostat(const BarostatSummary& s) {
  return {
      {"density", "kg/m3", in_kg_per_m3(s.density), "mean of the total mass divided by the volume",
       "density"},
      detail({"volume", "nm3", s.volume, "mean volume", "volume"}),
      {"compressibility", "1/bar", in_per_bar(s.compressibility),
       "isothermal compressibility, from the fluctuations of the volume", "compressibility",
       ", isothermal"},
      {"volume_drift", "nm3/ps", s.volume_drift.rate.value,
       "slope of a least-squares line fitted to the volume as a function of time"},
      detail(row(
          "moves of the box",
          fmt::format("{}; one every {:g} fs", accepted_text(s.accepted, s.moves, s.accepted_share),
                      s.interval * units::fs_per_ps))),
      {"interval", "fs", s.interval * units::fs_per_ps, "time between two moves of the box"},
      {"beyond_shape", "", s.beyond_shape,
       "number of moves rejected because they would have changed the shape of the box too much"},
      {"moves", "", s.moves, "number of moves of the box"},
      {"accepted", "", s.accepted, "number of accepted moves"},
      {"acceptance", "%", s.accepted_share, "accepted fraction of the moves"},
      {"work", "kJ/mol", s.work, "work received from the barostat"}};
}

/// The effective number of independent samples of the potential energy, as text.
std::string effective_samples_text(const HybridMonteCarloSummary& s) {
  const Known known = s.effective_samples.known;
  if (known == Known::not_defined) return "not defined: the potential energy is constant";
  if (known != Known::yes) return not_known(known);
  return fmt::format("{} for the potential energy, whose autocorrelation time is {}",
                     text_of(s.effective_samples), text_of(s.correlation_time, "ps"));
}

Quantities of_hybrid_monte_carlo(const HybridMonteCarloSummary& s) {
  return {row("trajectories", accepted_text(s.accepted, s.trajectories, s.accepted_share)),
          {"trajectories", "", s.trajectories, "number of trajectories"},
          {"accepted", "", s.accepted, "number of accepted trajectories"},
          {"acceptance", "%", s.accepted_share, "accepted fraction of the trajectories"},
          {"mean_weight", "", s.weight, "mean of exp(-dH/kT), which must be 1",
           s.trajectories > 0 ? "<exp(-dH/kT)>" : "", ", which must be 1"},
          {"mean_bounded_weight", "", s.bounded_weight,
           "mean of (exp(-dH/kT) - 1) exp(-\\|dH\\|/kT), which must be 0"},
          row("effective samples", effective_samples_text(s)),
          {"correlation_time", "ps", s.correlation_time,
           "integrated autocorrelation time of the potential energy"},
          {"effective_samples", "", s.effective_samples,
           "number of independent samples whose mean potential energy would have the same standard "
           "error as this run"},
          {"work", "kJ/mol", s.work,
           "energy that the bodies received when momenta were drawn and trajectories rejected"}};
}

/// The results of thermostat, barostat and hybrid Monte Carlo; null at constant energy.
Quantities of_ensemble(const EnsembleSummary& s) {
  if (s.settings.constant_energy()) return {{"ensemble", "", {}}};
  Quantities settings;
  for (const auto& [key, value] : ensemble_texts(s.settings)) settings.push_back({key, "", value});
  Quantities list = {{"description", "", description(s.settings), "description of the ensemble"},
                     {"settings", "", settings, "settings of the ensemble, as in a run file"},
                     {"heat", "kJ/mol", s.heat, "heat received from the thermostat"}};
  Quantity barostat{"barostat", "", {}}, hybrid{"hybrid_monte_carlo", "", {}};
  if (s.barostat) barostat.value = of_barostat(*s.barostat);
  if (s.hybrid_monte_carlo) hybrid.value = of_hybrid_monte_carlo(*s.hybrid_monte_carlo);
  append(list, {barostat, hybrid});
  if (s.settings.thermostat)
    list.push_back(detail(row("heat received", fmt::format("{:.4g} kJ/mol", s.heat))));
  const double work =
      (s.barostat ? s.barostat->work : 0) + (s.hybrid_monte_carlo ? s.hybrid_monte_carlo->work : 0);
  if (s.barostat || s.hybrid_monte_carlo)
    list.push_back(detail(row("work received", fmt::format("{:.4g} kJ/mol", work))));
  return {{"ensemble", "", std::move(list)}};
}

/// An average with its time-step bias.
struct BiasedAverage {
  std::string key, unit;
  SeriesEstimate bias, average;
  std::string label, of = {};  ///< without a label, the molecules have no such average

  /// The bias, followed in the text by the average without it.
  Quantity bias_row() const {
    const std::string note = fmt::format("{}, without it {}", of, text_of(corrected()));
    return {key, unit, bias, "", label, note};
  }
  SeriesEstimate corrected() const { return without_bias(average, bias); }
};

/// The averages whose time-step bias is reported.
std::vector<BiasedAverage> biased_averages(const RunSummary& s) {
  const StepBias& bias = *s.step_bias;
  const double per_molecule = 1 / static_cast<double>(s.molecules);
  const bool turns = s.degrees_of_freedom.all() > s.degrees_of_freedom.translation;
  const auto label = [](bool shown, const char* text) { return shown ? text : ""; };
  const auto& barostat = s.ensemble.barostat;
  std::vector<BiasedAverage> list = {
      {"potential", "kJ/mol", scaled(bias.potential, per_molecule), s.potential, "potential energy",
       " per molecule"},
      {"pressure", "bar", in_bar(bias.pressure), in_bar(s.pressure), "pressure"},
      {"temperature_translation", "K", bias.translation, s.temperatures.translation,
       "T of translation"},
      {"temperature_rotation_all", "K", bias.rotation, s.temperatures.rotation_all,
       label(turns, "T of rotation")},
      {"rotation_minus_translation", "K", bias.difference, s.temperatures.difference,
       label(turns, "their difference")}};
  if (barostat)
    list.insert(list.begin() + 2, {"density", "kg/m3", in_kg_per_m3(bias.density),
                                   in_kg_per_m3(barostat->density), "density"});
  return list;
}

}  // namespace

SeriesEstimate in_unit(const char* symbol, Dimension dimension, const SeriesEstimate& estimate) {
  return scaled(estimate, 1 / unit(symbol, dimension));
}

Quantities of_warnings(const std::vector<Warning>& warnings) {
  std::vector<Quantities> list;
  Quantities rows;
  for (const Warning& w : warnings) {
    list.push_back({{"kind", "", w.kind},
                    {"value", "", w.value},
                    {"bound", "", w.bound},
                    {"text", "", w.text},
                    {"remedy", "", w.remedy}});
    rows.push_back(row(w.kind, fmt::format("{}\n-> {}", w.text, w.remedy)));
  }
  Quantities all = {{"warnings", "", list, "list of the warnings"}};
  if (!warnings.empty())
    append(all, {row("", ""),
                 {"", "", rows, "", "WARNINGS: something is probably wrong with this run"}});
  return all;
}

Quantities of_step_bias(const RunSummary& s) {
  if (!s.step_bias) return {{"step_bias", "", {}}, {"corrected", "", {}}};
  const StepBias& bias = *s.step_bias;
  const auto& barostat = s.ensemble.barostat;
  Quantities biases, corrected;
  for (const BiasedAverage& average : biased_averages(s)) {
    biases.push_back(average.bias_row());
    if (!average.label.empty())
      corrected.push_back({average.key, average.unit, average.corrected()});
  }
  if (!barostat) biases.push_back({"density", "kg/m3", in_kg_per_m3(bias.density)});
  append(biases, {{"compressibility", "1/bar", in_per_bar(bias.compressibility)},
                  {"volume", "nm3", bias.volume},
                  {"temperature_rotation", "K", bias.axes},
                  {"temperature_configurational", "K",
                   s.configurational_bias[0] ? Value(list_of(s.configurational_bias)) : Value()}});
  Quantities all = {{"step_bias", "", std::move(biases),
                     "time-step bias of each average; null if unknown", "time-step bias"},
                    {"corrected", "", std::move(corrected),
                     "averages without their time-step bias; their errors include the error of the "
                     "bias, and are null if the bias is unknown"}};
  Quantities others;
  const auto add = [&](const char* unit, const SeriesEstimate& of, const SeriesEstimate& average,
                       const char* label) {
    others.push_back(BiasedAverage{"", unit, of, average, label}.bias_row());
  };
  if (barostat)
    add("1/bar", in_per_bar(bias.compressibility), in_per_bar(barostat->compressibility),
        "compressibility");
  constexpr std::array names{"T_conf, translation", "T_conf, axis 1", "T_conf, axis 2",
                             "T_conf, axis 3"};
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const auto& known = s.configurational_bias[k])
      add("K", *known, *s.configurational[k], names[k]);
  if (!others.empty())
    all.push_back(detail({"", "", std::move(others), "", "other time-step biases"}));
  return all;
}

Quantities of_averages(const RunSummary& s) {
  const DegreesOfFreedom& n = s.degrees_of_freedom;
  Quantities list = {{"potential", "kJ/mol", s.potential, "mean potential energy per molecule",
                      "potential energy", " per molecule"},
                     detail({"total", "kJ/mol", s.total, "mean total energy per molecule",
                             "total energy", " per molecule"})};
  append(list, of_temperatures(s.temperatures, n, "temperature", "temperatures"));
  if (s.temperatures_at_bath) {
    Quantities half =
        of_temperatures(*s.temperatures_at_bath, n, "  of half steps", "  of half steps");
    list.push_back(
        {"half_steps", "", flattened(half),
         "temperatures of the half-step momenta, on which a bath within the steps acts"});
    half.front().key.clear();
    append(list, {half[0], half[1]});
  }
  append(list, of_configurational(s.configurational));
  const auto& barostat = s.ensemble.settings.barostat;
  append(
      list,
      {detail(row("degrees of freedom",
                  fmt::format("{:.0f}: translation {:.0f}, rotation {:.0f} {:.0f} {:.0f}", n.all(),
                              n.translation, n.rotation[0], n.rotation[1], n.rotation[2]))),
       {"degrees_of_freedom_translation", "", n.translation,
        "number of degrees of freedom of translation"},
       {"degrees_of_freedom_rotation", "", std::vector(n.rotation.begin(), n.rotation.end()),
        "number of degrees of freedom of rotation about each principal axis"},
       {"pressure", "bar", in_bar(s.pressure), "mean molecular pressure", "pressure",
        barostat ? fmt::format(", requested: {:g} bar",
                               barostat->pressure / unit("bar", Dimension::pressure))
                 : ""}});
  append(list, of_ensemble(s.ensemble));
  list.push_back(detail({"equilibrium_start", "ps", s.equilibrium_start,
                         "time after which the potential energy and the volume are stationary, "
                         "with a resolution of a twentieth of the run",
                         "equilibrium from"}));
  list.push_back(detail({"momentum", "", s.momentum, "sum of all momenta at the end [u nm/ps]",
                         "total momentum", " u nm/ps"}));
  return list;
}

}  // namespace polhode
