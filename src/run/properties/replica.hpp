// SPDX-License-Identifier: MIT
// A replica: an independent simulation of a state point, as a chain of segments. A segment is a
// function of its number and of the state at its start. A replica is therefore bitwise identical
// for any distribution of its segments over processes and sessions.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measure/zero_frequency.hpp"
#include "polhode/forces/mesh/mesh_choice.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"
#include "run/properties/property.hpp"

namespace polhode {

/// Lengths of segments in steps, so that they scale with the time scale of the molecular motion.
inline constexpr std::size_t steps_of_averages = 1250, steps_of_sample = 10,
                             steps_of_shadow_sample = 50, samples_of_virials = 5,
                             parts_of_averages = 5, steps_of_lags = 4000, lags = 400,
                             windows_in_segment = 4;
/// The bins of the spectrum of the pressure, in modes of a segment of dynamics.
inline const ModeBins& pressure_bins() {
  static const ModeBins bins(steps_of_lags * windows_in_segment / 8);
  return bins;
}

/// A segment of the run at constant temperature and pressure.
struct AveragesSegment {
  BlockMeans::Block sums;  ///< sums in the order of AverageOf, and the number of samples
  /// Means of U and V in parts of the segment. They determine the end of equilibration.
  std::vector<double> potentials{}, volumes{};
  StepResponse response;  ///< time-step response of the same averages, in one block
};

/// Selects some of the sums of a segment of dynamics; empty if the segment lacks these sums.
using PartOfSums = std::function<std::span<const double>(std::span<const double>)>;

/// Indices of the correlation functions of dynamics. The sums of a segment contain the correlation
/// functions in this order. Each function has `lags` values. The spectrum of the pressure and the
/// sums of Distances follow.
struct CorrelationsOfDynamics {
  explicit CorrelationsOfDynamics(const Topology& topology);
  std::vector<std::size_t> displacement;  ///< mean-square displacement of each kind of molecule
                                          ///< [nm²]
  /// Second Legendre polynomial of each axis of each kind of molecule.
  std::vector<std::vector<std::size_t>> rotation;
  std::size_t count = 0;

  /// The correlation functions, followed by the spectrum of the pressure.
  PartOfSums functions() const;
  /// The spectrum among functions().
  std::span<const double> spectrum_in(std::span<const double> functions) const {
    return functions.subspan(count * lags, pressure_bins().size());
  }
  PartOfSums distances() const;
};

/// The number of the pilot replica. The pilot chooses the time step of all replicas of a state
/// point.
inline constexpr std::uint64_t pilot = 0xFFFFFFFF;

/// A segment of dynamics again, from the same start at half of the step.
struct PairedSegment {
  std::size_t of = 0;           ///< the segment of dynamics
  BlockMeans::Block half_step;  ///< the same sums
};

/// A chain of segments of dynamics.
struct DynamicsChain {
  std::optional<State> state;  ///< state at the end of the last segment; empty before the first
  std::vector<BlockMeans::Block> segments;
  std::vector<PairedSegment> paired;   ///< in the order of the segments
  std::optional<MeshChoice> meshes{};  ///< kept between segments to save time; not in the record
};

/// Numbers that are averaged at each stage of a coupling.
inline constexpr std::size_t coupling_sums = 3;

/// A segment at a stage of a coupling.
struct StageSegment {
  /// Sums of the acceptance function towards the stage before, of that towards the stage after, and
  /// of the volume [nm³]; in the first stage, of the inverse volume.
  BlockMeans::Block sums;
  StepResponse response;  ///< time-step response of the same averages, in one block
};

/// Chains of segments in which a molecule is coupled to all others, with a chain for each stage.
struct CoupledChains {
  CouplingPath path;           ///< stages; of a pilot, those that it has chosen
  double compressibility = 0;  ///< compressibility that sets the size of volume moves
                               ///< [nm³ mol/kJ]
  std::vector<State> states;   ///< states at the end of the last segments; empty before the first
  std::vector<std::vector<StageSegment>> segments;  ///< a segment at each stage
  std::optional<MeshChoice> meshes{};  ///< kept between segments to save time; not in the record
};

/// Averages of a segment of a slab. The density in each bin of its profile follows [u/nm³]. Slabs
/// of replicas have different volumes, so all of them are intensive.
enum SlabAverageOf : std::size_t {
  tension,          ///< surface tension of one surface [kJ/mol/nm²]
  normal_pressure,  ///< pressure normal to the surfaces [kJ/mol/nm³]
  liquid_density,   ///< density in the bins that are liquid [u/nm³]
  vapour_density,   ///< density in the bins that are vapour [u/nm³]
  slab_averages_count
};
/// Bins of the profile, from the middle of the slab to the middle of the vapour. The slab ends near
/// their middle. The first ones are liquid and the last ones vapour, far from the surfaces.
inline constexpr std::size_t bins_of_profile = 100, bins_of_liquid = 16, bins_of_vapour = 20;

struct SlabSegment {
  BlockMeans::Block sums;
  std::vector<double> potentials{};  ///< means of U in parts of the segment, for its equilibrium
  StepResponse response;             ///< time-step response of the averages, in one block
  /// Sums of the tangential pressure in each bin of the profile [kJ/mol/nm³]; empty for mixtures,
  /// and in records of earlier versions.
  BlockMeans::Block tangential{0, {}};
};

/// A chain of segments of a slab of the liquid.
struct SlabChain {
  std::optional<State> state;  ///< state at the end of the last segment; empty before the first
  std::vector<SlabSegment> segments;
  std::optional<MeshChoice> meshes{};  ///< kept between segments to save time; not in the record
};

struct Replica {
  std::uint64_t index = 0;
  double step = 0;             ///< time step of its segments [ps]; 0 until it is prepared
  double compressibility = 0;  ///< compressibility that sets the size of its first barostat moves
                               ///< [nm³ mol/kJ]
  State state{0, Box{}};       ///< state at the end of the last segment of averages
  Vec3Column start{};  ///< positions at the start of the first segment, in fractions of the edges;
                       ///< empty in records of earlier versions
  std::vector<AveragesSegment> averages;
  std::optional<MeshChoice> meshes{};  ///< kept between segments to save time; not in the record
  DynamicsChain dynamics{};            ///< sums of CorrelationsOfDynamics
  /// Sums of the mean-square displacements of the first kind of molecule along x, y and z [nm²], in
  /// the long box of OrthoBoXY, each with `lags` values.
  DynamicsChain elongated{};
  DynamicsChain conduction{};  ///< spectra of the heat flux in each of pressure_bins()
  CoupledChains coupled{};
  SlabChain slab{};

