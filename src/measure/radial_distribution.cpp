// SPDX-License-Identifier: MIT
#include "polhode/measure/radial_distribution.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "polhode/base/error.hpp"
#include "polhode/base/memory.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/base/units.hpp"
#include "polhode/model/cell_width.hpp"

namespace polhode {
namespace {

std::string without_digits(std::string name) {
  const std::string whole = name;
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name.empty() ? whole : name;
}

bool names(const std::string& word, const Site& site) {
  return word == site.name || word == without_digits(site.name);
}

// A site of a frame, wrapped into the box.
struct PlacedSite {
  Vec3<double> r;
  std::uint32_t body, kind;
};

// Sites sorted by cells that are at least `reach` wide, or one cell along an edge, and not more
// than sites.
struct CellSort {
  std::array<std::size_t, 3> cells;
  std::vector<PlacedSite> sites;
  std::vector<std::size_t> first;  // of each cell, and the end

  CellSort(const std::vector<PlacedSite>& unsorted, const Box& box, double reach) {
    const double width =
        cell_width(box, reach, std::max(27.0, static_cast<double>(unsorted.size())));
    for (std::size_t k = 0; k < 3; ++k)
      cells[k] = std::max<std::size_t>(1, static_cast<std::size_t>(box.edge[k] / width));
    const auto cell_of = [&](const PlacedSite& site) {
      std::size_t cell = 0;
      for (std::size_t k = 3; k-- > 0;) {
        const auto n = static_cast<double>(cells[k]);
        const auto c = static_cast<std::size_t>(site.r[k] / box.edge[k] * n);
        cell = cell * cells[k] + std::min(c, cells[k] - 1);
      }
      return cell;
    };
    first.assign(cells[0] * cells[1] * cells[2] + 1, 0);
    for (const PlacedSite& site : unsorted) ++first[cell_of(site) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    sites.resize(unsorted.size());
    for (const PlacedSite& site : unsorted) sites[next[cell_of(site)]++] = site;
  }

  // The cell itself and its neighbours with higher numbers, each once even if a small box has few.
  std::set<std::size_t> later_neighbours(std::size_t cell) const {
    const std::array at = {cell % cells[0], cell / cells[0] % cells[1],
                           cell / (cells[0] * cells[1])};
    std::set<std::size_t> found;
    for (std::size_t z = 0; z < 3; ++z)
      for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
          const auto along = [&](std::size_t k, std::size_t step) {
            return (at[k] + cells[k] + step - 1) % cells[k];
          };
          const std::size_t other = (along(2, z) * cells[1] + along(1, y)) * cells[0] + along(0, x);
          if (other >= cell) found.insert(other);
        }
    return found;
  }
};

// The minimum image of the difference of two positions in the box.
Vec3<double> nearest(Vec3<double> d, const Vec3<double>& edge, const Vec3<double>& half) {
  for (std::size_t k = 0; k < 3; ++k)
    d[k] += d[k] > half[k] ? -edge[k] : d[k] < -half[k] ? edge[k] : 0.0;
  return d;
}

Vec3<double> wrapped(const Vec3<double>& r, const Vec3<double>& edge) {
  return {r.x - edge.x * std::floor(r.x / edge.x), r.y - edge.y * std::floor(r.y / edge.y),
          r.z - edge.z * std::floor(r.z / edge.z)};
}

struct Maximum {
  double place, height;  // in bins from the middle of bin 0; [1]
};

// The maximum of a polynomial fitted to the top of the highest peak.
Maximum top_of(std::span<const double> g) {
  constexpr double share = 0.9;  // the top is where g exceeds this fraction of its maximum
  const auto top = static_cast<std::ptrdiff_t>(std::max_element(g.begin(), g.end()) - g.begin());
  const auto at = [&](std::ptrdiff_t k) { return g[static_cast<std::size_t>(k)]; };
  const auto last = static_cast<std::ptrdiff_t>(g.size()) - 1;
  std::ptrdiff_t low = top, high = top;
  while (low > 0 && at(low - 1) > share * at(top)) --low;
  while (high < last && at(high + 1) > share * at(top)) ++high;
  low = std::max<std::ptrdiff_t>(0, std::min(low, top - 2));
  high = std::min(last, std::max(high, top + 2));
  const Eigen::Index points = high - low + 1, powers = std::min<Eigen::Index>(points, 4);
  Eigen::MatrixXd matrix(points, powers);
  Eigen::VectorXd right(points);
  for (Eigen::Index i = 0; i < points; ++i) {
    for (Eigen::Index j = 0; j < powers; ++j)
      matrix(i, j) = std::pow(static_cast<double>(low - top + i), j);
    right[i] = at(low + i);
  }
  const Eigen::VectorXd c = matrix.colPivHouseholderQr().solve(right);
  const auto value = [&](double x) {
    double sum = 0;
    for (Eigen::Index j = powers; j-- > 0;) sum = sum * x + c[j];
    return sum;
  };
  constexpr int parts = 2000;  // of the interval: much finer than a bin
  double best = static_cast<double>(low - top);
  for (int k = 1; k <= parts; ++k) {
    const double x = static_cast<double>(low - top) + static_cast<double>(high - low) * k / parts;
    if (value(x) > value(best)) best = x;
  }
  return {static_cast<double>(top) + best, value(best)};
}

// Rows of sites are distributed over this many tasks, each with its own histogram.
constexpr std::size_t tasks = 32;

std::size_t checked_bins(const RadialSettings& settings) {
  const double bins = settings.reach / settings.bin + 1e-9;
  require_memory(sizeof(std::uint64_t) * tasks * static_cast<double>(settings.pairs.size()) * bins,
                 fmt::format("g(r) histograms of {:.3g} bins", bins), "take wider bins");
  return static_cast<std::size_t>(bins);
}

}  // namespace

std::vector<SitePair> site_pairs(const Topology& topology) {
  std::vector<std::string> words;
  for (const auto& [molecule, count] : topology.parts)
    for (const Site& site : molecule.sites) {
      const std::string word = without_digits(site.name);
      if (site.mass > 0 && std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(word);
    }
  std::vector<SitePair> pairs;
  for (std::size_t a = 0; a < words.size(); ++a)
    for (std::size_t b = a; b < words.size(); ++b) pairs.push_back({words[a], words[b]});
  return pairs;
}

RadialDistribution::RadialDistribution(const Topology& topology, const RadialSettings& settings)
    : pairs_(settings.pairs),
      reach_(settings.reach),
      width_(settings.bin),
      bins_(checked_bins(settings)) {
  // Sites that are selected by the same names form a kind.
  std::vector<std::string> words, all_names;
  for (const SitePair& pair : pairs_) words.insert(words.end(), pair.begin(), pair.end());
  std::vector<std::vector<bool>> kinds;
  for (const auto& [molecule, count] : topology.parts) {
    auto& sites = sites_.emplace_back();
    bodies_.push_back(count);
    for (const Site& site : molecule.sites) {
      all_names.push_back(site.name);
      std::vector<bool> kind;
      for (const std::string& word : words) kind.push_back(names(word, site));
      if (std::find(kind.begin(), kind.end(), true) == kind.end()) continue;
      const auto known = std::find(kinds.begin(), kinds.end(), kind);
      sites.emplace_back(site.r, static_cast<std::size_t>(known - kinds.begin()));
      if (known == kinds.end()) kinds.push_back(kind);
    }
  }
  for (std::size_t w = 0; w < words.size(); ++w)
    if (std::none_of(kinds.begin(), kinds.end(), [&](auto& kind) { return kind[w]; }))
      throw Error(fmt::format("no site is named '{}'{} (there are: {})", words[w],
                              did_you_mean(words[w], all_names), listed(all_names)));

  // Weight of a pair of sites of two kinds: 1 if both selections are the same, else 1 for each
  // direction.
  counts_.assign(kinds.size(), std::vector<std::vector<Count>>(kinds.size()));
  for (std::size_t a = 0; a < kinds.size(); ++a)
    for (std::size_t b = 0; b < kinds.size(); ++b)
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const bool there = kinds[a][2 * p] && kinds[b][2 * p + 1];
        const bool back = kinds[b][2 * p] && kinds[a][2 * p + 1];
        const bool like = pairs_[p][0] == pairs_[p][1];
        const std::uint32_t times = like ? there : there + back;
        if (times > 0) counts_[a][b].push_back({p, times});
      }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    double first = 0, second = 0, within = 0;
    for (std::size_t part = 0; part < sites_.size(); ++part) {
      double a = 0, b = 0;
      for (const auto& [r, kind] : sites_[part])
        a += kinds[kind][2 * p], b += kinds[kind][2 * p + 1];
      const auto n = static_cast<double>(bodies_[part]);
      first += n * a, second += n * b, within += n * a * b;
    }
    const bool like = pairs_[p][0] == pairs_[p][1];
    pairs_of_sites_.push_back((first * second - within) / (like ? 2 : 1));
    sites_of_first_.push_back(first);
  }
}

