// SPDX-License-Identifier: MIT
// The tables [thermostat], [barostat] and [hybrid_monte_carlo] of a run file.
#include <fmt/core.h>

#include <cmath>

#include "config_tables.hpp"
#include "io/settings/ensemble_names.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr double max_rate = 1e6;  // [1/ps]: new momenta in every step

void take_rate(TomlTable& table, std::string_view key, double& rate) {
  take(rate, table.quantity(key, Dimension::rate));
  if (const std::string wrong = wrong_friction(rate); !wrong.empty()) table.refuse(key, wrong);
}

void refuse_without(TomlTable& table, bool has_meaning, std::string_view key,
                    std::string_view type) {
  table.require(has_meaning || !table.has(key), key,
                fmt::format("has a meaning for type = \"{}\" only; leave it out", type));
}

/// "xy" as the edges x and y.
CoupledEdges edges_of(const std::string& text, const TomlTable& table) {
  CoupledEdges edges{};
  for (const char c : text) {
    const bool known = c >= 'x' && c <= 'z' && !edges[static_cast<std::size_t>(c - 'x')];
    table.require(
        known, "edges",
        fmt::format("has \"{}\", which is not one or more of x, y and z; write for example "
                    "[\"xyz\"], or [\"xy\", \"z\"]",
                    text));
    edges[static_cast<std::size_t>(c - 'x')] = true;
  }
  table.require(!text.empty(), "edges", "has an empty group; write for example [\"xyz\"]");
  return edges;
}

void take_edges(TomlTable& table, std::vector<CoupledEdges>& groups) {
  const auto texts = table.texts("edges");
  if (!texts) return;
  groups.clear();
  CoupledEdges used{};
  for (const std::string& text : *texts) {
    const CoupledEdges edges = edges_of(text, table);
    for (std::size_t k = 0; k < 3; ++k) {
      table.require(!(used[k] && edges[k]), "edges",
                    "has an edge in two groups; each belongs to one group at most");
      used[k] = used[k] || edges[k];
    }
    groups.push_back(edges);
  }
  table.require(!groups.empty(), "edges", "must name at least one group, for example \"xyz\"");
}

}  // namespace

std::string wrong_friction(double rate) {
  return rate >= 0 && rate <= max_rate
             ? ""
             : "must be 0 1/ps or more, and at most 1e6 1/ps; 0.1 to 10 1/ps are usual";
}

ThermostatSettings read_thermostat(TomlTable table) {
  ThermostatSettings settings;
  settings.kind = one_of(table, "type", settings.kind);
  const bool langevin = settings.kind == ThermostatKind::langevin;
  refuse_without(table, langevin, "friction", "langevin");
  refuse_without(table, langevin, "rotational_friction", "langevin");
  refuse_without(table, !langevin, "time_constant", "rescaling");
  take_rate(table, "friction", settings.friction);
  settings.rotational_friction = settings.friction;
  take_rate(table, "rotational_friction", settings.rotational_friction);
  take_time(table, "time_constant", settings.time_constant, "0.5 ps");
  table.require(settings.time_constant > 0 && std::isfinite(settings.time_constant),
                "time_constant", "must be longer than 0 ps; 0.1 to 1 ps are usual");
  table.refuse_unknown();
  return settings;
}

BarostatSettings read_barostat(TomlTable table) {
  BarostatSettings settings = default_barostat();
  settings.kind = one_of(table, "type", settings.kind);
  const auto pressure = table.quantity("pressure", Dimension::pressure, "1 bar");
  table.require(pressure.has_value(), "",
                "there is no pressure to keep; write for example pressure = \"1 bar\"");
  settings.pressure = *pressure;
  const bool rescaling = settings.kind == BarostatKind::cell_rescaling;
  refuse_without(table, rescaling, "time_constant", "cell-rescaling");
  refuse_without(table, rescaling, "metropolis", "cell-rescaling");
  take_time(table, "time_constant", settings.time_constant, "2 ps");
  table.require(settings.time_constant > 0 && std::isfinite(settings.time_constant),
                "time_constant", "must be longer than 0 ps; 1 to 10 ps are usual");
  take(settings.compressibility, table.quantity("compressibility", Dimension::compressibility));
  table.require(settings.compressibility >= min_compressibility() &&
                    settings.compressibility <= max_compressibility(),
                "compressibility",
                "must be from 1e-7 1/bar, which solids have, to 10 1/bar, which a thin gas has; "
                "liquids have 2e-5 to 2e-4 1/bar (water 4.5e-5), a gas has 1/pressure");
  take_time(table, "every", settings.every, "0.1 ps");
  table.require(settings.every > 0, "every", "must be longer than 0 ps");
  take(settings.metropolis, table.boolean("metropolis"));
  take_edges(table, settings.edges);
  table.refuse_unknown();
  return settings;
}

HybridMonteCarloSettings read_hybrid_monte_carlo(TomlTable table) {
  HybridMonteCarloSettings settings;
  constexpr auto max_steps = static_cast<std::int64_t>(max_hybrid_steps);
  const auto steps = table.integer("steps").value_or(static_cast<std::int64_t>(settings.steps));
  table.require(steps >= 1 && steps <= max_steps, "steps",
                "must be from 1 to 1000000, the steps between two decisions; 5 to 50 are usual");
  settings.steps = static_cast<std::size_t>(steps);
  take(settings.refresh, table.quantity("refresh", Dimension::fraction, "100 %"));
  table.require(settings.refresh > 0 && settings.refresh <= 1, "refresh",
                "must be above 0 % and at most 100 %: the part of the momenta that is drawn again "
                "for each trajectory");
  table.refuse_unknown();
  return settings;
}

double default_compressibility() { return 4.5e-5 * unit("1/bar", Dimension::compressibility); }
BarostatSettings default_barostat(double pressure) {
  return {.pressure = pressure, .compressibility = default_compressibility()};
}
double min_compressibility() { return 1e-7 * unit("1/bar", Dimension::compressibility); }
double max_compressibility() { return 10 * unit("1/bar", Dimension::compressibility); }

}  // namespace polhode
