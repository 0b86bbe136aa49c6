// SPDX-License-Identifier: MIT
#include "run/properties/contributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "measure/equilibration.hpp"

namespace polhode {
namespace {

/// Whether a replica with `all` segments has at least as many in equilibrium as before it.
bool is_in_equilibrium(std::size_t before, std::size_t all) { return 2 * before <= all; }

}  // namespace

std::size_t equilibrated(const Replica& replica) {
  // The effort grows as n² √n with the number n of parts, so a long replica has longer parts.
  constexpr std::size_t max_parts = 600;
  const std::size_t joined = replica.averages.size() * parts_of_averages / max_parts + 1;
  std::size_t start = 0;
  for (const auto member : {&AveragesSegment::potentials, &AveragesSegment::volumes}) {
    std::vector<double> all, series;
    for (const AveragesSegment& segment : replica.averages)
      all.insert(all.end(), (segment.*member).begin(), (segment.*member).end());
    for (std::size_t k = 0; k + joined <= all.size(); k += joined)
      series.push_back(std::accumulate(&all[k], &all[k] + joined, 0.0) /
                       static_cast<double>(joined));
    if (std::ranges::all_of(series, [&](double x) { return x == series.front(); }))
      continue;  // the volume, where it is constant
    start = std::max(start, joined * equilibrium_start(series));
  }
  return (start + parts_of_averages - 1) / parts_of_averages;
}

bool in_equilibrium(const PointData& data) {
  return std::all_of(data.replicas.begin(), data.replicas.end(), [](const Replica& replica) {
    return is_in_equilibrium(equilibrated(replica), replica.averages.size());
  });
}

std::size_t length_of(const Replica& replica, MeasuredIn what) {
  return what == MeasuredIn::coupling ? replica.coupled.segments.size()
                                      : segments_of(replica, what).size();
}

const std::vector<BlockMeans::Block>& segments_of(const Replica& replica, MeasuredIn what) {
  return what == MeasuredIn::elongated ? replica.elongated.segments : replica.dynamics;
}

Contributions::Contributions(const PointData& data, MeasuredIn kind) : what(kind) {
  for (const Replica& replica : data.replicas) {
    const std::size_t from = equilibrated(replica), length = replica.averages.size();
    const bool is_long =
        what == MeasuredIn::averages ? length >= from + min_samples : length_of(replica, what) > 0;
    if (!is_in_equilibrium(from, length))
      ++not_in_equilibrium;
    else
      (is_long ? all : too_short).push_back({&replica, from});
  }
  if (all.empty()) all.swap(too_short);
}

std::string Contributions::text() const {
  if (too_short.empty() && not_in_equilibrium == 0) return "";
  const std::size_t replicas = all.size() + too_short.size() + not_in_equilibrium;
  std::string why;
  if (!too_short.empty()) why += fmt::format(", {} too short so far", too_short.size());
  if (not_in_equilibrium > 0) why += fmt::format(", {} not in equilibrium", not_in_equilibrium);
  return fmt::format("from {} of {} replicas{}", all.size(), replicas, why);
}

std::vector<BlockMeans> averages_of(const Contributions& contributions) {
  std::vector<BlockMeans> runs;
  for (const auto& [replica, from] : contributions.all) {
    std::vector<BlockMeans::Block> blocks;
    for (std::size_t k = from; k < replica->averages.size(); ++k)
      blocks.push_back(replica->averages[k].sums);
    runs.emplace_back(std::move(blocks));
  }
  return runs;
}

std::vector<StepResponse> responses_of(const Contributions& contributions) {
  std::vector<StepResponse> runs;
  for (const auto& [contribution, from] : contributions.all) {
    const Replica& replica = *contribution;
    if (replica.averages.empty()) continue;
    StepResponse run{.first = replica.averages.front().response.first, .blocks = {}};
    for (std::size_t k = from; k < replica.averages.size(); ++k)
      run.blocks.blocks.push_back(replica.averages[k].response.blocks.blocks.front());
    run.blocks.samples_per_block = run.blocks.blocks.empty() ? 1 : run.blocks.blocks[0].weight;
    runs.push_back(runs.empty() ? run : run.relative_to(runs.front().first));
  }
  return runs;
}

double edge_of(const Contributions& contributions) {
  double sum = 0, count = 0;
  for (const auto& [replica, from] : contributions.all) {
    if (!replica->prepared()) continue;
    sum += std::cbrt((replica->moving ? *replica->moving : replica->state).box.volume());
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

}  // namespace polhode
