// SPDX-License-Identifier: MIT
// This part of fix polhode determines which atoms form bodies, and where the bodies are.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "assembly.hpp"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_polhode.hpp"
#include "guarded.hpp"
#include "lammps_vectors.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "update.h"
#include "utils.h"

namespace polhode::lammps {
namespace {

// Before 2024 this function of LAMMPS did not have a parameter for the place of the call.
template <class Domain>
void to_minimum_image(const Domain& domain, Vec3<double>& r) {
  if constexpr (requires { domain.minimum_image_big(FLERR, r.x, r.y, r.z); })
    domain.minimum_image_big(FLERR, r.x, r.y, r.z);
  else
    domain.minimum_image_big(r.x, r.y, r.z);
}

// A kind with a number of molecules, such as "64 molecules of 3 atoms (types 1, 2, 2)".
std::string described(const Kind& kind, std::int64_t count) {
  const std::string number = std::to_string(count), sites = std::to_string(kind.types.size());
  if (kind.particle != 0)
    return number + " particles of type " + std::to_string(kind.particle) + " (" + sites +
           " sites)";
  if (kind.types.size() == 1)
    return number + " single atoms of type " + std::to_string(kind.types.front());
  std::string types;
  for (const int type : kind.types) types += (types.empty() ? "" : ", ") + std::to_string(type);
  return number + " rigid molecules of " + sites + " atoms (types " + types + ")";
}

}  // namespace

double FixPolhode::mass_of_atom(int i) const {
  return atom->rmass != nullptr ? atom->rmass[i] : atom->mass[atom->type[i]];
}

bool FixPolhode::is_massless(int type) const {
  const auto t = static_cast<std::size_t>(type);
  return t < settings_.massless.size() && settings_.massless[t];
}

double FixPolhode::mass_in_body(int i) const {
  return is_massless(atom->type[i]) ? 0 : mass_of_atom(i);
}

Vec3<double> FixPolhode::minimum_image(Vec3<double> r) const {
  to_minimum_image(*domain, r);
  return r;
}

BodyRecord FixPolhode::record(int body) const {
  const auto i = static_cast<std::size_t>(body);
  return i < columns_->size() ? columns_->record(i) : arrivals_[i - columns_->size()];
}

/// The body from which a periodic image is computed. The image of a local body is computed from the
/// local body, and the image of a ghost from the ghost, without messages.
FixPolhode::Origin FixPolhode::origin(int body) const {
  if (!is_ghost_body(body)) return {body};
  const GhostBody& image = ghost(body);
  if (image.process == comm->me) return {image.body, {image.image, image.shift}};
  if (image.base < 0) return {body};
  const auto base = static_cast<std::size_t>(image.base);
  std::array<int, 3> between = image.image;
  for (std::size_t d = 0; d < 3; ++d) between[d] -= ghosts_[base].image[d];
  return {static_cast<int>(columns_->size() + base), {between, image.shift - ghosts_[base].shift}};
}

Pose FixPolhode::pose(int body) const {
  if (!is_ghost_body(body)) return columns_->pose(static_cast<std::size_t>(body));
  const Origin from = origin(body);
  Pose shifted = pose_of_origin(from.body);
  shifted.q += from.shift.by;
  return shifted;
}

/// A lattice vector of the box.
Vec3<double> FixPolhode::edges_of_box(const std::array<int, 3>& count) const {
  const auto n = [&](std::size_t d) { return static_cast<double>(count[d]); };
  return {n(0) * domain->xprd + n(1) * domain->xy + n(2) * domain->xz,
          n(1) * domain->yprd + n(2) * domain->yz, n(2) * domain->zprd};
}

/// Assembles the molecules and creates a body for each molecule from its atoms, then moves the
/// atoms to the sites of the bodies.
void FixPolhode::recognise() {
  std::vector<AtomMessage> messages;
  std::vector<std::pair<int, BodyRecord>> particles;
  guarded(error, "fix polhode", [&] { find_kinds_of_particles(); });
  for (int i = 0; i < atom->nlocal; ++i) {
    if (const int k = kind_of_particle(i); k >= 0) {
      particles.emplace_back(i, body_of_particle(i, kinds_[static_cast<std::size_t>(k)]));
      continue;
    }
    const std::int64_t molecule = atom->molecule != nullptr ? atom->molecule[i] : 0;
    const bool inside = (atom->mask[i] & groupbit) != 0;
    if (molecule == 0 && !inside) continue;
    const bool owner = body_of(i) >= 0;
    messages.push_back(
        {molecule > 0 ? molecule : -static_cast<std::int64_t>(atom->tag[i]),
         {atom->tag[i], atom->type[i], mass_in_body(i), vector(atom->x[i]), vector(atom->v[i])},
         i,
         inside,
         owner,
         owner ? record(body_of(i)) : BodyRecord{}});
  }
  std::vector<SiteMessage> sites;
  guarded(error, "fix polhode", [&] {
    sites = assemble(
        messages, kinds_,
        {settings_.tolerance, phase_ != 0, [&](const Vec3<double>& r) { return minimum_image(r); }},
        world);
  });
  columns_ = std::make_unique<BodyColumns>(Topology{});
  arrivals_.clear();
  std::fill(info_.begin(), info_.end(), AtomInfo{});
  std::fill(body_of_.begin(), body_of_.end(), -1);
  for (const SiteMessage& site : sites) accept(site);
  for (const auto& [i, body] : particles) {
    info(i) = {kind_of_particle(i), 0, static_cast<std::int64_t>(atom->tag[i])};
    add_arrival(i, body);
  }
  recognised_ = true;
  sites_ = static_cast<LAMMPS_NS::bigint>(sites.size() + particles.size());
  MPI_Allreduce(MPI_IN_PLACE, &sites_, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  atoms_ = atom->natoms;
  has_all_atoms_ = sites_ == atoms_;
  if (sites_ == 0)
    error->all(FLERR,
               "fix polhode: the group has no atoms, but it must contain at least one molecule; "
               "define the fix after the atoms are created");
}

void FixPolhode::accept(const SiteMessage& site) {
  const int i = site.place;
  info(i) = {site.kind, site.site, site.owner};
  if (atom->tag[i] == site.owner) {
    body_of(i) = static_cast<int>(arrivals_.size());
    arrivals_.push_back(site.body);
  }
  const Vec3<double> x = vector(atom->x[i]);
  set(atom->x[i], x + minimum_image(site.x - x));
  set(atom->v[i], site.v);
}

/// Checks that the process of an atom has the atom's owner, or an image of the owner.
void FixPolhode::check_communication() const {
  double span = 0;
  for (const Kind& kind : kinds_) span = std::max(span, kind.span);
  const double cutoff = comm->get_comm_cutoff();
  if (cutoff > span) return;
  error->all(FLERR,
             "fix polhode: the communication cutoff, {}, is shorter than the longest molecule, {}, "
             "so a process may lack atoms of a molecule; set 'comm_modify cutoff {:.4g}' or more",
             cutoff, span, 1.001 * span);
}

/// Checks that no molecule moves so far in a step that LAMMPS would lose its atoms.
void FixPolhode::check_speeds() const {
  struct {
    double moved = 0;
    int process = 0;
  } fastest;
  std::uint64_t atom_of_fastest = 0;
  fastest.process = comm->me;
  for (std::size_t i = 0; i < columns_->size(); ++i) {
    const double moved = norm(columns_->velocity(i)) * update->dt;
    if (moved <= fastest.moved) continue;
    fastest.moved = std::isnan(moved) ? std::numeric_limits<double>::infinity() : moved;
    atom_of_fastest = columns_->numbers[i];
  }
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  constexpr double max_share = 0.1;  // in 10 fs at 300 K, water moves by less than 0.01 of it
  if (fastest.moved < max_share * comm->get_comm_cutoff()) return;
  MPI_Bcast(&atom_of_fastest, 1, MPI_UINT64_T, fastest.process, world);
  error->all(FLERR,
             "fix polhode: the run has become unstable at step {}: the molecule of atom {} moves "
             "by {:.3g} in a step; use a smaller timestep, or minimise the energy first, and "
             "compare the total energy at the start of the run",
             update->ntimestep, atom_of_fastest, fastest.moved);
}

/// Checks that no atoms of the group were created, and no atoms of bodies deleted, since
/// recognise().
void FixPolhode::check_number_of_atoms() {
  for (int i = 0; i < atom->nlocal; ++i)
    if (info(i).site < 0 && (atom->mask[i] & groupbit) != 0)
      error->one(FLERR,
                 "fix polhode: atom {} was created during a run, but the fix finds molecules only "
                 "at the start of a run; create atoms between runs (without 'run pre no'), or give "
                 "the fix a group without them",
                 atom->tag[i]);
  if (atom->natoms == atoms_) return;
  atoms_ = atom->natoms;
  LAMMPS_NS::bigint all = 0;
  for (int i = 0; i < atom->nlocal; ++i) all += info(i).kind >= 0 ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all == sites_) return;
  error->all(FLERR,
             "fix polhode: {} atoms of rigid molecules were deleted during a run; delete atoms "
             "between runs (without 'run pre no')",
             sites_ - all);
}

/// Prints how many molecules of each kind were found.
void FixPolhode::show_kinds() const {
  std::vector<double> counts(kinds_.size());
  for (int i = 0; i < atom->nlocal; ++i)
    if (body_of(i) >= 0) ++counts[static_cast<std::size_t>(info(i).kind)];
  MPI_Allreduce(MPI_IN_PLACE, counts.data(), static_cast<int>(counts.size()), MPI_DOUBLE, MPI_SUM,
                world);
  if (comm->me != 0) return;
  std::string text;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    if (counts[k] == 0) continue;
    text += text.empty() ? "fix polhode: " : ", ";
    text += described(kinds_[k], static_cast<std::int64_t>(counts[k]));
  }
  LAMMPS_NS::utils::logmesg(lmp, text + '\n');
}

