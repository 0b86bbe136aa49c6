// SPDX-License-Identifier: MIT
// A replica: an independent simulation of a state point, as a chain of segments. Each segment is a
// function of the state at its start and of its number, so a replica has the same bits however its
// segments are distributed over processes and sessions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"
#include "run/properties/property.hpp"

namespace polhode {

/// A part of the run at constant temperature and pressure.
struct AveragesSegment {
  BlockMeans::Block sums;  ///< of the averages, AverageOf, with the number of samples
  /// Means of U and of V in parts of the segment, from which the end of equilibration is found.
  std::vector<double> potentials{}, volumes{};
  StepResponse response;  ///< of the same, in one block
};

/// Correlation functions of dynamics, one after the other in the sums of a segment, `lags` each.
struct CorrelationsOfDynamics {
  explicit CorrelationsOfDynamics(const Topology& topology);
  static constexpr std::size_t momentum_flux = 0;  ///< of the integrals of five pressures, averaged
                                                   ///< over two "bodies" [(kJ/mol/nm³)² ps²]
  std::vector<std::size_t> displacement;           ///< of each kind of molecule [nm²]
  /// Second Legendre polynomial of each axis of each kind.
  std::vector<std::vector<std::size_t>> rotation;
  std::size_t count = 1;
};

/// The number of the pilot, which chooses the time step of all replicas of a point.
inline constexpr std::uint64_t pilot = 0xFFFFFFFF;

struct Replica {
  std::uint64_t index = 0;
  double step = 0;             ///< of its segments [ps]; 0 until it is prepared
  double compressibility = 0;  ///< for the moves of its barostat [nm³ mol/kJ]
  State state{0, Box{}};       ///< at the end of the last segment of averages
  std::vector<AveragesSegment> averages;
  std::optional<State> moving;              ///< at the end of the last segment of dynamics
  std::vector<BlockMeans::Block> dynamics;  ///< sums of CorrelationsOfDynamics, a block per segment

  bool prepared() const { return step > 0; }
};

/// Lengths in steps, so that they follow the motions of each kind of molecule.
inline constexpr std::size_t steps_of_averages = 1250, steps_of_sample = 10,
                             steps_of_shadow_sample = 50, parts_of_averages = 5,
                             steps_of_lags = 4000, lags = 400, windows_in_segment = 4;

/// What all replicas of a state point have in common.
struct ReplicaSettings {
  Config config;  ///< molecules, forces, temperature; its seed is that of all replicas
  StatePoint at;
  double max_bias = 0;  ///< of the potential energy by the time step, relative
  double step = 0;      ///< of all replicas [ps]; 0: chosen in the preparation, as of a pilot
  std::function<bool()> stop{};  ///< ends a segment, which is then not part of the replica
};

/// Prepares a replica: lattice or initial configuration, minimisation, NVT, NPT; a pilot then
/// chooses the time step.
/// @return  false if it was stopped, with the replica as it was
/// @throws RunError  if it blows up, or the molecules evaporate
bool prepare(Replica& replica, const ReplicaSettings& settings);
bool add_averages(Replica& replica, const ReplicaSettings& settings);
/// @param from  first segment of averages that is in equilibrium: the mean volume from there on is
///              that of the first segment of dynamics
bool add_dynamics(Replica& replica, const ReplicaSettings& settings, std::size_t from);

/// The first segment of averages in equilibrium: that of the potential energy and of the volume.
std::size_t equilibrated(const Replica& replica);

/// Time between lags of dynamics [ps].
inline double lag_interval(const Replica& replica) {
  return replica.step * static_cast<double>(steps_of_lags) / static_cast<double>(lags);
}

}  // namespace polhode