void RadialDistribution::add(const State& state, Workers& workers) {
  const Vec3<double> edge = state.box.edge, half = edge / 2.0;
  // Half an edge, as rounded by text files, still counts as half.
  if (reach_ > state.box.shortest_edge() / 2 * (1 + 1e-6))
    throw Error(fmt::format(
        "the reach of {:g} nm is more than half of the shortest box edge ({:.4f} nm) at {:g} ps: "
        "beyond, not all images of a site count; ask for a shorter one",
        reach_, state.box.shortest_edge(), state.time));
  std::vector<PlacedSite> placed;
  std::size_t i = 0;
  for (std::size_t part = 0; part < sites_.size(); ++part)
    for (const std::size_t end = i + bodies_[part]; i < end; ++i)
      for (const auto& [r, kind] : sites_[part])
        placed.push_back({wrapped(state.q[i] + to_lab(state.attitude[i], r), edge),
                          static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(kind)});
  const CellSort sorted(placed, state.box, reach_);

  // Integers, so that the sum does not depend on the distribution over tasks.
  std::vector<std::vector<std::uint64_t>> histograms(tasks);
  std::vector<std::set<std::size_t>> near;
  for (std::size_t cell = 0; cell + 1 < sorted.first.size(); ++cell)
    near.push_back(sorted.later_neighbours(cell));
  const double reach2 = std::pow(static_cast<double>(bins_) * width_, 2);
  workers.each(tasks, [&](std::size_t task) {
    std::vector<std::uint64_t>& histogram = histograms[task];
    histogram.assign(pairs_.size() * bins_, 0);
    for (std::size_t cell = 0; cell < near.size(); ++cell)
      for (const std::size_t other : near[cell])
        for (std::size_t a = sorted.first[cell]; a < sorted.first[cell + 1]; ++a) {
          if (a % tasks != task) continue;
          const PlacedSite& one = sorted.sites[a];
          for (std::size_t b = other == cell ? a + 1 : sorted.first[other];
               b < sorted.first[other + 1]; ++b) {
            const PlacedSite& two = sorted.sites[b];
            const double r2 = norm2(nearest(one.r - two.r, edge, half));
            if (r2 >= reach2 || one.body == two.body) continue;
            const auto bin = std::min(bins_ - 1, static_cast<std::size_t>(std::sqrt(r2) / width_));
            for (const auto& [p, times] : counts_[one.kind][two.kind])
              histogram[p * bins_ + bin] += times;
          }
        }
  });
  std::vector<double> sample(pairs_.size() * bins_ + 1, 0.0);
  for (const auto& histogram : histograms)
    for (std::size_t k = 0; k < histogram.size(); ++k)
      sample[k] += static_cast<double>(histogram[k]);
  const double volume = state.box.volume();
  for (double& count : sample) count *= volume;
  sample.back() = volume;
  blocks_.add(sample);
}

