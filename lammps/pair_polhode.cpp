// SPDX-License-Identifier: MIT
#include "pair_polhode.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_polhode.hpp"
#include "force.h"
#include "forces/pairs/cutoff_treatment.hpp"
#include "guarded.hpp"
#include "kspace.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_settings.hpp"
#include "utils.h"

namespace polhode::lammps {

constexpr const char* style = "pair_style polhode";

namespace {

bool is_lennard_jones(const PairCoefficients::Values& values) {
  return std::holds_alternative<LennardJonesLaw>(values.law);
}

std::array<bool, 3> periodic(const Vec3<double>& edges) {
  return {edges.x > 0, edges.y > 0, edges.z > 0};
}

}  // namespace

PairPolhode::PairPolhode(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
  single_enable = restartinfo = respa_enable = writedata = 0;
  no_virial_fdotr_compute = 1;
}

PairPolhode::~PairPolhode() {
  if (allocated == 0) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairPolhode::allocate() {
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  for (int i = 1; i <= types; ++i) {
    std::fill_n(setflag[i], types + 1, 0);
    std::fill_n(cutsq[i], types + 1, 0.0);
  }
  coefficients_ = PairCoefficients(types);
  allocated = 1;
}

void PairPolhode::settings(int count, char** arguments) {
  guarded(error, style, [&] {
    settings_ = pair_settings(count, arguments, lmp);
    units_.nm = length_unit(lmp);
  });
  cutoff_of_charges_ = LAMMPS_NS::utils::numeric(FLERR, arguments[0], false, lmp);
  ewaldflag = pppmflag = settings_.electrostatics == Electrostatics::pme ? 1 : 0;
}

void PairPolhode::coeff(int count, char** arguments) {
  if (allocated == 0) allocate();
  if (count < 2)
    error->all(FLERR,
               "pair_style polhode: pair_coeff begins with two atom types or ranges of types");
  int i_low = 0, i_high = 0, j_low = 0, j_high = 0;
  LAMMPS_NS::utils::bounds(FLERR, arguments[0], 1, atom->ntypes, i_low, i_high, error);
  LAMMPS_NS::utils::bounds(FLERR, arguments[1], 1, atom->ntypes, j_low, j_high, error);
  PairCoefficients::Values values;
  guarded(error, style, [&] { values = pair_values(count - 2, arguments + 2, lmp); });
  for (int i = i_low; i <= i_high; ++i)
    for (int j = std::max(i, j_low); j <= j_high; ++j) {
      coefficients_(i, j) = coefficients_(j, i) = values;
      setflag[i][j] = 1;
    }
}

void PairPolhode::init_style() {
  const auto fixes = modify->get_fix_by_style("^polhode$");
  if (fixes.empty())
    error->all(FLERR,
               "pair_style polhode computes forces on the bodies of fix polhode, but there is no "
               "such fix; define 'fix ID all polhode' before the run");
  fix_ = dynamic_cast<FixPolhode*>(fixes.front());
  check_inputs();
  fix_->recognise();
  if (!is_part() && !fix_->has_all_atoms())
    error->all(FLERR,
               "pair_style polhode computes forces on the bodies of fix polhode, but some atoms "
               "are in no body; put all atoms into the group of the fix, or use "
               "'pair_style hybrid/overlay' with another style for their pairs");
  guarded(error, style, [&] { charges_ = charges_of_kinds(); });
  find_range();
  units_.coulomb = force->qqrd2e;
  if (settings_.electrostatics == Electrostatics::pme)
    settings_.ewald_alpha = force->kspace->g_ewald / units_.nm;
  forces_.reset();
}

/// Finds the maximum distance between the owner atoms of two bodies that interact.
void PairPolhode::find_range() {
  double extent = 0, owner = 0;
  for (const Kind& kind : fix_->kinds()) {
    extent = std::max(extent, kind.extent);
    owner = std::max(owner, norm(kind.atom(kind.owner)));
  }
  const bool by_centres = cutoff_treatment(settings_) == CutoffTreatment::molecule_switch;
  range_ = settings_.cutoff / units_.nm + 2 * owner + (by_centres ? 0 : 2 * extent);
  range_ *= 1 + 1e-9;  // margin for round-off
}

double PairPolhode::init_one(int i, int j) {
  if (setflag[i][j] == 0) {
    const auto a = coefficients_(i, i), b = coefficients_(j, j);
    PairCoefficients::Values mixed;
    if (!a.is_zero() && !b.is_zero() && !(is_lennard_jones(a) && is_lennard_jones(b)))
      error->all(FLERR,
                 "pair_style polhode mixes only Lennard-Jones potentials; add 'pair_coeff {} {}' "
                 "with the potential of both types",
                 i, j);
    if (a.epsilon > 0 && b.epsilon > 0)
      mixed = {mix_energy(a.epsilon, b.epsilon, a.sigma, b.sigma), mix_distance(a.sigma, b.sigma)};
    coefficients_(i, j) = coefficients_(j, i) = mixed;
  }
  return range_;
}

void* PairPolhode::extract(const char* name, int& dimension) {
  dimension = 0;
  return std::strcmp(name, "cut_coul") == 0 ? &cutoff_of_charges_ : nullptr;
}

/// The charges of each kind. All molecules of a kind must have the same charges. A kind whose
/// molecules were all deleted has no charges.
KindCharges PairPolhode::charges_of_kinds() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Kind>& kinds = fix_->kinds();
  std::vector<std::size_t> first;
  std::size_t sites = 0;
  for (const Kind& kind : kinds) first.push_back(sites), sites += kind.types.size();
  std::vector<double> low(sites, infinity), high(sites, -infinity);
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto place = fix_->site_of(i);
    if (place.kind < 0) continue;  // of another pair style
    if (kinds[static_cast<std::size_t>(place.kind)].particle != 0) continue;
    const std::size_t k =
        first[static_cast<std::size_t>(place.kind)] + static_cast<std::size_t>(place.site);
    const double q = atom->q_flag != 0 ? atom->q[i] : 0;
    low[k] = std::min(low[k], q), high[k] = std::max(high[k], q);
  }
  const auto count = static_cast<int>(sites);
  MPI_Allreduce(MPI_IN_PLACE, low.data(), count, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(MPI_IN_PLACE, high.data(), count, MPI_DOUBLE, MPI_MAX, world);
  KindCharges charges;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<double>& of_kind = charges.emplace_back(kinds[k].charges);
    if (kinds[k].particle != 0) continue;
    for (std::size_t s = 0; s < kinds[k].types.size(); ++s) {
      const std::size_t at = first[k] + s;
      const bool has_molecules = low[at] <= high[at];
      if (has_molecules && low[at] != high[at])
        throw Error("atom " + std::to_string(s + 1) + " of molecules like molecule " +
                    std::to_string(kinds[k].first) + " has charges from " +
                    std::to_string(low[at]) + " to " + std::to_string(high[at]) +
                    "; molecules of one kind must have the same charges, so use other atom types "
                    "for molecules with other charges");
      of_kind.push_back(has_molecules ? low[at] : 0);
    }
  }
  return charges;
}

