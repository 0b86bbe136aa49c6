// SPDX-License-Identifier: MIT
#include "criterion_options.hpp"

#include <fmt/core.h>

#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/config.hpp"

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
  const CommandOption temperatures = command.add_option(
      "--temperature-bias", temperature_bias,
      "largest difference between the temperatures of translation and rotation: \"0.5 %\"");
  temperatures.excludes(ratio).excludes(rate);
  rate.excludes(ratio);
  command
      .add_option("--bias", bias,
                  "largest bias of an average by the step: \"0.1 K\" of T_rot - T_trans, \"energy "
                  "0.01 kJ/mol\", \"pressure 4 bar\", \"density 0.02 %\"")
      .excludes(ratio)
      .excludes(rate)
      .excludes(temperatures);
}

Criterion criterion_option(const CriterionOptions& o, const Config& config) {
  if (!o.bias.empty()) return criterion_of(required_bias(o.bias, "--bias"), config.ensemble);
  if (!o.drift.empty()) {
    const double drift = quantity(o.drift, Dimension::power, "--drift");
    if (!(drift > 0))
      throw Error(fmt::format("--drift = \"{}\" must be above 0 kJ/mol/ns", o.drift));
    return {Quality::drift, drift};
  }
  if (!o.temperature_bias.empty())
    return {Quality::temperature_bias, fraction_option(o.temperature_bias, "--temperature-bias")};
  if (!o.accuracy.empty()) return {Quality::ratio, fraction_option(o.accuracy, "--accuracy")};
  if (config.integrator.accuracy) return criterion_of(*config.integrator.accuracy, config.ensemble);
  throw Error(
      "no accuracy is requested; give --accuracy \"0.5 %\", --drift \"0.1 kJ/mol/ns\", "
      "--temperature-bias \"0.5 %\" or --bias \"0.1 K\"");
}

}  // namespace polhode::cli
