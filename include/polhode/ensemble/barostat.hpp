// SPDX-License-Identifier: MIT
// Barostats: moves that change the box edges to control the pressure. Centres of mass are scaled,
// but orientations are not, so molecules stay rigid.
#pragma once

#include <cstdint>
#include <functional>

#include "polhode/measure/block_means.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Counters and sums that a barostat has accumulated so far.
struct BarostatMemory {
  double work = 0;       ///< work done on the bodies: changes of H by accepted moves [kJ/mol]
  Vec3<double> edges{};  ///< box edges at the first move [nm]
  std::uint64_t moves = 0, accepted = 0;
  TimeBlocks decisions;            ///< one entry for each move: 1 if accepted, 0 if rejected
  std::uint64_t evaluations = 0;   ///< number of force evaluations by barostat moves
  std::uint64_t beyond_shape = 0;  ///< moves rejected by max_shape_change
};

/// Bound on the change of the box shape: the largest ratio between the scaling factors of two
/// groups of edges since the first move. A fluid does not resist a change of shape. Without a
/// bound, the box shape would drift until an edge is too short for the cutoff. Moves beyond the
/// bound are rejected, so the distribution of box shapes within the bound is unchanged.
inline constexpr double max_shape_change = 1.2;

/// Scales box edges, and with them the centres of mass.
/// @param momenta  whether to scale the momenta by the inverse factors, which conserves phase-space
///   volume
void scale_box(State& state, const CoupledEdges& edges, double factor, bool momenta);

/// Moves the box, one group of edges at a time, with the stationary distribution exp(−(H + P₀V)/kT)
/// dV.
///
/// Stochastic cell rescaling [bernetti2020], with λ = √V: dλ = −(β λ/2τ) [P₀ − P − kT/(2V)] dt +
/// √(kT β/2τ) dW. P is the mean molecular pressure along the scaled edges. Momenta are scaled by
/// the inverse factors. A move is accepted with probability min(1, exp(−Δ/kT)), where Δ is the
/// violation of detailed balance by the move [roberts1996]. If `metropolis` is false, every move is
/// accepted. In this case Δ is the error of the move, and the work is the change of H minus Δ.
///
/// Monte Carlo: the volume change ΔV is uniform between ±δ with δ = 2 √(kT β V₀), where V₀ is the
/// volume at the first move. Momenta do not change. A move of N molecules is accepted with
/// probability min(1, exp(−(ΔU + P₀ΔV)/kT + N ln(V'/V))).
///
/// The total momentum is held at 0, and the centre of mass scales with the box. The volume of an
/// ideal gas of N molecules has the distribution Gamma(N, kT/P₀) with cell rescaling, and Gamma(N +
/// 1, kT/P₀) with Monte Carlo moves. Momenta have 3 N − 3 degrees of freedom.
class Barostat {
 public:
  /// Computes forces, energies and virial of a state.
  using Evaluate = std::function<void(const State&, Load&)>;

  /// @param bodies  masses of the bodies, kept by reference
  Barostat(const BarostatSettings& settings, double temperature, const Bodies& bodies,
           std::uint64_t seed);

  /// Tries one move.
  /// @param load  load of the state, with energies; updated if the state changes
  /// @param step  step of the trajectory, which selects the random numbers
  /// @return  whether the state has changed
  /// @throws Error  from `evaluate` if the box has become too small for the cutoff
  bool move(State& state, Load& load, const Evaluate& evaluate, std::uint64_t step);

  const BarostatMemory& memory() const { return memory_; }
  void resume_from(const BarostatMemory& memory) { memory_ = memory; }

 private:
  bool try_move(const CellRescaling& type, State& state, Load& load, const Evaluate& evaluate,
                const CoupledEdges& edges, std::uint64_t step);
  bool try_move(const VolumeMoves& type, State& state, Load& load, const Evaluate& evaluate,
                const CoupledEdges& edges, std::uint64_t step);
  bool keeps_shape(const State& state, const CoupledEdges& edges, double factor);
  void evaluate_moved(const State& state, const Evaluate& evaluate);
  bool decide(State& state, Load& load, double violation, double work, double uniform, bool always);

  BarostatSettings settings_;
  double kT_;
  const Bodies& bodies_;
  std::uint64_t seed_;
  BarostatMemory memory_;
  State before_;  // state before the move
  Load load_;     // load after the move
};

}  // namespace polhode
