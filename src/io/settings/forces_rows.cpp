// SPDX-License-Identifier: MIT
// The settings of the table [forces], and the tables [[pair]].
#include <fmt/core.h>

#include <limits>

#include "forces/laws/check_settings.hpp"
#include "forces/laws/setting_names.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "list_tables.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/io/topology/topology_file.hpp"
#include "polhode/model/topology.hpp"
#include "setting_rows.hpp"
#include "short_range_keys.hpp"

namespace polhode {
namespace {

/// A setting that only one method of electrostatics uses.
template <class Member>
SettingMember only(Electrostatics user, Member ForceSettings::*one) {
  return member([user, one](Config& config) {
    return config.forces.electrostatics == user ? &(config.forces.*one) : nullptr;
  });
}

constexpr SettingUnit nm{Dimension::length, "nm"};

/// Marks bounds that the force field checks, because its messages also consider other settings.
constexpr SettingBounds in_library(SettingBounds bounds) {
  bounds.in_library = true;
  return bounds;
}

/// Reads truncation and electrostatics. The defaults of truncation and electrostatics depend on
/// each other.
void read_truncation(TomlTable& table, const SettingRow& row, Config& config) {
  ForceSettings& forces = config.forces;
  const auto given = table.holds_text("electrostatics")
                         ? value_of<Electrostatics>(*table.text("electrostatics"))
                         : std::nullopt;
  if (given && vanishes_at_cutoff(*given)) forces.truncation = Truncation::site_switch;
  read_row(table, row, config);
  // A plain cutoff would truncate the Coulomb forces between single sites at distances where these
  // forces are large.
  if (forces.truncation != Truncation::molecule_switch)
    forces.electrostatics = Electrostatics::reaction_field;
}

/// Reads the cutoff, from which the default of the switching distance follows.
void read_cutoff(TomlTable& table, const SettingRow& row, Config& config) {
  ForceSettings& forces = config.forces;
  const double switched_share = forces.switch_from / forces.cutoff;
  read_row(table, row, config);
  forces.switch_from = switched_share * forces.cutoff;
}

void read_dielectric(TomlTable& table, const SettingRow& row, Config& config) {
  if (!table.holds_text(row.key)) return read_row(table, row, config);
  table.require(table.text(row.key) == "infinite", row.key,
                "must be a number of 1 or more, or \"infinite\"");
  config.forces.dielectric = std::numeric_limits<double>::infinity();
}

MixingRule* mixing_rule(Config& config) { return &config.forces.mixing.rule; }

void check_mixing(TomlTable& table, Config& config) {
  table.renamed("accuracy", "pme_accuracy");
  const std::string& topology = config.system.topology.file;
  table.require(!table.has("mixing") || topology.empty() || is_data_file(topology), "mixing",
                "cannot be combined with a GROMACS topology, since the topology has its own mixing "
                "rule; leave it out");
}

void check_forces(TomlTable& table, Config& config) {
  if (const auto fault = find_fault(config.forces))
    table.refuse(fault->key, table.has(fault->key) ? fault->complaint : fault->message());
}

PairOverride read_pair(TomlTable& table, const std::string& file) {
  const auto sites = table.texts("sites");
  if (!sites)
    table.refuse("sites",
                 "a pair has no sites; write for example sites = [\"tip4p.OW\", \"argon.Ar\"]");
  table.require(sites->size() == 2, "sites",
                "must be two sites, each written as molecule.site: [\"tip4p.OW\", \"argon.Ar\"]");
  const ShortRangeKeys keys = read_short_range(table, LawOwner::pair, file);
  table.refuse_unknown();
  return {(*sites)[0], (*sites)[1], keys.sigma, keys.epsilon, keys.law};
}

}  // namespace

void read_pairs(const std::vector<TomlTable>& tables, Config& config) {
  const SystemSettings& system = config.system;
  Mixing& mixing = config.forces.mixing;
  Topology topology;
  for (const auto& component : system.molecules)
    topology.parts.push_back({molecule_of(component), component.count});
  for (TomlTable table : tables) {
    mixing.pairs.push_back(read_pair(table, config.source));
    if (!system.topology.file.empty()) continue;  // this is checked when the topology is read
    table.at("sites", [&] { check(mixing, topology); });
  }
}

SettingTable forces_table() {
  using enum Electrostatics;
  const auto forces = in(&Config::forces);
  return {
      "forces",
      {row("truncation", forces(&ForceSettings::truncation),
           "[cutoff treatment](../theory.md#cutoff-treatment)",
           More{.fallback = "`\"molecule-switch\"`; `\"pme\"` and `\"damped-shifted-force\"` use "
                            "`\"site-switch\"` for the short-range potentials",
                .read = read_truncation}),
       row("electrostatics", forces(&ForceSettings::electrostatics),
           "treatment of [electrostatic interactions](../theory.md#cutoff-treatment); `\"pme\"` "
           "includes [all periodic images](../theory.md#electrostatics-of-a-periodic-box), on a "
           "mesh chosen for `pme_accuracy`",
           More{.fallback = "`\"coulomb\"`; `\"reaction-field\"` if the truncation is site-based"}),
       row("cutoff", forces(&ForceSettings::cutoff), nm, in_library(above(0)),
           "cutoff distance between centres of mass or between sites; at most half the shortest "
           "box edge",
           More{.read = read_cutoff}),
       row("switch", forces(&ForceSettings::switch_from), nm, in_library(above(0)),
           "distance at which the switching function begins, shorter than the cutoff; `site-shift` "
           "does not use this distance",
           More{.fallback = "0.85 of the cutoff"}),
       row("smoothness", forces(&ForceSettings::smoothness), in_library(between(1, 3)),
           "number of continuous derivatives of the switching function"),
       row("skin", forces(&ForceSettings::skin), nm, in_library(above(0)),
           "skin of the neighbour list; affects the speed, and results only by rounding"),
       row("dielectric", only(reaction_field, &ForceSettings::dielectric), in_library(from(1)),
           "relative permittivity outside the cutoff, or `\"infinite\"`, for the reaction field",
           More{.by = "electrostatics",
                .read = read_dielectric,
                .kinds = {SettingKind::number, SettingKind::text}}),
       row("damping", only(damped_shifted_force, &ForceSettings::damping),
           SettingUnit{Dimension::inverse_length, "1/nm"}, in_library(from(0)),
           "α of the [damped shifted force](../theory.md#cutoff-treatment), at most 3 / cutoff; "
           "`smoothness` sets the smoothness of this force at the cutoff",
           More{.by = "electrostatics"}),
       row("pme_accuracy", only(pme, &ForceSettings::pme_accuracy), in_library(between(1e-7, 0.1)),
           "relative force error of `\"pme\"`: the rms error of electrostatic forces divided by "
           "the typical rms electrostatic force in a liquid of these charges; at least 1e-5 in "
           "mixed precision",
           More{.by = "electrostatics"}),
       row("coulomb_cutoff", only(pme, &ForceSettings::coulomb_cutoff),
           SettingUnit{Dimension::length, "nm", "0.8 nm"}, in_library(above(0)),
           "distance up to which `\"pme\"` sums pairs of charges, at most half the shortest edge",
           More{.fallback = "chosen with the mesh", .by = "electrostatics", .not_set = "chosen"}),
       row("dispersion_correction", forces(&ForceSettings::dispersion_correction),
           "adds the energy and pressure that the truncation of the short-range potentials "
           "removes; not available with `\"site-shift\"` or tabulated potentials"),
       row("slab_dispersion", forces(&ForceSettings::slab_dispersion),
           "adds the dispersion beyond the truncation to [slabs](../theory-forces.md#slabs)"),
       row("mixing", member(mixing_rule), "mixing rule of [σ and ε of unlike sites](#pair)",
           More{.fallback = "the rule in the molecule files, or else `\"lorentz-berthelot\"`"}),
       row("precision", forces(&ForceSettings::precision),
           "precision [of the pair interactions](../theory-forces.md#precision); everything else "
           "is in double precision. Mixed precision is as good as double precision down to [R = "
           "0.01 %](../precision.md)")},
      check_mixing,
      check_forces};
}

}  // namespace polhode
