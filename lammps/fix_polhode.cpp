// SPDX-License-Identifier: MIT
#include "fix_polhode.hpp"

#include <algorithm>
#include <utility>

#include "assembly.hpp"
#include "atom.h"
#include "checks.hpp"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "gathered.hpp"
#include "guarded.hpp"
#include "lammps_vectors.hpp"
#include "output.h"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/step.hpp"
#include "update.h"

namespace polhode::lammps {

using LAMMPS_NS::Atom;

FixPolhode::FixPolhode(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments)
    : Fix(lammps, count, arguments) {
  guarded(error, "fix polhode", [&] {
    settings_ = fix_settings(count - 3, arguments + 3, lammps);
    program_ = force_program(settings_.scheme);
  });
  columns_ = std::make_unique<BodyColumns>(Topology{});
  restart_global = restart_peratom = 1;
  time_integrate = rigid_flag = dof_flag = create_attribute = stores_ids = 1;
  virial_global_flag = virial_peratom_flag = thermo_virial = ecouple_flag = 1;
  scalar_flag = vector_flag = global_freq = extscalar = extvector = nevery = 1;
  size_vector = 3;
  comm_forward = 8;
  comm_reverse = 6;
  maxexchange = 5 + static_cast<int>(record_size);
  if (settings_.barostat) create_pressure();
  grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixPolhode::~FixPolhode() {
  if (pressure_ != nullptr) delete_pressure();
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixPolhode::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | FINAL_INTEGRATE | END_OF_STEP;
}

void FixPolhode::init() {
  if (atom->tag_enable == 0 || atom->map_style == Atom::MAP_NONE)
    error->all(FLERR,
               "fix polhode finds the atoms of a molecule by atom id, so LAMMPS must keep a map of "
               "ids; add 'atom_modify map yes'");
  if (has_particles() && force->pair_match("^polhode$", 0) == nullptr)
    error->all(FLERR,
               "fix polhode: the sites of particles are not atoms, so pair styles of LAMMPS do not "
               "compute their forces; use pair_style polhode");
  constexpr double smallest_lambda = 0.1;  // of differences that do not amplify other changes
  const bool amplifies = lambda_of_kicks().value_or(smallest_lambda) < smallest_lambda;
  guarded(error, "fix polhode", [&] { check_system(lmp, this, {program_.size(), amplifies}); });
  if (settings_.barostat) request_pressure();
  has_pair_style_ = force->pair_match("^polhode$", 0) != nullptr;
  half_step_velocities_ = needs_half_step_velocities(lmp, this);
  other_intervals_ = intervals_of_fixes(lmp, this);
  others_read_velocities_ = may_read_velocities(lmp, this);
}

std::optional<double> FixPolhode::lambda_of_kicks() const {
  if (std::ranges::all_of(program_, [](const ForceEvaluation& e) { return e.xi == 0; })) return {};
  return settings_.lambda;
}

void FixPolhode::setup_pre_exchange() {
  recognise();
  check_communication();
  virial_is_old_ = true;
}

void FixPolhode::setup(int vflag) {
  v_init(vflag);
  is_run_ = false;
  show_kinds();
  warn_of_particles_at_rest();
  collect_forces(columns_->load);
  tally_virial();
  if (box_move_is_due()) measure_pressure();
  if (has_pair_style_) set_forces();
}

// A rerun has this call after setup(), without initial_integrate(). The virial is out of date only
// if there was no setup().
void FixPolhode::end_of_step() {
  if (!is_run_ && has_particles())
    error->all(FLERR,
               "fix polhode: rerun reads no orientations of particles, so energies would be wrong; "
               "represent each site by an atom");
  if (!virial_is_old_) return;
  collect_forces(columns_->load);
  tally_virial();
}

/// The flows that act on the columns of bodies. When a gradient kick by finite difference is
/// applied, the forces at the displaced positions are already known.
struct FixPolhode::Flows {
  FixPolhode& fix;
  BodyColumns& columns;

  void drift(double t) { polhode::drift(columns.state, columns.bodies, t); }
  void kick(double t) { polhode::kick(columns.state, columns.bodies, columns.load, t); }
  /// Adds a gradient kick [vanzon2008, Eqs. 4 to 6].
  void kick(double t, double, Gradient) {
    const double lambda = fix.settings_.lambda;
    kick(t);
    polhode::kick(columns.state, columns.bodies, columns.displaced_load, t / lambda);
    polhode::kick(columns.state, columns.bodies, columns.load, -t / lambda);
  }
  void bath(double t, StageNumber at) { fix.bath(t, at); }
};

namespace {

std::size_t first_kick(const Scheme& scheme) {
  const auto stages = scheme.stages();
  const auto is_kick = [](const Stage& stage) { return stage.flow == Flow::kick; };
  return static_cast<std::size_t>(std::ranges::find_if(stages, is_kick) - stages.begin());
}

}  // namespace

double FixPolhode::step() const { return static_cast<double>(program_.size()) * update->dt; }

void FixPolhode::play_stages(std::size_t first, std::size_t end) {
  Flows flows{*this, *columns_};
  play(settings_.scheme.stages().subspan(first, end - first), flows, step(), {cycles_, first});
}

void FixPolhode::initial_integrate(int vflag) {
  v_init(vflag);
  if (update->ntimestep == update->firststep + 1)
    guarded(error, "fix polhode", [&] { check_intervals(lmp, this, program_.size(), phase_); });
  is_run_ = true;
  const ForceEvaluation& evaluation = program_[phase_];
  if (box_move_is_due()) {
    const std::size_t kick = first_kick(settings_.scheme);
    play_stages(0, kick + 1);
    move_box();
    play_stages(kick + 1, evaluation.use);
  } else {
    play_stages(evaluation.first, evaluation.use);
  }
  if (evaluation.xi != 0) begin_displacement(evaluation.xi);
  forward(Message::poses, 7);
  place_atoms();
  if (half_step_velocities_) set_velocities();
}

void FixPolhode::final_integrate() {
  const ForceEvaluation& evaluation = program_[phase_];
  collect_forces(evaluation.xi != 0 ? columns_->displaced_load : columns_->load);
  if (evaluation.xi != 0) end_displacement();
  play_stages(evaluation.use, evaluation.end);
  if (++phase_ < program_.size()) return;
  phase_ = 0;
  ++cycles_;
  velocities_are_old_ = true;
  if (velocities_are_read()) set_velocities();
  if (vflag_either != 0) tally_virial();
  if (box_move_is_due()) measure_pressure();
  if (has_pair_style_ && output_is_due()) set_forces();
}

/// Whether anything may read the velocities of atoms before the end of the next step.
bool FixPolhode::velocities_are_read() const {
  return program_.size() > 1 || others_read_velocities_ || vflag_either != 0 || box_move_is_due() ||
         output_is_due();
}

/// A run can end within a step of the scheme, for example at a time limit.
void FixPolhode::post_run() {
  if (velocities_are_old_) set_velocities();
  if (phase_ == 0 || comm->me != 0) return;
  error->warning(FLERR,
                 "fix polhode: the run ended after {} of {} force evaluations of a step, so "
                 "positions and velocities belong to different times now; continue with 'run' to "
                 "the end of the step",
                 phase_, program_.size());
}

/// Displaces the bodies [vanzon2008, Eq. 7].
void FixPolhode::begin_displacement(double xi) {
  BodyColumns& c = *columns_;
  c.kept_q = c.state.q;
  c.kept_orientation = c.state.orientation;
  displace(c.state, c.bodies, c.load, 2 * xi * settings_.lambda * step() * step());
}

void FixPolhode::end_displacement() {
  columns_->state.q = columns_->kept_q;
  columns_->state.orientation = columns_->kept_orientation;
}

void FixPolhode::place_atoms() {
  int body = -1;  // whose pose is known; the atoms of a molecule are usually next to each other
  Vec3<double> q{};
  Mat3<double> to_lab{};
  for (int i = 0; i < atom->nlocal; ++i) {
    const Owner& of = owner(i);
    if (of.body < 0) continue;
    if (of.body != body) {
      body = of.body;
      const Pose pose = pose_of_origin(body);
      q = pose.q, to_lab = transpose(matrix_S(pose.orientation));
    }
    set(atom->x[i], q + shift(of) + to_lab * site_position(of));
  }
}

/// Collects the force Σ f and the torque Σ s × f of the sites of every body, and the forces that a
/// pair style has added to bodies.
void FixPolhode::collect_forces(Load& load) {
  begin_loads(load);
  collecting_ = &load;
  for (int i = 0; i < atom->nlocal; ++i) {
    const Vec3<double> f = force->ftm2v * vector(atom->f[i]);
    if (f == Vec3<double>{}) continue;  // true for most inputs with pair_style polhode
    if (owner(i).body < 0) continue;
    add_load(owner(i).body, {f, cross(vector(atom->x[i]) - centre(owner(i)), f)}, load,
             &GhostBody::load);
  }
  if (bodies_extend_over_atoms() || (comm->nprocs > 1 && has_pair_style_))
    reverse(Message::loads, 6);
  virial_is_old_ = false;
}

bool FixPolhode::computes_pairs_of(const GhostBody& ghost) const {
  for (const int edges : ghost.image)
    if (edges != 0) return edges > 0;
  return ghost.process > comm->me;
}

void FixPolhode::begin_pair_loads() {
  has_pair_loads_ = true;
  each_used_ghost([](GhostBody& body) { body.pair_load = {}; });
}

/// Sets a load and the loads of ghosts to those from pair_style polhode, or to 0 if the pair style
/// has computed none since the last call.
void FixPolhode::begin_loads(Load& load) {
  if (has_pair_loads_) {
    std::swap(load, columns_->pair_load);
    each_used_ghost([](GhostBody& body) { body.load = body.pair_load; });
  } else {
    for (Vec3Column* const column : {&load.f, &load.tau})
      for (std::size_t d = 0; d < 3; ++d) std::ranges::fill(column->component(d), 0.0);
    each_used_ghost([](GhostBody& body) { body.load = {}; });
  }
  has_pair_loads_ = false;
}

void FixPolhode::add_pair_load_of_ghost(std::size_t index, const BodyLoad& load) {
  const int body = origin(static_cast<int>(columns_->size() + index)).body;
  add_load(body, load, columns_->pair_load, &GhostBody::pair_load);
}

/// Adds forces and torques on a body to those of the columns, or of the ghost.
void FixPolhode::add_load(int body, const BodyLoad& added, Load& own,
                          BodyLoad GhostBody::*of_ghost) {
  if (is_ghost_body(body)) {
    BodyLoad& to = ghost(body).*of_ghost;
    to.f += added.f;
    to.tau += added.tau;
  } else {
    own.f.add(static_cast<std::size_t>(body), added.f);
    own.tau.add(static_cast<std::size_t>(body), added.tau);
  }
}

FixPolhode::Motion FixPolhode::motion(int body) const {
  const int from = is_ghost_body(body) ? origin(body).body : body;
  if (is_ghost_body(from)) return ghost(from).motion;
  const auto i = static_cast<std::size_t>(from);
  if (sends_accelerations_)
    return {columns_->bodies.inverse_m[i] * columns_->load.f[i],
            columns_->angular_velocity_of(i, columns_->load.tau[i])};
  return {columns_->velocity(i), columns_->angular_velocity(i)};
}

bool FixPolhode::output_is_due() const {
  const LAMMPS_NS::bigint now = update->ntimestep;
  return now == output->next ||
         std::ranges::any_of(other_intervals_, [&](int interval) { return now % interval == 0; });
}

/// With pair_style polhode, whose forces act on molecules: sets the force on each atom to its mass
/// times the acceleration of its site, without the centripetal part. These forces have the total
/// force and the total torque of the molecule, but no other pair style would compute them.
void FixPolhode::set_forces() {
  sends_accelerations_ = true;
  forward(Message::motions, 6);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (owner(i).body < 0) continue;
    const Motion m = motion(owner(i).body);
    const Vec3<double> s = vector(atom->x[i]) - centre(owner(i));
    const bool is_particle = kind(i).particle != 0;
    const double mass = is_particle ? kind(i).molecule.mass : mass_in_body(i);
    set(atom->f[i], (mass / force->ftm2v) * (m.velocity + cross(m.angular_velocity, s)));
  }
  sends_accelerations_ = false;
}

void FixPolhode::set_velocities() {
  velocities_are_old_ = false;
  set_particle_columns();
  forward(Message::motions, 6);
  motions_.clear();
  for (std::size_t body = 0; body < columns_->size(); ++body)
    motions_.push_back(motion(static_cast<int>(body)));
  for (int i = 0; i < atom->nlocal; ++i) {
    if (owner(i).body < 0) continue;
    const bool here = !is_ghost_body(owner(i).body);
    const Motion m =
        here ? motions_[static_cast<std::size_t>(owner(i).body)] : ghost(owner(i).body).motion;
    const Vec3<double> s = vector(atom->x[i]) - centre(owner(i));
    set(atom->v[i], m.velocity + cross(m.angular_velocity, s));
  }
}

/// Adds the terms that convert the virial and temperature of atoms to the virial and temperature of
/// molecules. These terms are −Σ s ⊗ f, symmetrized, and −Σ m ṡ ⊗ ṡ, where ṡ is the velocity of a
/// site relative to the centre.
void FixPolhode::tally_virial() {
  std::fill_n(virial, 6, 0.0);
  forward(Message::motions, 6);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (owner(i).body < 0) continue;
    const Vec3<double> s = vector(atom->x[i]) - centre(owner(i)), f = vector(atom->f[i]);
    const Vec3<double> u = vector(atom->v[i]) - motion(owner(i).body).velocity;
    const double m = force->mvv2e * mass_of_atom(i);
    const auto term = [&](std::size_t a, std::size_t b) {
      return (s[a] * f[b] + s[b] * f[a]) / 2 + m * u[a] * u[b];
    };
    constexpr std::size_t index[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (std::size_t k = 0; k < 6; ++k) {
      const double t = term(index[k][0], index[k][1]);
      virial[k] -= t;
      if (vflag_atom != 0) vatom[i][k] -= t;
    }
  }
}

/// Bodies of which some atoms are in a group and others are not, as ids of their owner atoms.
std::set<std::int64_t> FixPolhode::bodies_partly_in(int bit) const {
  std::vector<std::int64_t> outside;
  for (int i = 0; i < atom->nlocal; ++i)
    if (info(i).kind >= 0 && (atom->mask[i] & bit) == 0) outside.push_back(info(i).owner);
  const std::vector<std::int64_t> all = gathered(outside, world);
  const std::set<std::int64_t> left_out(all.begin(), all.end());
  std::vector<std::int64_t> partly;
  for (int i = 0; i < atom->nlocal; ++i)
    if (info(i).kind >= 0 && (atom->mask[i] & bit) != 0 && left_out.contains(info(i).owner))
      partly.push_back(info(i).owner);
  const std::vector<std::int64_t> found = gathered(partly, world);
  return {found.begin(), found.end()};
}

/// Degrees of freedom that rigidity removes from a group. As in LAMMPS, none are removed from a
/// molecule that is only partly in the group.
LAMMPS_NS::bigint FixPolhode::dof(int group) {
  if (!recognised_) recognise();
  const int bit = 1 << group;
  const std::set<std::int64_t> partly = bodies_partly_in(bit);
  if (!partly.empty() && comm->me == 0)
    error->warning(FLERR,
                   "fix polhode: a temperature is computed of parts of {} rigid molecules, whose "
                   "atoms are not independent",
                   partly.size());
  LAMMPS_NS::bigint removed = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (body_of(i) < 0 || (atom->mask[i] & bit) == 0) continue;
    if (kind(i).particle != 0) continue;  // to LAMMPS a particle is an atom, which does not rotate
    if (partly.contains(info(i).owner)) continue;
    const Molecule& molecule = kind(i).molecule;
    const auto sites = static_cast<LAMMPS_NS::bigint>(molecule.sites.size());
    removed += 3 * sites - (molecule.top == Top::atom ? 3 : molecule.top == Top::linear ? 5 : 6);
  }
  MPI_Allreduce(MPI_IN_PLACE, &removed, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return removed;
}

/// Returns minus the energy that the bath has given to the bodies. The total energy minus the
/// energy given by the bath is a conserved quantity.
double FixPolhode::compute_scalar() { return -heat_; }

/// Returns the kinetic energy of translation or of rotation, or the number of bodies.
double FixPolhode::compute_vector(int n) {
  double sum = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int body = body_of(i);
    if (body < 0) continue;
    const BodyRecord b = record(body);
    const Kind& k = kind(i);
    if (n == 0) sum += force->mvv2e * norm2(b.p) / (2 * k.molecule.mass);
    if (n == 1) sum += force->mvv2e * rotational_energy(k, b);
    if (n == 2) sum += 1;
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

double FixPolhode::memory_usage() {
  constexpr std::size_t of_body = sizeof(BodyRecord) + 14 * sizeof(double);
  return static_cast<double>(info_.size() * (sizeof(AtomInfo) + sizeof(int)) +
                             columns_->size() * of_body + ghosts_.size() * sizeof(GhostBody));
}

}  // namespace polhode::lammps
