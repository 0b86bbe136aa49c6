// SPDX-License-Identifier: MIT
// This part of fix polhode moves the box by stochastic cell rescaling, which holds the pressure.
//
// LAMMPS measures the pressure at the end of a step. The box is moved after the first kick of the
// next step, so that every kick has the forces of the box in which it acts.
#include <cmath>
#include <string>

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
#include "modify.h"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/math/random.hpp"
#include "update.h"

namespace polhode::lammps {

/// Creates the compute of the pressure, with a temperature of its own, as barostats of LAMMPS do.
void FixPolhode::create_pressure() {
  box_change |= BOX_CHANGE_SIZE;
  const std::string temperature = std::string(id) + "_temp";
  modify->add_compute(temperature + " all temp");
  pressure_ = modify->add_compute(std::string(id) + "_press all pressure " + temperature);
}

void FixPolhode::delete_pressure() {
  for (const char* const end : {"_press", "_temp"}) modify->delete_compute(std::string(id) + end);
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
  measured_pressure_ = pressure_->compute_scalar();
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
  double factor = std::cbrt(moved * moved / V);
  MPI_Bcast(&factor, 1, MPI_DOUBLE, 0, world);  // the same to the last bit
  scale_box(factor);
}

/// Scales the box about its centre, with the centres of mass and the atoms that are in no body, and
/// momenta by the inverse factor. Atoms of bodies follow when they are placed.
void FixPolhode::scale_box(double factor) {
  const Vec3<double> low = vector(domain->boxlo), high = vector(domain->boxhi);
  const Vec3<double> centre = 0.5 * (low + high);
  const auto scaled = [&](const Vec3<double>& x) { return centre + factor * (x - centre); };
  State& state = columns_->state;
  for (std::size_t i = 0; i < columns_->size(); ++i) {
    state.q.set(i, scaled(state.q[i]));
    state.p.set(i, (1 / factor) * state.p[i]);
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    if (info(i).kind >= 0) continue;
    set(atom->x[i], scaled(vector(atom->x[i])));
    set(atom->v[i], (1 / factor) * vector(atom->v[i]));
  }
  set(domain->boxlo, scaled(low));
  set(domain->boxhi, scaled(high));
  for (double* const tilt : {&domain->xy, &domain->xz, &domain->yz}) *tilt *= factor;
  domain->set_global_box();
  domain->set_local_box();
  for (GhostBody& ghost : ghosts_) ghost.shift = edges_of_box(ghost.image);
  for (Owner& owner : owners_) owner.shift = edges_of_box(owner.image);
  if (force->kspace != nullptr) force->kspace->setup();
  ++arrangement_;
}

}  // namespace polhode::lammps
