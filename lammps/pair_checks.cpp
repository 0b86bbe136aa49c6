// SPDX-License-Identifier: MIT
// The conditions under which pair_style polhode rejects a LAMMPS input.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "atom.h"
#include "checks.hpp"
#include "compute.h"
#include "error.h"
#include "fix_polhode.hpp"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_polhode.hpp"
#include "polhode/io/settings/config.hpp"
#include "utils.h"

namespace polhode::lammps {
namespace {

// Pair style polhode always excludes pairs within molecules, so exclusions of such pairs are
// allowed.
bool excludes_other_pairs(const LAMMPS_NS::Neighbor* neighbor) {
  return neighbor->nex_type > 0 || neighbor->nex_group > 0 ||
         std::any_of(neighbor->ex_mol_intra, neighbor->ex_mol_intra + neighbor->nex_mol,
                     [](int intra) { return intra == 0; });
}

bool is_zero(const double* special) {
  return std::all_of(special + 1, special + 4, [](double x) { return x == 0; });
}

using namespace std::string_view_literals;

// Styles that change charges or potentials during a run; pair style polhode reads them at the start
// of a run.
constexpr std::array parameter_changers = {"adapt"sv};
constexpr std::array charge_changers = {"electrode"sv, "qeq"sv};  // of the atoms of their group
// Styles that replace the forces on atoms, which are zero.
constexpr std::array force_changers = {"aveforce"sv, "freeze"sv, "lineforce"sv, "planeforce"sv,
                                       "setforce"sv};
// Parts of the names of all pair styles that read charges of atoms.
constexpr std::array words_of_charges = {"amoeba", "comb",  "coul",  "dipole", "hippo",
                                         "reax",   "smtbq", "thole", "tip4p"};
// Styles that change positions or charges of atoms for a moment and compute forces again.
constexpr std::array perturbing = {"born/matrix"sv, "fep"sv, "numdiff"sv};

}  // namespace

void PairPolhode::check_not_perturbing(const char* command, const char* id,
                                       const char* name) const {
  if (is_variant_of(name, perturbing))
    error->all(
        FLERR,
        "pair_style polhode reads charges and positions of molecules from fix polhode, but {} {} "
        "({}) changes charges or positions of atoms for a moment; use a pair style of LAMMPS",
        command, id, name);
}

void PairPolhode::check_other_commands() const {
  for (const LAMMPS_NS::Fix* fix : modify->get_fix_list()) {
    check_not_perturbing("fix", fix->id, fix->style);
    const bool shares = shares_atoms(lmp, fix_, fix);
    if (is_variant_of(fix->style, parameter_changers) ||
        (shares && is_variant_of(fix->style, charge_changers)))
      error->all(
          FLERR,
          "pair_style polhode reads charges and parameters at the start of a run, but fix {} "
          "({}) changes them during a run; change them between runs with 'set' or "
          "'pair_coeff'",
          fix->id, fix->style);
    if (shares && is_variant_of(fix->style, force_changers))
      error->all(
          FLERR,
          "pair_style polhode computes forces on molecules, not on atoms, so fix {} ({}) has "
          "no forces to replace; remove it, or use a pair style of LAMMPS",
          fix->id, fix->style);
  }
  for (const LAMMPS_NS::Compute* compute : modify->get_compute_list())
    check_not_perturbing("compute", compute->id, compute->style);
  const std::optional<double> lambda = fix_->lambda_of_kicks();
  if (settings_.precision == Precision::mixed && lambda.value_or(1) < min_lambda_in_mixed)
    error->all(
        FLERR,
        "pair_style polhode: lambda = {:g} of fix polhode is below {:g}, the minimum in mixed "
        "precision, since a small lambda amplifies the rounding error of the forces; leave "
        "lambda out (default: 1), or use precision double",
        *lambda, min_lambda_in_mixed);
}

bool PairPolhode::is_part() const { return force->pair != this; }

void PairPolhode::check_hybrid_style() const {
  if (LAMMPS_NS::utils::strmatch(force->pair_style, "^hybrid/scaled"))
    error->all(FLERR,
               "pair_style polhode computes forces on molecules, which hybrid/scaled does not "
               "scale; use hybrid/overlay");
  if (force->pair_match("^polhode$", 0) != this)
    error->all(FLERR,
               "pair_style polhode is used twice in a hybrid style, but one style computes all "
               "pairs of rigid molecules; use it once");
  if (fix_->has_particles())
    error->all(FLERR,
               "pair_style polhode is part of a hybrid style, but the sites of particles are not "
               "atoms, so other pair styles do not see them; represent each site by an atom");
}

/// In a hybrid style, the interactions of all types of rigid molecules must belong to this style,
/// and no other style may compute their charges.
void PairPolhode::check_pairs_of_types() const {
  std::set<int> types;
  for (const Kind& kind : fix_->kinds()) types.insert(kind.types.begin(), kind.types.end());
  for (const int i : types)
    for (const int j : types)
      if (i <= j && !is_mapped(i, j))
        error->all(FLERR,
                   "pair_style polhode computes all pairs of rigid molecules, but the hybrid style "
                   "leaves out atom types {} and {}; add 'pair_coeff {} {} polhode EPSILON SIGMA'",
                   i, j, i, j);
  for (const char* const word : words_of_charges) check_charges_once(types, word);
}

/// Checks that no other style of a hybrid style computes charges of rigid molecules.
/// @param word  part of the names of such styles
void PairPolhode::check_charges_once(const std::set<int>& types, const char* word) const {
  std::set<const Pair*> others;  // LAMMPS gives a single style for every number
  for (int k = 1; others.insert(force->pair_match(word, 0, k)).second;) ++k;
  others.erase(nullptr);
  for (const Pair* const other : others)
    for (const int i : types)
      for (const int j : types)
        if (other->setflag[i][j] != 0)
          error->all(FLERR,
                     "the hybrid style has the charges of atom types {} and {} of rigid molecules "
                     "twice, in pair_style polhode and in a style with '{}'; give that style "
                     "only pairs with other atoms",
                     i, j, word);
}

void PairPolhode::check_inputs() const {
  check_other_commands();
  if (is_part()) check_hybrid_style();
  if (atom->tag_enable == 0)
    error->all(FLERR,
               "pair_style polhode finds molecules by the ids of their atoms; remove "
               "'atom_modify id no'");
  if (offset_flag != 0 || tail_flag != 0)
    error->all(FLERR,
               "pair_style polhode does not support 'pair_modify shift' or 'tail'; energies are "
               "already smooth at the cutoff, so remove these options");
  if (!is_part() && (!is_zero(force->special_lj) || !is_zero(force->special_coul)))
    error->all(FLERR,
               "pair_style polhode leaves out all pairs within a rigid molecule, but some "
               "special_bonds are not 0; set 'special_bonds lj/coul 0 0 0'");
  if (excludes_other_pairs(neighbor))
    error->all(FLERR,
               "pair_style polhode computes all pairs of molecules, but neigh_modify exclude "
               "leaves some pairs out; remove neigh_modify exclude");
  if (atom->firstgroupname != nullptr)
    error->all(FLERR,
               "pair_style polhode needs all molecules near the subdomain of a process, but with "
               "'atom_modify first {}' LAMMPS communicates only some atoms; remove this command",
               atom->firstgroupname);
  const bool mesh = settings_.electrostatics == Electrostatics::pme;
  if (mesh && fix_->has_particles())
    error->all(FLERR,
               "pair_style polhode with electrostatics pme needs a mesh for all charges, but the "
               "mesh of LAMMPS does not support charges within particles; use reaction-field, or "
               "molecules of atoms");
  if (mesh && force->kspace == nullptr)
    error->all(
        FLERR,
        "pair_style polhode with electrostatics pme computes only the pair part of the Ewald sum; "
        "add a kspace style for the mesh part, for example 'kspace_style pppm 1e-5'");
}

}  // namespace polhode::lammps
