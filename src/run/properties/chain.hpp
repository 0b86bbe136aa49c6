// SPDX-License-Identifier: MIT
// A system at a state point, from which the segments of a replica are simulated.
#pragma once

#include <cstdint>
#include <optional>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// Streams of random numbers: for the preparation, and for each kind of segment.
enum Stream : std::uint64_t {
  preparing = 0,
  averaging = 1u << 20,
  moving = 2u << 20,
  pairing = 3u << 20,
  elongating = 4u << 20,
  elongated_pairing = 5u << 20,
  relaxing_elongated = 6u << 20,
  coupling = 7u << 20,
  choosing_stages = 8u << 20,
  relaxing_slab = 9u << 20,
  slab_averaging = 10u << 20,
  conducting = 11u << 20,
  conduction_pairing = 12u << 20
};

/// Minimisation of a configuration that is far from equilibrium.
inline constexpr MinimisationSettings relaxed_start{.force = 100, .torque = 10};
/// Scales the box and the centres of a state.
void scale_to(State& state, double volume);

/// A system at a state point, with its random numbers.
class Chain {
 public:
  /// @param meshes  errors of meshes for this system, which are kept between segments
  Chain(const ReplicaSettings& settings, const Replica& replica, std::optional<MeshChoice>& meshes);

  System& system() { return *system_; }
  const ReplicaSettings& settings() const { return settings_; }
  /// The seed of a stream of random numbers of the replica.
  std::uint64_t seed(std::uint64_t stream) const;

  TrajectorySettings trajectory(const Scheme& scheme, double step, double length,
                                std::uint64_t stream) const;
  /// Runs a trajectory that may blow up or be stopped.
  Trajectory attempt(const TrajectorySettings& t, Watch watch = {});
  /// Runs a trajectory.
  /// @return  the trajectory; empty if it was stopped
  /// @throws RunError  if it blows up, or if hybrid Monte Carlo rejects nearly all trajectories
  std::optional<Trajectory> run(const TrajectorySettings& t, Watch watch = {});
  /// The force settings of a run, with the mesh for the box of the state.
  ForceSettings force_settings();

 private:
  const ReplicaSettings& settings_;
  Config config_;
  std::optional<MeshChoice>& meshes_;
  std::optional<System> system_;
};

/// Scales the state of a chain to the mean volume of a replica in equilibrium at constant pressure.
void scale_to_mean(Chain& chain, const Replica& replica);
/// Stacks copies of a system along z.
void stack(System& system, std::size_t copies);
/// Stacks `elongated_copies` of a system along z, and scales them to the shape of the long box of
/// OrthoBoXY at the same density.
void elongate(System& system);
/// Makes stacked copies of the system of a replica. Their state is the last one of their segments.
/// Before the first segment, copies of the state at the mean volume are relaxed, with different
/// momenta.
/// @param last   state at the end of the last segment; empty before the first
/// @param make   stacks the copies
/// @return  false if it was stopped
bool begin_copies(Chain& chain, const Replica& replica, const std::optional<State>& last,
                  void (*make)(System&), std::uint64_t stream);

/// The trajectory of a segment of dynamics.
/// @param parts  of each step of the replica
TrajectorySettings segment_of_dynamics(const Chain& chain, double whole_step, std::size_t parts,
                                       std::uint64_t stream);
/// Simulates a segment from the state of the system, with a number of parts of each step of the
/// replica and a stream of random numbers; nothing if it was stopped.
using SegmentOfDynamics = std::optional<BlockMeans::Block>(Chain& chain, double whole_step,
                                                           std::size_t parts, std::uint64_t stream);
/// Adds a segment from the state of the system and, if it is due, its pair at half of the step.
/// @param stream, stream_of_pairs  the streams of the first segment and of its pair
/// @return  false if it was stopped; the chain of segments is then unchanged
bool extend(DynamicsChain& segments, Chain& chain, double step, std::uint64_t stream,
            std::uint64_t stream_of_pairs, SegmentOfDynamics& simulate);

/// The barostat of segments with a time step.
/// @param compressibility  compressibility that sets the size of its moves [nm³ mol/kJ]
BarostatSettings barostat(const ReplicaSettings& settings, double compressibility, double step);

/// The compressibility that sets the size of moves in the next segment of averages [nm³ mol/kJ].
/// It follows from the volume fluctuations of the later half of the segments, once this half lasts
/// eight relaxation times of the barostat. With a value far too small, the volume would relax so
/// slowly that segments are correlated; with a value far too large, moves would overshoot. The
/// value is therefore at most 16 times larger or smaller than that of the preparation. It changes
/// only when the number of segments has doubled. It is a function of these segments alone, so a
/// resumed replica has the same moves.
double compressibility_of_moves(const Replica& replica, const StatePoint& at);

/// The trajectory of a segment at the temperature, and at the pressure or the volume of the state
/// point.
/// @param compressibility  compressibility that sets the size of volume moves [nm³ mol/kJ]
TrajectorySettings averages_of(const Chain& chain, double compressibility, double step,
                               std::size_t steps, std::uint64_t stream);
/// The same, by the sampling of the settings. Each sample ends a trajectory of hybrid Monte Carlo.
TrajectorySettings sampling_of(const Chain& chain, double compressibility, double step,
                               std::size_t steps, std::uint64_t stream);

}  // namespace polhode
