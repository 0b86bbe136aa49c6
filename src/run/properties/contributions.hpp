// SPDX-License-Identifier: MIT
// The data of the replicas of a state point, and which of them contribute to a value.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
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

/// The sums of segments, with a run for each replica.
/// @param segments_of  gives the segments of a contribution
/// @param sums_of      gives the sums of a segment
template <class SegmentsOf, class SumsOf>
std::vector<BlockMeans> runs_of(const Contributions& contributions, const SegmentsOf& segments_of,
                                const SumsOf& sums_of) {
  std::vector<BlockMeans> runs;
  for (const Contribution& contribution : contributions.all) {
    std::vector<BlockMeans::Block> run;
    for (const auto& segment : segments_of(contribution))
      run.push_back(std::invoke(sums_of, segment));
    runs.emplace_back(std::move(run));
  }
  return runs;
}
/// The runs, or all of them as a single run if one is too short for an error.
std::vector<BlockMeans> separate_or_joined(std::vector<BlockMeans> runs);
/// The step responses of runs, relative to a common first sample. Hybrid Monte Carlo has none.
/// @param response_of  gives the response of a segment, in one block
template <class SegmentsOf, class ResponseOf>
std::vector<StepResponse> responses_of(const Contributions& contributions,
                                       const SegmentsOf& segments_of,
                                       const ResponseOf& response_of) {
  std::vector<StepResponse> runs;
  for (const Contribution& contribution : contributions.all) {
    StepResponse run;
    for (const auto& segment : segments_of(contribution)) {
      const StepResponse& response = std::invoke(response_of, segment);
      if (response.first.empty()) break;
      if (run.blocks.blocks.empty()) run.first = response.first;
      run.blocks.blocks.push_back(response.blocks.blocks.front());
    }
    if (run.first.empty()) continue;
    run.blocks.samples_per_block = run.blocks.blocks.front().weight;
    runs.push_back(runs.empty() ? run : run.relative_to(runs.front().first));
  }
  return runs;
}
/// Subtracts a time-step bias from a value, if both are known.
void subtract_bias(MeasuredProperty& m, const SeriesEstimate& bias);
/// The box of the dynamics with its mean edges, or at constant pressure without dynamics. The edges
/// are 0 before any preparation.
Box box_of(const Contributions& contributions);

}  // namespace polhode