  bool prepared() const { return step > 0; }
};

/// Number of segments of averages of each replica before the first decision.
inline constexpr std::size_t first_averages = 24;
/// One segment of dynamics in eight is repeated at half of the step, which is a quarter more work.
inline constexpr std::size_t paired_every = 8;

/// Copies of the system in the long box of OrthoBoXY.
inline constexpr std::size_t elongated_copies = 3;

/// Settings that all replicas of a state point share.
struct ReplicaSettings {
  Config config;  ///< molecules, forces, temperature, and the seed of all replicas
  StatePoint at;
  double liquid_density = 0;    ///< estimated density of the liquid [u/nm³]
  double max_bias = 0;          ///< maximum relative time-step bias of the potential energy
  bool paired_runs = true;      ///< whether there are paired segments of dynamics
  Sampling sampling{};          ///< of averages, stages of a coupling and slabs
  std::string scheme = "hoa2";  ///< scheme of all runs but the preparation
  double given_step = 0;        ///< time step that was given [ps]; 0 if a pilot chooses it
  double step = 0;      ///< time step of all replicas [ps]; 0 for a pilot, which chooses the step
                        ///< during preparation
  CouplingPath path{};  ///< stages of a coupling of all replicas, which a pilot chooses
  std::function<bool()> stop{};  ///< ends a segment, which is then discarded
};

/// The settings from which the system of a state point is built: its lattice has the density of the
/// state point, of the configuration, or of the liquid.
Config configuration_of(const ReplicaSettings& settings);
/// Prepares a replica from a lattice or an initial configuration, by minimisation, and by stages at
/// constant volume and at constant pressure. A pilot then chooses the time step.
/// @return  false if it was stopped; the replica is then unchanged
/// @throws RunError  if the replica blows up, or the molecules evaporate or separate into two
/// phases
bool prepare(Replica& replica, const ReplicaSettings& settings);
/// Adds a segment of averages.
/// @throws RunError  as prepare(), and if the molecules do not move as in a liquid
bool add_averages(Replica& replica, const ReplicaSettings& settings);
/// Adds a segment of dynamics. The first one has the mean volume of the averages in equilibrium.
bool add_dynamics(Replica& replica, const ReplicaSettings& settings);
/// Adds a segment of dynamics in the long box. The first segment begins with three copies of the
/// system at its mean volume, one above the other, which are scaled to the shape of the box and
/// relaxed.
bool add_elongated(Replica& replica, const ReplicaSettings& settings);
/// Adds a segment of dynamics with its heat flux, from the same start as the first segment of
/// dynamics.
bool add_conduction(Replica& replica, const ReplicaSettings& settings);
/// The chain of a kind of dynamics; nothing for other kinds of run.
DynamicsChain* chain_of(Replica& replica, MeasuredIn kind);
inline const DynamicsChain* chain_of(const Replica& replica, MeasuredIn kind) {
  return chain_of(const_cast<Replica&>(replica), kind);
}
/// The number of segments of a kind of run.
std::size_t length_of(const Replica& replica, MeasuredIn kind);
/// Removes the segments of a kind of run after the first ones.
void shorten(Replica& replica, MeasuredIn kind, std::size_t segments);
/// The first segment of averages in which both the potential energy and the volume are in
/// equilibrium.
std::size_t equilibrated(const Replica& replica);
/// The first segment in equilibrium, from a quantity in parts of segments.
std::size_t equilibrium_of(const std::vector<double>& parts);

/// The interval between lags of correlation functions of dynamics [ps].
inline double lag_interval(const Replica& replica) {
  return replica.step * static_cast<double>(steps_of_lags) / static_cast<double>(lags);
}

}  // namespace polhode
