// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <array>
#include <string>
#include <string_view>

#include "atom.h"
#include "domain.h"
#include "fix.h"
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

// LAMMPS styles that change velocities or positions of atoms but not the bodies of fix polhode.
constexpr std::array changers = {
    "ehex",           "heat",        "momentum",  "move",         "recenter",
    "temp/berendsen", "temp/csld",   "temp/csvr", "temp/rescale", "thermal/conductivity",
    "viscosity",      "wall/reflect"};

bool shares_atoms(LAMMPS* lammps, const Fix* a, const Fix* b) {
  int shared = 0;
  const int* const mask = lammps->atom->mask;
  for (int i = 0; i < lammps->atom->nlocal; ++i)
    if ((mask[i] & a->groupbit) != 0 && (mask[i] & b->groupbit) != 0) shared = 1;
  MPI_Allreduce(MPI_IN_PLACE, &shared, 1, MPI_INT, MPI_MAX, lammps->world);
  return shared != 0;
}

void check_fix(LAMMPS* lammps, const Fix* own, const Fix* other, std::size_t evaluations) {
  const std::string name = std::string("fix ") + other->id + " (" + other->style + ")";
  if (LAMMPS_NS::utils::strmatch(other->style, "^polhode"))
    throw Error(name +
                " is a second fix polhode, but one fix must advance all rigid molecules; put all "
                "molecules into the group of one fix polhode");
  if (other->time_integrate != 0 && shares_atoms(lammps, own, other))
    throw Error(name +
                " integrates atoms that fix polhode integrates as well; give the other fix a group "
                "without these atoms");
  if (other->time_integrate != 0 && evaluations > 1)
    throw Error(name + " integrates other atoms at each of the " + std::to_string(evaluations) +
                " force evaluations in a step of the scheme, but these evaluations are not equally "
                "spaced in time; with a second integrator the scheme must be velocity-verlet");
  for (const std::string_view changer : changers)
    if (other->style == changer && shares_atoms(lammps, own, other))
      throw Error(name +
                  " changes velocities or positions of atoms in rigid molecules, but fix polhode "
                  "would overwrite these changes; remove the other fix, and for a thermostat use "
                  "the keyword langevin of fix polhode");
}

void check_multiple(LAMMPS_NS::bigint value, std::size_t evaluations, const std::string& what) {
  const auto n = static_cast<LAMMPS_NS::bigint>(evaluations);
  if (value % n == 0) return;
  throw Error(what + " is " + std::to_string(value) + "; it must be a multiple of " +
              std::to_string(n) +
              ", the number of force evaluations in a step of the scheme, because positions and "
              "velocities refer to the same time only at the end of a step");
}

}  // namespace

void check_system(LAMMPS* lammps, const Fix* own, std::size_t evaluations) {
  if (lammps->update->whichflag == 2)
    throw Error(
        "fix polhode cannot minimise, because LAMMPS minimisers deform rigid molecules; minimise "
        "before the fix is defined, or with 'polhode minimise'");
  if (!LAMMPS_NS::utils::strmatch(lammps->update->integrate_style, "^verlet"))
    throw Error(std::string("the run style is ") + lammps->update->integrate_style +
                "; fix polhode needs run_style verlet: use a nested scheme of fix polhode instead "
                "of respa");
  if (lammps->domain->dimension == 2)
    throw Error(
        "the system is two-dimensional; fix polhode rotates molecules in three dimensions, "
        "so set dimension 3");
  const LAMMPS_NS::Domain* const domain = lammps->domain;
  if (domain->box_change_size != 0 || domain->box_change_shape != 0 || domain->nonperiodic == 2)
    throw Error(
        "a fix or a shrink-wrapped boundary changes the box; fix polhode needs a constant "
        "box, so remove barostats, fix deform, and boundaries s and m");
  for (const Fix* other : lammps->modify->get_fix_list())
    if (other != own) check_fix(lammps, own, other, evaluations);
}

void check_intervals(LAMMPS* lammps, std::size_t evaluations, std::size_t phase) {
  if (evaluations == 1) return;
  const LAMMPS_NS::Update* const update = lammps->update;
  const LAMMPS_NS::Output* const output = lammps->output;
  const auto before = static_cast<LAMMPS_NS::bigint>(phase);
  check_multiple(update->laststep - update->firststep + before, evaluations,
                 phase == 0 ? "the length of the run"
                            : "the length of the run plus the " + std::to_string(phase) +
                                  " force evaluations of an unfinished earlier step");
  if (output->thermo_every > 0)
    check_multiple(output->thermo_every, evaluations, "the interval of thermo");
  bool needs_start = output->thermo_every > 0;
  for (int n = 0; n < output->ndump; ++n)
    if (output->mode_dump[n] == 0 && output->every_dump[n] > 0) {
      check_multiple(output->every_dump[n], evaluations, "the interval of a dump");
      needs_start = true;
    }
  for (const Fix* fix : lammps->modify->get_fix_list())
    if (LAMMPS_NS::utils::strmatch(fix->style, "^ave/"))
      check_multiple(fix->nevery, evaluations, std::string("the interval of fix ") + fix->id);
  if (needs_start)
    check_multiple(update->firststep - before, evaluations, "the first step of the run");
}

}  // namespace polhode::lammps
