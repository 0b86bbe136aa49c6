// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/guarantee.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/output_error.hpp"
#include "io/files/with_error.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/quantity.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/adviser/adviser.hpp"
#include "run/adviser/advice_report.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

/// Rejects a resumed run if the required accuracy differs from the accuracy for which the step was
/// chosen.
void check_same(const std::string& file, const char* key, const std::string& then,
                const std::string& now) {
  if (then == now) return;
  throw OutputError(fmt::format(
      "the run was started with {0} = {1}, and its step was chosen for this accuracy ('{3}'), but "
      "{0} is now {2}; restore the earlier value, give another output, or start over",
      key, then, now, file));
}

}  // namespace

std::optional<Guarantee> choose_guaranteed_step(Config& config, const Callbacks& callbacks,
                                                Workers& workers) {
  IntegratorSettings& integrator = config.integrator;
  AdviserSettings settings{criterion_of(integrator.accuracy.value(), config.ensemble),
                           integrator.candidates};
  if (config.gives("integrator.scheme")) settings.schemes = {integrator.scheme};
  callbacks.note(fmt::format("choosing a step for {}", description(settings.criterion)));
  check_not_processed(config, "the adviser");
  note_constant_energy(config, "the choice of the step", callbacks);
  Callbacks renamed = callbacks;
  if (callbacks.progress)
    renamed.progress = [&](Progress now) {
      now.job = "choosing the step";
      callbacks.progress(now);
    };
  const Advice advice = advise(config, settings, renamed, workers);
  if (advice.stopped) return std::nullopt;
  if (!advice.best) throw RunError(unreachable(advice, settings.criterion));
  const AdviserPoint& point = advice.confirmation;
  integrator.scheme = named_text_of(advice.candidates[*advice.best].scheme);
  integrator.step = point.step;
  callbacks.note(fmt::format("for {}: {}", description(settings.criterion), answer(advice)));
  return Guarantee{*integrator.accuracy, point.length, point.ratio()};
}

void write_guarantee(const std::string& file, const Guarantee& guarantee,
                     const IntegratorSettings& integrator) {
  const nlohmann::json json{
      {"accuracy", text_of(guarantee.accuracy)}, {"length_ps", guarantee.length},
      {"R_expected", guarantee.expected.value},  {"R_expected_error", guarantee.expected.error},
      {"scheme", integrator.scheme.text},        {"step_ps", integrator.step}};
  write_file(file, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

Guarantee read_guarantee(const std::string& file, Config& config) try {
  IntegratorSettings& integrator = config.integrator;
  const auto json = nlohmann::json::parse(std::ifstream(file));
  const auto quoted = [](const std::string& text) { return '"' + text + '"'; };
  check_same(file, "accuracy", quoted(json.at("accuracy").get<std::string>()),
             quoted(text_of(integrator.accuracy.value())));
  const NamedScheme chosen = json.at("scheme").get<std::string>();
  if (config.gives("integrator.scheme"))
    check_same(file, "scheme", text_of(chosen), text_of(integrator.scheme));
  integrator.scheme = chosen;
  integrator.step = json.at("step_ps");
  return {*integrator.accuracy,
          json.at("length_ps"),
          {json.at("R_expected"), json.at("R_expected_error")}};
} catch (const nlohmann::json::exception& e) {
  throw OutputError(
      fmt::format("'{}' does not contain the accuracy guarantee of the run to be resumed ({}); "
                  "restore the file, or start over",
                  file, e.what()));
}

std::optional<GuaranteeCheck> check_guarantee(const Guarantee& guarantee,
                                              const TrajectoryStatistics& statistics,
                                              const RunSummary& summary) {
  const auto check = [&](const SeriesEstimate& bias, double unit) {
    return GuaranteeCheck{guarantee, {bias.value / unit, bias.error / std::abs(unit)}};
  };
  const bool constant_energy = summary.ensemble.settings.constant_energy();
  if (guarantee.accuracy.of != RequiredOf::ratio && !summary.step_bias) return std::nullopt;
  switch (guarantee.accuracy.of) {
    case RequiredOf::ratio: {
      if (!constant_energy) return std::nullopt;
      const std::optional<Estimate> parts = statistics.stretches.ratio();
      return parts ? GuaranteeCheck{guarantee, *parts} : check(summary.ratio, 1);
    }
    case RequiredOf::temperature_difference:
      return check(summary.step_bias->difference, 1);
    case RequiredOf::energy:
      return check(summary.step_bias->potential, static_cast<double>(summary.molecules));
    case RequiredOf::pressure:
      if (const auto& barostat = summary.ensemble.barostat)  // pressure bias to which the volume
                                                             // has responded
        return check(summary.step_bias->volume,
                     barostat->compressibility.value * barostat->volume.value);
      return check(summary.step_bias->pressure, 1);
    case RequiredOf::density:
      if (summary.ensemble.barostat)
        return check(summary.step_bias->volume, -summary.ensemble.barostat->volume.value);
  }
  return std::nullopt;
}

std::string guarantee_text(const GuaranteeCheck& k) {
  const auto text = [&](const char* name, double unit, const char* unit_text) {
    return fmt::format("{} {} {}", name, with_error(k.value.value / unit, k.value.error / unit),
                       unit_text);
  };
  const auto found = [&]() -> std::string {
    switch (k.guarantee.accuracy.of) {
      case RequiredOf::ratio:
        return fmt::format("{} over {:.3g} ps", text("R =", 0.01, "%"), k.guarantee.length);
      case RequiredOf::temperature_difference:
        return text("bias of T_rot - T_trans", 1, "K");
      case RequiredOf::energy:
        return text("bias of the potential energy", 1, "kJ/mol per molecule");
      case RequiredOf::pressure:
        return text("bias of the pressure", unit("bar", Dimension::pressure), "bar");
      case RequiredOf::density:
        return text("bias of the density", 0.01, "%");
    }
    return "";
  };
  return fmt::format("{}; the accuracy guarantee is {}", found(), text_of(k.guarantee.accuracy));
}

}  // namespace polhode
