// SPDX-License-Identifier: MIT
#include "ensemble_options.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/suggest.hpp"
#include "io/settings/ensemble_names.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"

namespace polhode::cli {
namespace {

constexpr auto none = "none";

template <class Variant>
void set_named(Variant& type, const std::string& name, const char* option) {
  const auto& names = type_names<Variant>;
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Error(fmt::format("{} = \"{}\" {}", option, name, must_be_one_of(names, name)));
  set_type(type, name);
}

void set_thermostat(EnsembleSettings& ensemble, const std::string& kind) {
  if (kind.empty()) return;
  if (kind == none) return ensemble.thermostat.reset();
  if (!ensemble.thermostat) ensemble.thermostat.emplace();
  set_named(*ensemble.thermostat, kind, "--thermostat");
}

/// The thermostat that an option belongs to.
ThermostatSettings& thermostat_of(EnsembleSettings& ensemble, bool langevin, const char* option) {
  if (!ensemble.thermostat)
    throw Error(
        fmt::format("{} belongs to a thermostat, and this run has none; add --thermostat {}",
                    option, langevin ? "langevin" : "rescaling"));
  if (std::holds_alternative<Langevin>(*ensemble.thermostat) != langevin)
    throw Error(
        fmt::format("{} has no meaning for the thermostat {}; leave it out, or add "
                    "--thermostat {}",
                    option, type_name(*ensemble.thermostat), langevin ? "langevin" : "rescaling"));
  return *ensemble.thermostat;
}

void set_friction(EnsembleSettings& ensemble, const std::string& text) {
  if (text.empty()) return;
  ThermostatSettings& thermostat = thermostat_of(ensemble, true, "--friction");
  const double rate = quantity(text, Dimension::rate, "--friction", "1 1/ps");
  if (const std::string wrong = wrong_friction(rate); !wrong.empty())
    throw Error(fmt::format("--friction = \"{}\" {}", text, wrong));
  thermostat = Langevin{rate, rate};
}

void set_barostat(EnsembleSettings& ensemble, const std::string& kind,
                  const std::string& pressure) {
  if (kind == none) {
    if (!pressure.empty()) throw Error("--pressure contradicts --barostat none; give one of them");
    return ensemble.barostat.reset();
  }
  if (kind.empty() && pressure.empty()) return;
  if (!ensemble.barostat && pressure.empty())
    throw Error(
        fmt::format("--barostat {} has no pressure to keep; add --pressure \"1 bar\"", kind));
  if (!ensemble.barostat) ensemble.barostat = default_barostat();
  if (!kind.empty()) set_named(ensemble.barostat->type, kind, "--barostat");
  if (!pressure.empty())
    ensemble.barostat->pressure = quantity(pressure, Dimension::pressure, "--pressure", "1 bar");
}

void set_hybrid(EnsembleSettings& ensemble, const std::string& text) {
  if (text.empty()) return;
  const std::size_t steps = whole_number(text, "--hybrid-steps", max_hybrid_steps,
                                         "5 to 50 are usual, and 0 means no hybrid Monte Carlo");
  if (steps == 0) return ensemble.hybrid_monte_carlo.reset();
  if (!ensemble.hybrid_monte_carlo) ensemble.hybrid_monte_carlo.emplace();
  ensemble.hybrid_monte_carlo->steps = steps;
}

}  // namespace

void EnsembleOptions::declare(Command& command) {
  command.add_option("--thermostat", thermostat,
                     "langevin, rescaling, separate-rescaling or none; default: the run file's");
  command.add_option("--friction", friction,
                     "of the Langevin thermostat: \"1 1/ps\"; default: the run file's");
  command.add_option("--time-constant", time_constant,
                     "of rescaling thermostats: \"0.5 ps\"; default: the run file's");
  command.add_option("--barostat", barostat,
                     "cell-rescaling, monte-carlo or none; default: the run file's");
  command.add_option("--pressure", pressure,
                     "of the barostat: \"1 bar\"; default: the run file's. Without a barostat, "
                     "cell-rescaling, and without a thermostat, langevin");
  command.add_option("--hybrid-steps", hybrid_steps,
                     "steps of each trajectory of hybrid Monte Carlo, 0: none; default: the run "
                     "file's");
}

std::vector<std::string> EnsembleOptions::apply(Config& config) const {
  EnsembleSettings& ensemble = config.ensemble;
  std::vector<std::string> notes;
  const bool had_barostat = ensemble.barostat.has_value();
  set_hybrid(ensemble, hybrid_steps);
  set_thermostat(ensemble, thermostat);
  set_barostat(ensemble, barostat, pressure);
  if (ensemble.barostat && !had_barostat && barostat.empty())
    notes.push_back("note: --pressure without a barostat selects cell-rescaling");
  if (!pressure.empty() && thermostat.empty() && !ensemble.thermostat &&
      !ensemble.hybrid_monte_carlo) {
    ensemble.thermostat.emplace();
    notes.push_back("note: --pressure without a thermostat selects langevin");
  }
  set_friction(ensemble, friction);
  if (!time_constant.empty())
    std::visit(
        [&](auto& type) {
          if constexpr (requires { type.time_constant; })
            type.time_constant = positive_time(time_constant, "--time-constant");
        },
        thermostat_of(ensemble, false, "--time-constant"));
  if (thermostat == none)
    if (const std::string wrong = wrong_temperature(config); !wrong.empty())
      throw Error(fmt::format("--thermostat none: the temperature {}", wrong));
  return notes;
}

}  // namespace polhode::cli
