// SPDX-License-Identifier: MIT
#include "io/settings/ensemble_text.hpp"

#include <fmt/core.h>

#include "io/settings/quantity.hpp"
#include "io/settings/settings.hpp"
#include "polhode/io/settings/config.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

const std::vector<std::string_view> tables = {"thermostat", "barostat", "hybrid_monte_carlo"};

std::string in_ps(double time) { return fmt::format("{:.12g} ps", time); }
std::string in_bar(double pressure) {
  return fmt::format("{:.12g} bar", pressure / unit("bar", Dimension::pressure));
}
std::string per_ps(double rate) { return fmt::format("{:.12g} 1/ps", rate); }

std::string text_of(const Langevin& type) {
  const std::string rotation =
      type.rotational_friction == type.friction
          ? ""
          : fmt::format(" ({} for rotation)", per_ps(type.rotational_friction));
  return fmt::format("Langevin thermostat with a friction of {}{}", per_ps(type.friction),
                     rotation);
}
std::string text_of(const Rescaling& type) {
  return fmt::format("stochastic velocity rescaling with a time constant of {}",
                     in_ps(type.time_constant));
}
std::string text_of(const SeparateRescaling& type) {
  return fmt::format(
      "separate stochastic velocity rescaling of translation and rotation with a time constant of "
      "{}",
      in_ps(type.time_constant));
}
std::string text_of(const CellRescaling&) { return "stochastic cell rescaling"; }
std::string text_of(const VolumeMoves&) { return "Monte Carlo moves"; }

template <class Variant>
std::string text_of_type(const Variant& type) {
  return std::visit([](const auto& one) { return text_of(one); }, type);
}

}  // namespace

std::string edges_text(const std::vector<CoupledEdges>& groups) {
  std::string text;
  for (const CoupledEdges& edges : groups) {
    if (!text.empty()) text += ' ';
    for (std::size_t k = 0; k < 3; ++k)
      if (edges[k]) text += "xyz"[k];
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> ensemble_texts(const EnsembleSettings& settings) {
  Config config = defaults();
  config.ensemble = settings;
  return recorded_settings(config, tables);
}

std::string wrong_setting(const EnsembleSettings& settings) {
  Config config = defaults();
  config.ensemble = settings;
  for (const std::string_view table : tables)
    for (const SettingRow& row : setting_table(table).rows)
      if (const std::string wrong = wrong_value(row, config); !wrong.empty())
        return fmt::format("{}.{} = {} {}", table, row.key, text_of(row, config), wrong);
  return "";
}

std::string description(const EnsembleSettings& s) {
  if (s.constant_energy()) return "constant energy";
  std::string text = fmt::format("{:g} K", s.temperature);
  if (s.thermostat) text += ", " + text_of_type(*s.thermostat);
  if (s.hybrid_monte_carlo)
    text += fmt::format(", hybrid Monte Carlo with trajectories of {} steps",
                        s.hybrid_monte_carlo->steps);
  if (s.barostat)
    text += fmt::format(", {} of the box to {}", text_of_type(s.barostat->type),
                        in_bar(s.barostat->pressure));
  return text;
}

}  // namespace polhode
