// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"
#include "polhode/base/error.hpp"
#include "update.h"
#include "utils.h"

namespace polhode::lammps {
namespace {

using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;

using namespace std::string_view_literals;

// LAMMPS styles that change velocities or positions of atoms but not the bodies of fix polhode.
constexpr std::array changers = {
    "ehex"sv,      "filter/corotate"sv, "heat"sv,  "momentum"sv, "move"sv,
    "rattle"sv,    "recenter"sv,        "shake"sv, "temp/"sv,    "thermal/conductivity"sv,
    "viscosity"sv, "wall/reflect"sv};
// Styles that create, delete, move or exchange atoms during a run.
constexpr std::array exchangers = {
    "atom/swap"sv, "bond/create"sv, "bond/react"sv, "charge/regulation"sv,
    "evaporate"sv, "gcmc"sv,        "mol/swap"sv,   "neighbor/swap"sv,
    "sgcmc"sv,     "widom"sv};
// Styles whose forces depend on the velocities of atoms.
constexpr std::array velocity_readers = {"langevin"sv, "viscous"sv};
// Styles whose forces may depend on time, by a variable or by a motion of their own.
constexpr std::array time_dependent = {"addforce"sv, "aveforce"sv, "drag"sv, "efield"sv, "indent"sv,
                                       "oneway"sv,   "setforce"sv, "smd"sv,  "wall/"sv};

std::string name_of(const Fix* fix) {
  return std::string("fix ") + fix->id + " (" + fix->style + ")";
}

void check_integrator(const Fix* other, bool shares, std::size_t evaluations) {
  if (LAMMPS_NS::utils::strmatch(other->style, "^polhode"))
    throw Error(name_of(other) +
                " is a second fix polhode, but one fix must advance all rigid molecules; put all "
                "molecules into the group of one fix polhode");
  if (other->time_integrate == 0) return;
  if (shares)
    throw Error(name_of(other) +
                " integrates atoms that fix polhode integrates as well; give the other fix a group "
                "without these atoms");
  if (evaluations > 1)
    throw Error(name_of(other) + " integrates other atoms at each of the " +
                std::to_string(evaluations) +
                " force evaluations in a step of the scheme, but these evaluations are not equally "
                "spaced in time; with a second integrator the scheme must be velocity-verlet");
}

// Checks a fix that has atoms in common with fix polhode.
void check_shared(const Fix* other, const CheckedScheme& scheme) {
  if (is_variant_of(other->style, changers))
    throw Error(name_of(other) +
                " changes velocities or positions of atoms in rigid molecules, but fix polhode "
                "would overwrite these changes; remove the other fix, and for a thermostat use "
                "the keyword rescale or langevin of fix polhode");
  if (is_variant_of(other->style, exchangers))
    throw Error(name_of(other) +
                " creates, deletes, moves or exchanges atoms of rigid molecules during a run, but "
                "fix polhode finds molecules only at the start of a run; give the other fix a "
                "group without these atoms");
  if (is_variant_of(other->style, velocity_readers) && scheme.evaluations > 1)
    throw Error(name_of(other) + " needs velocities at each of the " +
                std::to_string(scheme.evaluations) +
                " force evaluations in a step of the scheme, but velocities are known only at the "
                "end of a step; use the keyword langevin of fix polhode, or the scheme "
                "velocity-verlet");
  if (scheme.amplifies && is_variant_of(other->style, time_dependent))
    throw Error(name_of(other) +
                " adds forces that may depend on time, but gradient kicks with a small lambda "
                "amplify any change of forces between two evaluations; leave lambda out (default: "
                "1), or use a scheme without gradients");
}

bool adds_forces(const LAMMPS* lammps, std::size_t fix) {
  return (lammps->modify->fmask[fix] & LAMMPS_NS::FixConst::POST_FORCE) != 0;
}

void check_fixes(LAMMPS* lammps, const Fix* own, const CheckedScheme& scheme) {
  const auto& fixes = lammps->modify->get_fix_list();
  bool is_after = false;
  for (std::size_t k = 0; k < fixes.size(); ++k) {
    const Fix* const other = fixes[k];
    is_after |= other == own;
    if (other == own) continue;
    const bool shares = shares_atoms(lammps, own, other);
    check_integrator(other, shares, scheme.evaluations);
    if (!shares) continue;
    check_shared(other, scheme);
    if (is_after && adds_forces(lammps, k))
      throw Error(name_of(other) +
                  " is defined after fix polhode, so its forces would be missing at the start of a "
                  "run; define it before fix polhode");
  }
}

void check_multiple(LAMMPS_NS::bigint value, std::size_t evaluations, const std::string& what) {
  const auto n = static_cast<LAMMPS_NS::bigint>(evaluations);
  if (value % n == 0) return;
  throw Error(what + " is " + std::to_string(value) + "; it must be a multiple of " +
              std::to_string(n) +
              ", the number of force evaluations in a step of the scheme, because positions and "
              "velocities refer to the same time only at the end of a step");
}

void refuse_variable(const std::string& what, std::size_t evaluations) {
  throw Error("the interval of " + what +
              " is a variable or a time; it must be a number of steps, " + "a multiple of " +
              std::to_string(evaluations) +
              ", the number of force evaluations in a step of the scheme");
}

// Checks the intervals of thermo and dumps.
// @return  whether there is output at intervals
bool check_output(const LAMMPS_NS::Output& output, std::size_t evaluations) {
  if (output.var_thermo != nullptr) refuse_variable("thermo", evaluations);
  if (output.thermo_every > 0)
    check_multiple(output.thermo_every, evaluations, "the interval of thermo");
  for (int n = 0; n < output.ndump; ++n) {
    if (output.mode_dump[n] != 0 || output.every_dump[n] <= 0)
      refuse_variable("a dump", evaluations);
    check_multiple(output.every_dump[n], evaluations, "the interval of a dump");
  }
  return output.thermo_every > 0 || output.ndump > 0;
}

// Whether a fix acts at the end of steps.
bool acts_at_end(const LAMMPS* lammps, std::size_t k) {
  return lammps->modify->get_fix_list()[k]->nevery > 0 &&
         (lammps->modify->fmask[k] & LAMMPS_NS::FixConst::END_OF_STEP) != 0;
}

}  // namespace

bool is_variant_of(std::string_view style, std::span<const std::string_view> names) {
  return std::ranges::any_of(names, [&](std::string_view name) { return style.starts_with(name); });
}

bool shares_atoms(LAMMPS* lammps, const Fix* a, const Fix* b) {
  int shared = 0;
  const int* const mask = lammps->atom->mask;
  for (int i = 0; i < lammps->atom->nlocal; ++i)
    if ((mask[i] & a->groupbit) != 0 && (mask[i] & b->groupbit) != 0) shared = 1;
  MPI_Allreduce(MPI_IN_PLACE, &shared, 1, MPI_INT, MPI_MAX, lammps->world);
  return shared != 0;
}

/// Only fix polhode itself may change the box.
void check_box(const LAMMPS& lammps, const Fix* own) {
  for (const Fix* const other : lammps.modify->get_fix_list())
    if (other != own && (other->box_change & (Fix::BOX_CHANGE_SIZE | Fix::BOX_CHANGE_SHAPE)) != 0)
      throw Error(name_of(other) +
                  " changes the box and would deform rigid molecules; remove it, and for a "
                  "barostat use the keyword pressure of fix polhode");
  if (lammps.domain->nonperiodic == 2)
    throw Error(
        "a shrink-wrapped boundary changes the box and would deform rigid molecules; replace the "
        "boundaries s and m");
  constexpr int changes[] = {Fix::BOX_CHANGE_X, Fix::BOX_CHANGE_Y, Fix::BOX_CHANGE_Z};
  for (std::size_t k = 0; k < 3; ++k)
    if ((own->box_change & changes[k]) != 0 && lammps.domain->periodicity[k] == 0)
      throw Error(std::string("the keyword pressure scales the edge ") + "xyz"[k] +
                  ", so its boundaries must be periodic; set 'boundary p p p', or give the keyword "
                  "edges the periodic directions alone");
}

void check_system(LAMMPS* lammps, const Fix* own, const CheckedScheme& scheme) {
  if (lammps->update->whichflag == 2)
    throw Error(
        "fix polhode cannot minimise, because LAMMPS minimisers deform rigid molecules; use 'run' "
        "with the keyword 'langevin 0 DAMP SEED', which damps the motion, or 'polhode minimise' "
        "before the export");
  if (!LAMMPS_NS::utils::strmatch(lammps->update->integrate_style, "^verlet"))
    throw Error(std::string("the run style is ") + lammps->update->integrate_style +
                "; fix polhode needs run_style verlet: use a nested scheme of fix polhode instead "
                "of respa");
  if (lammps->domain->dimension == 2)
    throw Error(
        "the system is two-dimensional; fix polhode rotates molecules in three dimensions, "
        "so set dimension 3");
  check_box(*lammps, own);
  check_fixes(lammps, own, scheme);
}

bool needs_half_step_velocities(LAMMPS* lammps, const Fix* own) {
  const auto& fixes = lammps->modify->get_fix_list();
  return std::ranges::any_of(fixes, [&](const Fix* fix) {
    return is_variant_of(fix->style, velocity_readers) && shares_atoms(lammps, own, fix);
  });
}

std::vector<int> intervals_of_fixes(const LAMMPS* lammps, const Fix* own) {
  std::vector<int> intervals;
  const auto& fixes = lammps->modify->get_fix_list();
  for (std::size_t k = 0; k < fixes.size(); ++k)
    if (fixes[k] != own && acts_at_end(lammps, k)) intervals.push_back(fixes[k]->nevery);
  return intervals;
}

bool may_read_velocities(const LAMMPS* lammps, const Fix* own) {
  const char* const pairs = lammps->force->pair_style;
  if (lammps->comm->ghost_velocity != 0) return true;  // for pair styles with friction
  if (pairs != nullptr && std::string_view(pairs).starts_with("hybrid/scaled"))
    return true;  // by a variable
  return std::ranges::any_of(lammps->modify->get_fix_list(), [&](const Fix* fix) {
    return fix != own && std::string_view(fix->style) != "property/atom";
  });
}

void check_intervals(LAMMPS* lammps, const Fix* own, std::size_t evaluations, std::size_t phase) {
  if (evaluations == 1) return;
  const LAMMPS_NS::Update* const update = lammps->update;
  const auto before = static_cast<LAMMPS_NS::bigint>(phase);
  check_multiple(update->laststep - update->firststep + before, evaluations,
                 phase == 0 ? "the length of the run"
                            : "the length of the run plus the " + std::to_string(phase) +
                                  " force evaluations of an unfinished earlier step");
  const bool needs_start = check_output(*lammps->output, evaluations);
  const auto& fixes = lammps->modify->get_fix_list();
  for (std::size_t k = 0; k < fixes.size(); ++k)
    if (fixes[k] != own && acts_at_end(lammps, k))
      check_multiple(fixes[k]->nevery, evaluations, "the interval of " + name_of(fixes[k]));
  if (needs_start)
    check_multiple(update->firststep - before, evaluations, "the first step of the run");
}

}  // namespace polhode::lammps