void FixPolhode::pre_neighbor() {
  check_number_of_atoms();
  rebuild_columns();
  find_owners();
  ++arrangement_;
}

/// Rebuilds the columns with the bodies of the atoms that are now on this process, sorted by kind.
void FixPolhode::rebuild_columns() {
  std::vector<int> owners;
  for (int i = 0; i < atom->nlocal; ++i)
    if (body_of(i) >= 0) owners.push_back(i);
  std::ranges::stable_sort(owners, {}, [&](int i) { return info(i).kind; });
  Topology topology;
  for (const Kind& kind : kinds_) topology.parts.push_back({kind.molecule, 0});
  for (const int i : owners) ++topology.parts[static_cast<std::size_t>(info(i).kind)].count;
  auto columns = std::make_unique<BodyColumns>(topology);
  degrees_of_freedom_ = degrees_of_freedom(topology, TotalMomentum::free).all();
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const int i = owners[k];
    columns->set(k, record(body_of(i)));
    columns->numbers[k] = static_cast<std::uint64_t>(atom->tag[i]);
    body_of(i) = static_cast<int>(k);
  }
  columns_ = std::move(columns);
  arrivals_.clear();
  for (const int i : owners) wrap_to_owner(i);
}

/// Shifts a body by whole box edges, so that it is at the periodic image of its wrapped owner atom.
void FixPolhode::wrap_to_owner(int owner) {
  const auto body = static_cast<std::size_t>(body_of(owner));
  const Vec3<double> difference =
      vector(atom->x[owner]) - position(kind(owner), kind(owner).owner, columns_->pose(body));
  const Vec3<double> shift = difference - minimum_image(difference);
  if (norm2(shift) > 0) columns_->shift(body, shift);
}