/// The box edges [nm] in directions with only one process. In these directions, images of bodies
/// need not be ghosts. In all other directions, the result is 0.
Vec3<double> PairPolhode::period(const Topology& topology) const {
  Vec3<double> edges;
  if (domain->triclinic != 0) return edges;
  const bool grid = comm->layout != LAMMPS_NS::Comm::LAYOUT_TILED;
  for (std::size_t d = 0; d < 3; ++d) {
    const bool alone = comm->nprocs == 1 || (grid && comm->procgrid[d] == 1);
    const double edge = units_.nm * domain->prd[d];
    if (alone && domain->periodicity[d] != 0 &&
        DomainForces::is_long_enough(edge, topology, settings_))
      edges[d] = edge;
  }
  return edges;
}

/// Arranges the bodies that are now on this process by kind, in the order of the fix.
void PairPolhode::arrange() {
  if (comm->get_comm_cutoff() < range_ + neighbor->skin)
    error->all(FLERR,
               "pair_style polhode: the communication cutoff is {}, too short for the molecules "
               "within the cutoff of the forces; set 'comm_modify cutoff {:.4g}' or more",
               comm->get_comm_cutoff(), range_ + neighbor->skin);
  const std::vector<Kind>& kinds = fix_->kinds();
  Topology own;
  std::vector<std::size_t> ghosts(kinds.size(), 0);
  for (Molecule& molecule : interacting_molecules(kinds, charges_, coefficients_, units_))
    own.parts.push_back({std::move(molecule), 0});
  const Vec3<double> edges = period(own);
  const auto is_needed = [&](const FixPolhode::GhostBody& ghost) {
    for (std::size_t d = 0; d < 3; ++d)
      if (edges[d] > 0 && ghost.image[d] != 0) return false;
    return fix_->computes_pairs_of(ghost);
  };
  for (const std::size_t kind : fix_->columns().bodies.part) ++own.parts[kind].count;
  ghost_order_.clear();
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    for (std::size_t g = 0; g < fix_->ghosts().size(); ++g)
      if (fix_->ghosts()[g].kind == static_cast<int>(kind) && is_needed(fix_->ghosts()[g])) {
        ++ghosts[kind];
        ghost_order_.push_back(g);
      }
  arrangement_ = fix_->arrangement();
  std::vector<std::size_t> counts = ghosts;
  for (const auto& part : own.parts) counts.push_back(part.count);
  const bool same_directions = periodic(edges) == periodic(edges_);
  if (forces_ && counts == counts_ && same_directions) {  // the neighbour list detects moved bodies
    if (edges != edges_) forces_->set_period(edges);
    edges_ = edges;
    return;
  }
  counts_ = std::move(counts);
  edges_ = edges;
  settings_.mixing = explicit_pairs(kinds, coefficients_, units_);
  forces_.emplace(own, ghosts, settings_, edges);
}

