// SPDX-License-Identifier: MIT
#include "io/settings/ensemble_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <variant>

#include "io/settings/quantity.hpp"
#include "io/settings/settings.hpp"
#include "polhode/io/settings/config.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

const std::vector<std::string_view> tables = {"thermostat", "barostat", "hybrid_monte_carlo"};

/// "Monte Carlo moves"
template <class... Types>
std::string title_of(const std::variant<Types...>& type) {
  return std::visit([](const auto& one) { return std::string(one.title); }, type);
}

/// The parameters of a thermostat as text, such as " with a friction of 1 1/ps". A parameter is
/// omitted if its value equals the setting that provides its default.
std::string parameters_of_thermostat(const EnsembleSettings& settings) {
  std::string text;
  std::map<std::string, std::string> values;
  for (const auto& [path, value] : ensemble_texts(settings)) {
    const Setting& one = setting(path);
    if (one.table != "thermostat" || one.by.empty()) continue;
    values["value of `" + one.key + '`'] = value;
    if (const auto same = values.find(one.fallback); same != values.end() && same->second == value)
      continue;
    std::string words = one.key;
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("{} a {} of {}", text.empty() ? " with" : " and", words, value);
  }
  return text;
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
  if (s.thermostat) text += ", " + title_of(*s.thermostat) + parameters_of_thermostat(s);
  if (s.hybrid_monte_carlo)
    text += fmt::format(", hybrid Monte Carlo with trajectories of {} steps",
                        s.hybrid_monte_carlo->steps);
  if (s.barostat)
    text += fmt::format(", {} of {} to {:.12g} bar", title_of(s.barostat->type),
                        s.barostat->edges == BarostatSettings{}.edges
                            ? "the box"
                            : "the groups of edges " + edges_text(s.barostat->edges),
                        s.barostat->pressure / unit("bar", Dimension::pressure));
  return text;
}

}  // namespace polhode
