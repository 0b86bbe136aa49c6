// SPDX-License-Identifier: MIT
// The settings of the tables [thermostat], [barostat] and [hybrid_monte_carlo].
#include <fmt/core.h>

#include "io/settings/ensemble_names.hpp"
#include "io/settings/ensemble_text.hpp"
#include "model/coupled_edges.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

constexpr SettingUnit ps{Dimension::time, "ps"}, per_ps{Dimension::rate, "1/ps"};

ThermostatSettings* thermostat_of(Config& config) {
  auto& thermostat = config.ensemble.thermostat;
  return thermostat ? &*thermostat : nullptr;
}
BoxMoves* moves_of(Config& config) {
  auto& barostat = config.ensemble.barostat;
  return barostat ? &barostat->type : nullptr;
}

/// A setting for a parameter that only some alternatives of a variant have.
template <class Variant, class T, class... Types>
SettingMember parameter(Variant* (*type_of)(Config&), T Types::*... one) {
  return member([=](Config& config) {
    Variant* const type = type_of(config);
    T* found = nullptr;
    if (type) ((found = std::get_if<Types>(type) ? &(std::get<Types>(*type).*one) : found), ...);
    return found;
  });
}

/// The setting `type` of a variant, with separate parameters for each alternative.
template <class Variant>
SettingMember type_member(Variant* (*type_of)(Config&)) {
  const auto find = [type_of](const Config& config) {
    return type_of(const_cast<Config&>(config));
  };
  return {[find](const Config& config) { return find(config) != nullptr; },
          [find](const Config& config) { return std::string(type_name(*find(config))); },
          [type_of](Config& config, const SettingValue& value) {
            set_type(*type_of(config), std::get<std::string>(value));
          },
          SettingKind::text, type_names<Variant>};
}

/// Returns a function that gives access to members of an optional table of a run file.
template <class Settings>
auto in_table(std::optional<Settings> EnsembleSettings::*table) {
  return [table](auto Settings::*one) {
    return member([table, one](Config& config) {
      auto& settings = config.ensemble.*table;
      return settings ? &(*settings.*one) : nullptr;
    });
  };
}

void read_friction(TomlTable& table, const SettingRow& row, Config& config) {
  read_row(table, row, config);
  auto& langevin = std::get<Langevin>(*config.ensemble.thermostat);
  langevin.rotational_friction = langevin.friction;
}

void read_edges(TomlTable& table, const SettingRow& row, Config& config) {
  const auto texts = table.texts(row.key);
  if (!texts) return;
  auto& groups = config.ensemble.barostat->edges;
  groups.clear();
  for (const std::string& text : *texts) {
    const auto edges = coupled_edges(text);
    table.require(edges.has_value(), row.key,
                  fmt::format("has the group \"{}\"; a group must be one or more of x, y and z: "
                              "write for example [\"xyz\"], or [\"xy\", \"z\"]",
                              text));
    groups.push_back(*edges);
  }
  table.require(!overlap(groups), row.key,
                "has an edge in two groups; each edge may be in at most one group");
  table.require(!groups.empty(), row.key, "must name at least one group, for example \"xyz\"");
}

/// A setting for the groups of edges, as one text.
SettingMember edges_member() {
  SettingMember made;
  made.exists = [](const Config& config) { return config.ensemble.barostat.has_value(); };
  made.value = [](const Config& config) { return edges_text(config.ensemble.barostat->edges); };
  return made;
}

void require_pressure(TomlTable& table, Config& config) {
  config.ensemble.barostat = default_barostat();
  table.require(table.has("pressure"), "",
                "there is no pressure for the barostat; write for example pressure = \"1 bar\"");
}

}  // namespace

