// SPDX-License-Identifier: MIT
#include "run/properties/contributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "measure/equilibration.hpp"
#include "polhode/measure/step_bias.hpp"

namespace polhode {
namespace {

/// Whether a replica with `all` segments has at least as many in equilibrium as before it.
bool is_in_equilibrium(std::size_t before, std::size_t all) { return 2 * before <= all; }

}  // namespace

std::size_t equilibrium_of(const std::vector<double>& parts) {
  // The effort grows as n² √n with the number n of parts, so parts of a long series are joined.
  constexpr std::size_t max_parts = 600;
  const std::size_t joined = parts.size() / max_parts + 1;
  std::vector<double> series;
  for (std::size_t k = 0; k + joined <= parts.size(); k += joined)
    series.push_back(std::accumulate(&parts[k], &parts[k] + joined, 0.0) /
                     static_cast<double>(joined));
  if (std::ranges::all_of(series, [&](double x) { return x == series.front(); }))
    return 0;  // the volume, where it is constant
  const std::size_t start = joined * equilibrium_start(series);
  return (start + parts_of_averages - 1) / parts_of_averages;
}

std::size_t equilibrated(const Replica& replica) {
  std::size_t start = 0;
  for (const auto member : {&AveragesSegment::potentials, &AveragesSegment::volumes}) {
    std::vector<double> all;
    for (const AveragesSegment& segment : replica.averages)
      all.insert(all.end(), (segment.*member).begin(), (segment.*member).end());
    start = std::max(start, equilibrium_of(all));
  }
  return start;
}

bool in_equilibrium(const PointData& data) {
  return std::ranges::all_of(data.replicas, [](const Replica& replica) {
    return is_in_equilibrium(equilibrated(replica), replica.averages.size());
  });
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

std::vector<BlockMeans> separate_or_joined(std::vector<BlockMeans> runs) {
  const bool are_long = std::ranges::all_of(
      runs, [](const BlockMeans& run) { return run.blocks().size() >= min_samples; });
  if (are_long && !runs.empty()) return runs;
  std::vector<BlockMeans::Block> all;
  for (const BlockMeans& run : runs)
    all.insert(all.end(), run.blocks().begin(), run.blocks().end());
  return {BlockMeans(std::move(all))};
}

void subtract_bias(MeasuredProperty& m, const SeriesEstimate& bias) {
  if (m.value.known != Known::yes || bias.known != Known::yes) return;
  m.bias = bias;
  m.value = without_bias(m.value, bias);
}

Box box_of(const Contributions& contributions) {
  Vec3<double> sum{};
  double count = 0;
  for (const auto& [replica, from] : contributions.all) {
    if (!replica->prepared()) continue;
    sum += replica->dynamics.state ? replica->dynamics.state->box.edge : replica->state.box.edge;
    ++count;
  }
  return Box{count == 0 ? sum : sum / count};
}

}  // namespace polhode