/// The index of a shift in shifts_, which is extended if necessary.
int FixPolhode::index_of(const Shift& shift) {
  const auto found = std::ranges::find(shifts_, shift.edges, &Shift::edges);
  const auto index = static_cast<int>(found - shifts_.begin());
  if (found == shifts_.end()) shifts_.push_back(shift);
  return index;
}

/// Lists the site positions of all kinds. Returns the index of the first site of each kind.
std::vector<int> FixPolhode::list_sites() {
  site_positions_.clear();
  std::vector<int> first;
  for (const Kind& kind : kinds_) {
    first.push_back(static_cast<int>(site_positions_.size()));
    for (std::size_t site = 0; site < kind.types.size(); ++site)
      site_positions_.push_back(kind.atom(site));
  }
  return first;
}

/// Finds the image of the body that is next to each atom.
void FixPolhode::find_owners() {
  ghosts_.clear();
  const int all = atom->nlocal + atom->nghost;
  for (int i = atom->nlocal; i < all; ++i) body_of(i) = -1;
  sent_.clear();
  received_.clear();
  forward(Message::owners, 8);
  owners_.assign(static_cast<std::size_t>(atom->nlocal), {});
  shifts_.assign(1, {});
  const std::vector<int> first_site = list_sites();
  for (int i = 0; i < atom->nlocal; ++i) {
    if (info(i).kind < 0) continue;
    const double span = 1.001 * kind(i).span;  // tolerance that is larger than round-off
    const auto is_near = [&](int owner) {
      return owner >= 0 && body_of(owner) >= 0 &&
             norm2(vector(atom->x[i]) - vector(atom->x[owner])) <= span * span;
    };
    int owner = atom->map(static_cast<LAMMPS_NS::tagint>(info(i).owner));
    if (owner >= 0 && !is_near(owner)) owner = domain->closest_image(i, owner);
    if (!is_near(owner))
      error->one(FLERR,
                 "fix polhode: atom {} is not within {:.4g} of atom {} of the same rigid molecule; "
                 "the run has become unstable, or atoms were deleted or moved during the run",
                 atom->tag[i], span, info(i).owner);
    const Origin found = origin(body_of(owner));
    owners_[static_cast<std::size_t>(i)] = {
        found.body, index_of(found.shift),
        first_site[static_cast<std::size_t>(info(i).kind)] + info(i).site};
  }
  if (comm->nprocs > 1) find_uses();
  forward(Message::poses, 7);
}

/// Finds what the ghosts are used for, and reports their use to the processes of their bodies.
void FixPolhode::find_uses() {
  const auto set = [&](int body, Use use) {
    if (is_ghost_body(body)) ghost(body).use = std::max(ghost(body).use, use);
  };
  for (const Owner& owner : owners_)
    if (owner.body >= 0) set(owner.body, Use::atoms);
  if (has_pair_style_)
    for (std::size_t g = 0; g < ghosts_.size(); ++g)
      if (computes_pairs_of(ghosts_[g]))
        set(origin(static_cast<int>(columns_->size() + g)).body, Use::pairs);
  reverse(Message::uses, 1);
}

}  // namespace polhode::lammps