SettingTable thermostat_table() {
  const SettingBounds rate = between(0, 1e6, "; 0.1 to 10 1/ps are usual");
  return {
      "thermostat",
      {row("type", type_member(thermostat_of),
           "thermostat: `\"langevin\"` applies [friction and noise](../theory.md#thermostats) to "
           "every momentum; `\"rescaling\"` applies one factor to all momenta; "
           "`\"separate-rescaling\"` applies one factor to translation and another to rotation"),
       row("friction", parameter(thermostat_of, &Langevin::friction), per_ps, rate,
           "friction γ of translation, and of rotation unless `rotational_friction` is given; a "
           "friction of 0 1/ps gives the same trajectory, bit for bit, as constant energy",
           More{.by = "type", .read = read_friction}),
       row("rotational_friction", parameter(thermostat_of, &Langevin::rotational_friction), per_ps,
           rate, "friction γ of rotation", More{.fallback = "value of `friction`", .by = "type"}),
       row("time_constant",
           parameter(thermostat_of, &Rescaling::time_constant, &SeparateRescaling::time_constant),
           ps, above(0, "; 0.1 to 1 ps are usual"),
           "time constant τ of rescaling, at least one step", More{.by = "type"})},
      [](TomlTable&, Config& config) { config.ensemble.thermostat.emplace(); }};
}

SettingTable barostat_table() {
  using B = BarostatSettings;
  const auto barostat = in_table(&EnsembleSettings::barostat);
  return {"barostat",
          {row("type", type_member(moves_of),
               "barostat: [stochastic cell rescaling, or Monte Carlo moves of random "
               "size](../theory.md#barostats)"),
           row("pressure", barostat(&B::pressure), SettingUnit{Dimension::pressure, "bar", "1 bar"},
               "pressure of the barostat; a negative pressure puts a liquid under tension until it "
               "cavitates",
               More{.fallback = "required"}),
           row("compressibility", barostat(&B::compressibility),
               SettingUnit{Dimension::compressibility, "1/bar", "4.5e-5 1/bar"},
               between(1e-7, 10,
                       "; solids have 1e-7 1/bar, liquids 2e-5 to 2e-4 1/bar (water 4.5e-5), a gas "
                       "has 1/pressure"),
               "estimate of the isothermal compressibility; affects the size of the volume moves, "
               "but not the averages. The default is the compressibility of water; "
               "[prepare](prepare.md) estimates the value for your system"),
           row("every", barostat(&B::every), ps, above(0),
               "interval between two volume moves, rounded to whole steps; with hybrid Monte "
               "Carlo, rounded to whole trajectories (a note reports this)"),
           row("edges", edges_member(),
               "groups of box edges; each move scales the edges of one group, and the groups "
               "alternate. `[\"x\", \"y\", \"z\"]` scales each edge separately (for crystals), and "
               "`[\"z\"]` keeps the area fixed (for slabs)",
               More{.domain = "list of groups of x, y and z",
                    .fallback = "`[\"xyz\"]`",
                    .read = read_edges,
                    .kinds = {SettingKind::texts}}),
           row("time_constant", parameter(moves_of, &CellRescaling::time_constant), ps,
               above(0, "; 1 to 10 ps are usual"),
               "relaxation time τ of the volume, at least as long as `every`", More{.by = "type"}),
           row("metropolis", parameter(moves_of, &CellRescaling::metropolis),
               "whether volume moves are accepted or rejected by the Metropolis criterion, which "
               "makes the distribution exact for any `every`",
               More{.by = "type"})},
          require_pressure};
}

SettingTable hybrid_monte_carlo_table() {
  using H = HybridMonteCarloSettings;
  const auto hybrid = in_table(&EnsembleSettings::hybrid_monte_carlo);
  return {
      "hybrid_monte_carlo",
      {row("steps", hybrid(&H::steps), between(1, 1e6, "; 5 to 50 are usual"),
           "number of steps of a hybrid Monte Carlo trajectory, after which the trajectory is "
           "accepted or rejected"),
       row("refresh", hybrid(&H::refresh), SettingUnit{Dimension::fraction, "%"}, above_to(0, 100),
           "fraction of the momenta that is drawn again for each trajectory")},
      [](TomlTable&, Config& config) { config.ensemble.hybrid_monte_carlo.emplace(); }};
}

double default_compressibility() { return 4.5e-5 * unit("1/bar", Dimension::compressibility); }
BarostatSettings default_barostat() { return {.compressibility = default_compressibility()}; }

}  // namespace polhode
