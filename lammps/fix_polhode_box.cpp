// SPDX-License-Identifier: MIT
// This part of fix polhode moves the box by stochastic cell rescaling, which holds the pressure.
//
// LAMMPS measures the pressure at the end of a step. The box is moved after the first kick of the
// next step, so that every kick has the forces of the box in which it acts.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "ensemble/cell_rescaling.hpp"
#include "error.h"
#include "fix_polhode.hpp"
#include "force.h"
#include "kspace.h"
#include "lammps_vectors.hpp"
#include "model/coupled_edges.hpp"
#include "modify.h"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/math/random.hpp"
#include "update.h"

namespace polhode::lammps {

/// Creates the compute of the pressure, with a temperature of its own, as barostats of LAMMPS do.
void FixPolhode::create_pressure() {
  constexpr int changes[] = {BOX_CHANGE_X, BOX_CHANGE_Y, BOX_CHANGE_Z};
  for (std::size_t k = 0; k < 3; ++k)
    if (scales(k)) box_change |= changes[k];
  const std::string temperature = std::string(id) + "_temp";
  modify->add_compute(temperature + " all temp");
  pressure_ = modify->add_compute(std::string(id) + "_press all pressure " + temperature);
}

void FixPolhode::delete_pressure() {
  for (const char* const end : {"_press", "_temp"}) modify->delete_compute(std::string(id) + end);
}

/// The group of edges that the next move scales.
const CoupledEdges& FixPolhode::edges_of_move() const {
  const BarostatArguments& b = *settings_.barostat;
  return b.edges[cycles_ / b.every % b.edges.size()];
}

/// Whether the barostat scales an edge.
bool FixPolhode::scales(std::size_t edge) const {
  const auto& groups = settings_.barostat->edges;
  return std::ranges::any_of(groups, [&](const CoupledEdges& group) { return group[edge]; });
}

/// Whether the next stage begins a step that moves the box.
bool FixPolhode::box_move_is_due() const {
  return settings_.barostat && phase_ == 0 && cycles_ % settings_.barostat->every == 0;
}

/// Has LAMMPS compute the virial at the end of the step before the next move.
void FixPolhode::request_pressure() {
  if (thermo_virial == 0)
    error->all(FLERR,
               "fix polhode: without the virial of the fix, which 'fix_modify {} virial no' leaves "
               "out, the pressure would contain forces within molecules; remove this command",
               id);
  const std::uint64_t size = program_.size(), interval = settings_.barostat->every * size;
  const std::uint64_t since = cycles_ % settings_.barostat->every * size + phase_;
  pressure_->addstep(update->ntimestep +
                     static_cast<LAMMPS_NS::bigint>((interval - since) % interval));
}

void FixPolhode::measure_pressure() {
  pressure_->compute_vector();
  measured_pressure_ = mean_along(edges_of_move(), vector(pressure_->vector));
  pressure_->addstep(update->ntimestep +
                     static_cast<LAMMPS_NS::bigint>(settings_.barostat->every * program_.size()));
}

void FixPolhode::move_box() {
  const BarostatArguments& b = *settings_.barostat;
  const double kT = force->mvv2e * bath_kT(), per_pressure = force->nktv2p;
  const CellEquation equation{b.pressure / per_pressure, b.compressibility * per_pressure,
                              b.time_constant, kT};
  const double V = domain->xprd * domain->yprd * domain->zprd, lambda = std::sqrt(V);
  const double t = static_cast<double>(b.every) * step();
  Random random(settings_.bath->seed, stream_of(RandomUse::cell_rescaling, {cycles_, 0}));
  const double moved = lambda + equation.drift(V, measured_pressure_ / per_pressure) * t +
                       std::sqrt(equation.variance(t)) * random.normal();
  // Noise changes the volume by √(2t/τ) of its fluctuations, which are 12 % for 64 molecules of an
  // ideal gas, and 3 % for water.
  constexpr double max_change = 0.25;
  if (!(std::abs(moved * moved / V - 1) < max_change))
    error->all(FLERR,
               "fix polhode: the pressure is {:.6g}, and the box would change its volume by the "
               "factor {:.3g} in one move; equilibrate at constant volume, or give pressure a "
               "larger time constant or a smaller compressibility",
               measured_pressure_, moved * moved / V);
  const CoupledEdges& edges = edges_of_move();
  double factor = factor_of(edges, moved * moved / V);
  MPI_Bcast(&factor, 1, MPI_DOUBLE, 0, world);  // the same to the last bit
  const Vec3<double> now{domain->xprd, domain->yprd, domain->zprd};
  if (first_edges_ == Vec3<double>{}) first_edges_ = now;
  if (keeps_shape(b.edges, edges, factor, now, first_edges_, max_shape_change))
    scale_box(edges, factor);
}

/// Scales edges of the box about its centre, with the centres of mass and the atoms that are in no
/// body, and momenta by the inverse factor. Atoms of bodies follow when they are placed.
void FixPolhode::scale_box(const CoupledEdges& edges, double factor) {
  const Vec3<double> low = vector(domain->boxlo), high = vector(domain->boxhi);
  const Vec3<double> centre = 0.5 * (low + high);
  Vec3<double> factors, inverse;
  for (std::size_t k = 0; k < 3; ++k) {
    factors[k] = edges[k] ? factor : 1;
    inverse[k] = 1 / factors[k];
  }
  const auto scaled = [&](const Vec3<double>& x) {
    return centre + componentwise(factors, x - centre);
  };
  State& state = columns_->state;
  for (std::size_t i = 0; i < columns_->size(); ++i) {
    state.q.set(i, scaled(state.q[i]));
    state.p.set(i, componentwise(inverse, state.p[i]));
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    if (info(i).kind >= 0) continue;
    set(atom->x[i], scaled(vector(atom->x[i])));
    set(atom->v[i], componentwise(inverse, vector(atom->v[i])));
  }
  set(domain->boxlo, scaled(low));
  set(domain->boxhi, scaled(high));
  domain->xy *= factors.x;
  domain->xz *= factors.x;
  domain->yz *= factors.y;
  domain->set_global_box();
  domain->set_local_box();
  for (GhostBody& ghost : ghosts_) ghost.shift = edges_of_box(ghost.image);
  for (Shift& shift : shifts_) shift.by = edges_of_box(shift.edges);
  if (force->kspace != nullptr) force->kspace->setup();
  ++arrangement_;
}

}  // namespace polhode::lammps