double RadialDistribution::shell(std::size_t bin) const {
  const auto k = static_cast<double>(bin);
  return 4.0 / 3 * units::pi * (3 * k * (k + 1) + 1) * width_ * width_ * width_;
}

std::vector<double> RadialDistribution::curve(std::size_t pair,
                                              std::span<const double> mean) const {
  std::vector<double> g(bins_);
  for (std::size_t k = 0; k < bins_; ++k)
    g[k] = mean[pair * bins_ + k] / (pairs_of_sites_[pair] * shell(k));
  return g;
}

std::vector<double> RadialDistribution::neighbours(std::size_t pair,
                                                   std::span<const double> mean) const {
  const bool like = pairs_[pair][0] == pairs_[pair][1];
  std::vector<double> n(bins_);
  double sum = 0;
  for (std::size_t k = 0; k < bins_; ++k)
    n[k] = sum += mean[pair * bins_ + k] / mean.back() * (like ? 2 : 1) / sites_of_first_[pair];
  return n;
}

std::vector<Estimate> RadialDistribution::g(std::size_t pair) const {
  std::vector<Estimate> estimates = blocks_.means().estimates();
  std::vector<Estimate> g(bins_);
  for (std::size_t k = 0; k < bins_; ++k) {
    const double scale = 1 / (pairs_of_sites_[pair] * shell(k));
    const Estimate& counts = estimates[pair * bins_ + k];
    g[k] = {counts.value * scale, counts.error * scale};
  }
  return g;
}

std::vector<double> RadialDistribution::coordination(std::size_t pair) const {
  return neighbours(pair, blocks_.means().mean());
}

RadialDistribution::Peak RadialDistribution::first_peak(std::size_t pair) const {
  const BlockMeans means = blocks_.means();
  const auto top = [&](std::span<const double> mean) { return top_of(curve(pair, mean)); };
  Peak peak;
  peak.place = means.estimate(
      [&](std::span<const double> mean) { return (top(mean).place + 0.5) * width_; });
  peak.height = means.estimate([&](std::span<const double> mean) { return top(mean).height; });
  const std::vector<double> g = curve(pair, means.mean());
  const auto begin = g.begin() + static_cast<std::ptrdiff_t>(peak.place.value / width_);
  const auto reach = static_cast<std::ptrdiff_t>(1.6 * peak.place.value / width_);
  const auto end = g.begin() + std::min(reach, static_cast<std::ptrdiff_t>(bins_));
  if (begin >= end) return peak;
  const auto lowest = static_cast<std::size_t>(std::min_element(begin, end) - g.begin());
  peak.minimum = middle(lowest);
  peak.coordination =
      means.estimate([&](std::span<const double> mean) { return neighbours(pair, mean)[lowest]; });
  return peak;
}

}  // namespace polhode