void PairPolhode::place_bodies() {
  const double nm = units_.nm;
  const State& own = fix_->columns().state;
  State& state = forces_->state();
  for (std::size_t i = 0; i < own.size(); ++i) {
    state.q.set(i, nm * own.q[i]);
    state.orientation.set(i, own.orientation[i]);
  }
  for (std::size_t g = 0; g < ghost_order_.size(); ++g) {
    const Pose pose = fix_->pose_of_ghost(ghost_order_[g]);
    state.q.set(own.size() + g, nm * pose.q);
    state.orientation.set(own.size() + g, pose.orientation);
  }
}

/// Sets the loads, as LAMMPS may compute the forces of a configuration again.
void PairPolhode::set_loads() {
  BodyColumns& columns = fix_->columns();
  const double unit = force->ftm2v;
  fix_->begin_pair_loads();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns.pair_load.f.set(i, unit * units_.nm * load_.f[i]);
    columns.pair_load.tau.set(i, unit * load_.tau[i]);
  }
  for (std::size_t g = 0; g < ghost_order_.size(); ++g) {
    const std::size_t i = columns.size() + g;
    fix_->add_pair_load_of_ghost(ghost_order_[g],
                                 {unit * units_.nm * load_.f[i], unit * load_.tau[i]});
  }
}

void PairPolhode::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (eflag_atom != 0 || vflag_atom != 0 || cvflag_atom != 0)
    error->all(FLERR,
               "pair_style polhode computes forces on molecules, so it has no per-atom energies "
               "and virials; remove computes such as pe/atom and stress/atom");
  guarded(error, style, [&] {
    if (!forces_ && is_part()) check_pairs_of_types();
    if (!forces_ || arrangement_ != fix_->arrangement()) arrange();
    place_bodies();
    (*forces_)(load_, evflag != 0);
  });
  set_loads();
  eng_vdwl = load_.van_der_waals;
  eng_coul = load_.coulomb;
  constexpr std::size_t index[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [a, b] = index[k];
    virial[k] = (load_.virial[a][b] + load_.virial[b][a]) / 2;
  }
}

}  // namespace polhode::lammps
