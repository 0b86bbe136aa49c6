// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/separation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/run/simulation/contact.hpp"

namespace polhode {
namespace {

constexpr double h = 0.001;  // [ps]
constexpr std::size_t max_steps = 2000;

/// A vector, shortened to a length where it is longer.
Vec3<double> capped(const Vec3<double>& v, double max_length) {
  const double length = norm(v);
  return length > max_length ? (max_length / length) * v : v;
}

/// The translation and the rotation of one body in a step.
struct Move {
  Vec3<double> dq, dtheta;  ///< [nm], lab; [rad], body frame
  double size = 0;          ///< of the larger one, as the distance of a site [nm]
};

std::vector<Move> moves(const System& system, const Load& load) {
  std::vector<Move> all;
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Vec3<double> tau = to_body(system.state.attitude[i], load.tau[i]);
    Move move{h * h * system.bodies.inverse_m[i] * load.f[i],
              h * h * scaled(system.bodies.inverse_J[i], tau)};
    const double extent = system.topology.parts[system.bodies.part[i]].molecule.extent();
    move.size = std::max(norm(move.dq), extent * norm(move.dtheta));
    move.dq = capped(move.dq, max_separation_move);
    if (extent > 0) move.dtheta = capped(move.dtheta, max_separation_move / extent);
    all.push_back(move);
  }
  return all;
}

void apply(State& state, const std::vector<Move>& moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    state.q.add(i, moves[i].dq);
    state.attitude.set(i, normalized(state.attitude[i] * rodrigues(moves[i].dtheta)));
  }
}

}  // namespace

std::size_t separate_molecules(System& system, const std::function<bool()>& stop,
                               Workers& workers) {
  ForceSettings settings = system.forces;
  settings.precision =
      Precision::double_precision;  // energies of overlaps exceed the range of a float
  ForceField forces(system.topology, settings, system.state.box, workers);
  Load load(system.bodies.size());
  for (std::size_t steps = 0; steps < max_steps; ++steps) {
    forces(system.state, load);
    const std::vector<Move> next = moves(system, load);
    const bool gentle = std::all_of(next.begin(), next.end(), [](const Move& move) {
      return move.size <= max_separation_move;
    });
    if (gentle || (stop && stop())) return steps;
    apply(system.state, next);
  }
  throw RunError(
      fmt::format("molecules still overlap after they were moved apart in {} steps: {}; use a "
                  "lower density, or "
                  "another initial configuration",
                  max_steps, strongest_contact(system, system.state)));
}

}  // namespace polhode
