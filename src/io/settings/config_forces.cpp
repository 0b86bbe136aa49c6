// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "config_tables.hpp"
#include "forces/laws/check_settings.hpp"
#include "forces/laws/setting_names.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/model/topology.hpp"
#include "short_range_keys.hpp"

namespace polhode {
namespace {

// A key that only one kind of electrostatics uses.
void check_user(TomlTable& table, std::string_view key, const ForceSettings& forces,
                Electrostatics user) {
  table.require(
      forces.electrostatics == user || !table.has(key), key,
      fmt::format("has no meaning without electrostatics = \"{}\"; leave it out", name_of(user)));
}

// The default of each of the two depends on the other.
void read_truncation(TomlTable& table, ForceSettings& forces) {
  const auto given = table.holds_text("electrostatics")
                         ? value_of<Electrostatics>(*table.text("electrostatics"))
                         : std::nullopt;
  const bool has_own_cutoff = given && vanishes_at_cutoff(*given);
  forces.truncation =
      one_of(table, "truncation", has_own_cutoff ? Truncation::site_switch : forces.truncation);
  // Unscreened Coulomb forces between single sites would be truncated where they are large.
  forces.electrostatics =
      one_of(table, "electrostatics",
             forces.truncation == Truncation::molecule_switch ? forces.electrostatics
                                                              : Electrostatics::reaction_field);
}

void read_cutoff(TomlTable& table, ForceSettings& forces) {
  const double switched_share = forces.switch_from / forces.cutoff;
  take(forces.cutoff, table.quantity("cutoff", Dimension::length, "1 nm"));
  forces.switch_from = table.quantity("switch", Dimension::length, "0.85 nm")
                           .value_or(switched_share * forces.cutoff);
  // Any number outside of the domain remains outside of it.
  const auto smoothness = table.integer("smoothness").value_or(forces.smoothness);
  forces.smoothness = static_cast<int>(std::clamp<std::int64_t>(smoothness, 0, 100));
  take(forces.skin, table.quantity("skin", Dimension::length, "0.05 nm"));
}

void read_dielectric(TomlTable& table, double& dielectric) {
  if (table.holds_text("dielectric")) {
    table.require(table.text("dielectric") == "infinite", "dielectric",
                  "must be a number of 1 or more, or \"infinite\"");
    dielectric = std::numeric_limits<double>::infinity();
  } else {
    take(dielectric, table.number("dielectric"));
  }
}

void read_electrostatics(TomlTable& table, ForceSettings& forces) {
  check_user(table, "pme_accuracy", forces, Electrostatics::pme);
  take(forces.pme_accuracy, table.number("pme_accuracy"));
  check_user(table, "coulomb_cutoff", forces, Electrostatics::pme);
  forces.coulomb_cutoff = table.quantity("coulomb_cutoff", Dimension::length, "0.8 nm");
  check_user(table, "damping", forces, Electrostatics::damped_shifted_force);
  take(forces.damping, table.quantity("damping", Dimension::inverse_length, "2 1/nm"));
  check_user(table, "dielectric", forces, Electrostatics::reaction_field);
  read_dielectric(table, forces.dielectric);
}

PairOverride read_pair(TomlTable& table, const std::string& file) {
  const auto sites = table.texts("sites");
  if (!sites)
    table.refuse("sites",
                 "a pair has no sites; write for example sites = [\"tip4p.OW\", \"argon.Ar\"]");
  table.require(sites->size() == 2, "sites",
                "must be two, each a molecule and a site: [\"tip4p.OW\", \"argon.Ar\"]");
  const ShortRangeKeys keys = read_short_range(table, LawOwner::pair, file);
  table.refuse_unknown();
  return {(*sites)[0], (*sites)[1], keys.sigma, keys.epsilon, keys.law};
}

}  // namespace

void read_forces(TomlTable table, ForceSettings& forces) {
  table.renamed("accuracy", "pme_accuracy");
  read_truncation(table, forces);
  read_cutoff(table, forces);
  read_electrostatics(table, forces);
  forces.precision = one_of(table, "precision", forces.precision);
  forces.mixing.rule = one_of(table, "mixing", forces.mixing.rule);
  take(forces.dispersion_correction, table.boolean("dispersion_correction"));
  table.refuse_unknown();
  if (const auto fault = find_fault(forces))
    table.refuse(fault->key, table.has(fault->key) ? fault->complaint : fault->message());
}

void read_pairs(const std::vector<TomlTable>& tables, const SystemSettings& system,
                const std::string& file, Mixing& mixing) {
  Topology topology;
  for (const auto& component : system.molecules)
    topology.parts.push_back({molecule_of(component), component.count});
  for (TomlTable table : tables) {
    mixing.pairs.push_back(read_pair(table, file));
    if (!system.topology.file.empty()) continue;  // checked when the topology is read
    try {
      check(mixing, topology);
    } catch (const Error& e) {
      throw e.at(table.where("sites"));
    }
  }
}

}  // namespace polhode
