// SPDX-License-Identifier: MIT
#include "polhode/ensemble/barostat.hpp"

#include <array>
#include <cmath>

#include "ensemble/cell_rescaling.hpp"
#include "model/coupled_edges.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
namespace {

/// The pressure along the edges of a group of coupled edges [kJ/mol/nm³].
double pressure_along(const CoupledEdges& edges, const State& state, const Bodies& bodies,
                      const Load& load) {
  const Mat3<double> tensor = pressure_tensor(state, bodies, load);
  return mean_along(edges, {tensor[0][0], tensor[1][1], tensor[2][2]});
}

void scale(Component& column, double factor) {
  for (std::size_t i = 0; i < column.size(); ++i) column[i] *= factor;
}

}  // namespace

void scale_box(State& state, const CoupledEdges& edges, double factor, bool momenta) {
  const auto scale_along = [&](std::size_t k, Component& q, Component& p) {
    if (!edges[k]) return;
    state.box.edge[k] *= factor;
    scale(q, factor);
    if (momenta) scale(p, 1 / factor);
  };
  scale_along(0, state.q.x, state.p.x);
  scale_along(1, state.q.y, state.p.y);
  scale_along(2, state.q.z, state.p.z);
}

Barostat::Barostat(const BarostatSettings& settings, double temperature, const Bodies& bodies,
                   std::uint64_t seed)
    : settings_(settings), kT_(units::boltzmann * temperature), bodies_(bodies), seed_(seed) {}

bool Barostat::move(State& state, Load& load, const Evaluate& evaluate, std::uint64_t step) {
  const CoupledEdges& edges = settings_.edges[memory_.moves % settings_.edges.size()];
  if (memory_.moves++ == 0) memory_.edges = state.box.edge;
  before_ = state;
  const bool accepted = std::visit(
      [&](const auto& type) { return try_move(type, state, load, evaluate, edges, step); },
      settings_.type);
  memory_.decisions.add(std::array{accepted ? 1.0 : 0.0});
  if (accepted) ++memory_.accepted;
  return accepted;
}

bool Barostat::try_move(const CellRescaling& type, State& state, Load& load,
                        const Evaluate& evaluate, const CoupledEdges& edges, std::uint64_t step) {
  Random random(seed_, stream_of(RandomUse::cell_rescaling, {step, 0}));
  const CellEquation equation{settings_.pressure, settings_.compressibility, type.time_constant,
                              kT_};
  const double t = settings_.every, variance = equation.variance(t);
  const double V = state.box.volume(), lambda = std::sqrt(V);
  const double noise = std::sqrt(variance) * random.normal();
  const double moved =
      lambda + equation.drift(V, pressure_along(edges, state, bodies_, load)) * t + noise;
  if (!(moved > 0)) return false;
  const double factor = factor_of(edges, moved * moved / V);
  if (!keeps_shape(state, edges, factor)) return false;
  const double before = energies(state, bodies_, load).total();
  scale_box(state, edges, factor, true);
  evaluate_moved(state, evaluate);
  const double work = energies(state, bodies_, load_).total() - before;
  const double back =
      lambda - moved -
      equation.drift(state.box.volume(), pressure_along(edges, state, bodies_, load_)) * t;
  const double violation = work + settings_.pressure * (moved * moved - V) -
                           kT_ * std::log(moved / lambda) +
                           kT_ * (back * back - noise * noise) / (2 * variance);
  return decide(state, load, violation, type.metropolis ? work : work - violation, random.uniform(),
                !type.metropolis);
}

bool Barostat::try_move(const VolumeMoves&, State& state, Load& load, const Evaluate& evaluate,
                        const CoupledEdges& edges, std::uint64_t step) {
  Random random(seed_, stream_of(RandomUse::volume_move, {step, 0}));
  const double V = state.box.volume();
  const double first = Box{memory_.edges}.volume();
  const double max_change = 2 * std::sqrt(kT_ * settings_.compressibility * first);
  const double change = max_change * (2 * random.uniform() - 1);
  if (!(V + change > 0)) return false;
  const double factor = factor_of(edges, 1 + change / V);
  if (!keeps_shape(state, edges, factor)) return false;
  scale_box(state, edges, factor, false);
  evaluate_moved(state, evaluate);
  const double work = load_.potential() - load.potential();
  const double violation = work + settings_.pressure * change -
                           static_cast<double>(state.size()) * kT_ * std::log1p(change / V);
  return decide(state, load, violation, work, random.uniform(), false);
}

/// Whether a move keeps the shape of the box within bounds.
bool Barostat::keeps_shape(const State& state, const CoupledEdges& edges, double factor) {
  if (polhode::keeps_shape(settings_.edges, edges, factor, state.box.edge, memory_.edges,
                           max_shape_change))
    return true;
  ++memory_.beyond_shape;
  return false;
}

void Barostat::evaluate_moved(const State& state, const Evaluate& evaluate) {
  evaluate(state, load_);
  ++memory_.evaluations;
}

/// Accepts the new state and its Load, or restores the state and Load before the move.
bool Barostat::decide(State& state, Load& load, double violation, double work, double uniform,
                      bool always) {
  if (!always && !(uniform < std::exp(-violation / kT_))) {
    state = before_;
    return false;
  }
  std::swap(load, load_);
  memory_.work += work;
  return true;
}

}  // namespace polhode
