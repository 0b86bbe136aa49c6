// SPDX-License-Identifier: MIT
#include "criterion_options.hpp"

#include <fmt/core.h>

#include "polhode/base/error.hpp"
#include "polhode/io/config.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode::cli {
namespace {

double fraction_option(const std::string& text, const std::string& option) {
  const double value = quantity(text, Dimension::fraction, option);
  if (const std::string wrong = wrong_bound(value); !wrong.empty())
    throw Error(fmt::format("{} = \"{}\" {}", option, text, wrong));
  return value;
}

}  // namespace

void CriterionOptions::declare(Command& command) {
  const CommandOption ratio =
      command.add_option("--accuracy", accuracy, "largest R of a run: \"0.5 %\"");
  const CommandOption rate =
      command.add_option("--drift", drift, "largest energy drift per molecule: \"0.1 kJ/mol/ns\"");
  command
      .add_option(
          "--temperature-bias", temperature_bias,
          "largest difference between the temperatures of translation and rotation: \"0.5 %\"")
      .excludes(ratio)
      .excludes(rate);
  rate.excludes(ratio);
}

Criterion criterion_option(const CriterionOptions& o, const IntegratorSettings& integrator) {
  if (!o.drift.empty()) {
    const double drift = quantity(o.drift, Dimension::power, "--drift");
    if (!(drift > 0))
      throw Error(fmt::format("--drift = \"{}\" must be above 0 kJ/mol/ns", o.drift));
    return {Quality::drift, drift};
  }
  if (!o.temperature_bias.empty())
    return {Quality::temperature_bias, fraction_option(o.temperature_bias, "--temperature-bias")};
  if (!o.accuracy.empty()) return {Quality::ratio, fraction_option(o.accuracy, "--accuracy")};
  if (integrator.accuracy) return {Quality::ratio, *integrator.accuracy};
  throw Error(
      "no accuracy is requested; give --accuracy \"0.5 %\", --drift \"0.1 kJ/mol/ns\" or "
      "--temperature-bias \"0.5 %\"");
}

}  // namespace polhode::cli
