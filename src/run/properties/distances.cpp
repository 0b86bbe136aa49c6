// SPDX-License-Identifier: MIT
#include "run/properties/distances.hpp"

#include <algorithm>
#include <string>

namespace polhode {
namespace {

constexpr double cutoff = 1.2, bin_width = 0.004;  // range and bins of g(r) [nm]
constexpr std::size_t max_pairs = 16;              // limits the size of records of large molecules
constexpr const char* centre = "centre of mass";

/// The molecules with their centres as another site.
Topology with_centres(const Topology& topology) {
  Topology all = topology;
  for (auto& [molecule, count] : all.parts) molecule.sites.push_back({.name = centre, .r = {}});
  return all;
}

std::vector<SitePair> pairs_of(const Topology& topology) {
  const Topology all = with_centres(topology);
  std::vector<std::string> kinds;
  for (const auto& [molecule, count] : topology.parts)
    if (std::ranges::find(kinds, molecule.name) == kinds.end()) kinds.push_back(molecule.name);
  std::vector<SitePair> pairs;
  const auto add = [&](const SitePair& pair) {
    if (pairs.size() < max_pairs && count_pairs(all, pair) > 0) pairs.push_back(pair);
  };
  for (std::size_t a = 0; a < kinds.size(); ++a)
    for (std::size_t b = a; b < kinds.size(); ++b)
      add({kinds[a] + ":" + centre, kinds[b] + ":" + centre});
  const bool atoms = std::ranges::all_of(
      topology.parts, [](const auto& part) { return part.molecule.top == Top::atom; });
  if (!atoms)  // the sites of atoms are their centres
    for (const SitePair& pair : site_pairs(topology)) add(pair);
  return pairs;
}

}  // namespace

Distances::Distances(const Topology& topology, std::size_t bins)
    : pairs_(pairs_of(topology)),
      radial_(with_centres(topology), {pairs_, bin_width * static_cast<double>(bins), bin_width}) {}

Distances Distances::within(const Topology& topology, const Box& box) {
  const double range = std::min(cutoff, box.shortest_edge() / 2);
  return {topology, static_cast<std::size_t>(range / bin_width)};
}

Distances Distances::of_sums(const Topology& topology, std::size_t size) {
  return {topology, (size - 1) / std::max<std::size_t>(1, pairs_of(topology).size())};
}

std::vector<double> Distances::means() const {
  const std::vector<double> mean = radial_.means();
  std::vector<double> sums(1 + pairs_.size() * bins());
  sums[0] = mean.back();
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    for (std::size_t k = 0; k < bins(); ++k) sums[index(p, k)] = mean[p * bins() + k];
  return sums;
}

std::vector<double> Distances::by_pair(Means means) const {
  std::vector<double> mean(pairs_.size() * bins() + 1);
  mean.back() = means[0];
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    for (std::size_t k = 0; k < bins(); ++k) mean[p * bins() + k] = means[index(p, k)];
  return mean;
}

std::vector<double> Distances::scales(std::size_t pair) const {
  return radial_.g(pair, std::vector<double>(pairs_.size() * bins() + 1, 1.0));
}

std::optional<Distances::Peak> Distances::first_peak(
    std::size_t pair, Means means, const RadialDistribution::Estimate& estimate) const {
  return radial_.first_peak(pair, by_pair(means), [&](const auto& f) {
    return estimate([&](Means part) { return f(by_pair(part)); });
  });
}

}  // namespace polhode
