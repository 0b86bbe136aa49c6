// SPDX-License-Identifier: MIT
// The data of the replicas of a state point, and which of them contribute to a value.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "polhode/measure/step_response.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// The data of all replicas of a state point, with a description of the system.
struct PointData {
  const Topology& topology;
  const Mixing& mixing;
  StatePoint at;
  std::span<const Replica> replicas;
  std::function<bool()> stop{};  ///< ends long integrals if it returns true
  /// The second virial coefficient [nm³], which the caller keeps; computed each time without one.
  std::function<Estimate()> second_virial{};

  /// The means that the ensemble of the averages fixes.
  FixedMeans fixed_means() const {
    return at.constant_volume() ? FixedMeans::kinetic_energy
                                : FixedMeans::kinetic_energy_and_pressure;
  }
};

/// Whether each replica has at least as many segments in equilibrium as before it.
bool in_equilibrium(const PointData& data);

/// A replica that contributes to a value, with its first segment in equilibrium.
struct Contribution {
  const Replica* replica = nullptr;
  std::size_t from = 0;
};

/// The replicas that contribute to a value. Replicas that are not in equilibrium never contribute,
/// and replicas that are too short for an error only if all are.
struct Contributions {
  MeasuredIn what;
  std::vector<Contribution> all, too_short;
  std::size_t not_in_equilibrium = 0;

  Contributions(const PointData& data, MeasuredIn what);

  /// How many replicas contribute, and why the others do not; empty if all contribute.
  std::string text() const;
};

/// One run for each replica, or a single run if a replica is too short for an error.
std::vector<BlockMeans> separate_or_joined(std::vector<std::vector<BlockMeans::Block>> runs);
/// The averages in equilibrium, with a run for each replica.
std::vector<BlockMeans> averages_of(const Contributions& contributions);
/// The responses of segments of a replica, relative to their first sample.
using ResponsesOf = std::function<std::vector<const StepResponse*>(const Contribution&)>;
/// The step responses of runs, relative to a common first sample. Hybrid Monte Carlo has none.
std::vector<StepResponse> responses_of(const Contributions& contributions, const ResponsesOf& of);
/// The same, of the averages in equilibrium.
std::vector<StepResponse> responses_of(const Contributions& contributions);
/// Subtracts a time-step bias from a value, if both are known.
void subtract_bias(MeasuredProperty& m, const SeriesEstimate& bias);
/// The box of the dynamics with its mean edges, or at constant pressure without dynamics. The edges
/// are 0 before any preparation.
Box box_of(const Contributions& contributions);

}  // namespace polhode
