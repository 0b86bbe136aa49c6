// SPDX-License-Identifier: MIT
#include "polhode/measure/radial_distribution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/memory.hpp"
#include "base/suggest.hpp"
#include "model/cell_list.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

std::string without_digits(std::string name) {
  const std::string whole = name;
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name.empty() ? whole : name;
}

bool names(const std::string& word, const Molecule& molecule, const Site& site) {
  const std::string prefix = molecule.name + ":";
  const std::string name = word.starts_with(prefix) ? word.substr(prefix.size()) : word;
  return name == site.name || name == without_digits(site.name);
}

// The number of selected sites of a molecule.
double count_sites(const std::string& word, const Molecule& molecule) {
  return static_cast<double>(std::ranges::count_if(
      molecule.sites, [&](const Site& site) { return names(word, molecule, site); }));
}

double count_sites(const std::string& word, const Topology& topology) {
  double count = 0;
  for (const auto& [molecule, molecules] : topology.parts)
    count += static_cast<double>(molecules) * count_sites(word, molecule);
  return count;
}

// A site of a frame, wrapped into the box.
struct WrappedSite {
  Vec3<double> r;
  std::uint32_t body, kind;
};

// The minimum image of the difference of two positions in the box.
Vec3<double> nearest(Vec3<double> d, const Vec3<double>& edge, const Vec3<double>& half) {
  for (std::size_t k = 0; k < 3; ++k)
    d[k] += d[k] > half[k] ? -edge[k] : d[k] < -half[k] ? edge[k] : 0.0;
  return d;
}

// The range of bins to which a cubic is fitted.
struct Bins {
  std::ptrdiff_t low, high;
};

// The function g, smoothed: each bin is averaged with all bins whose distance differs by at most
// 1.5 %. Averaging keeps the noise of single bins from affecting the search for peaks.
std::vector<double> smoothed(std::span<const double> g) {
  constexpr double part = 0.015;
  std::vector<double> smooth(g.size());
  for (std::size_t k = 0; k < g.size(); ++k) {
    const auto wide = static_cast<std::size_t>(std::lround(part * static_cast<double>(k)));
    const std::size_t low = k - wide, end = std::min(g.size(), k + wide + 1);
    for (std::size_t i = low; i < end; ++i) smooth[k] += g[i] / static_cast<double>(end - low);
  }
  return smooth;
}

// The bin of the first peak. The search begins at the first distance at which g is close to its
// maximum. The search ends where g has fallen to half of the peak height, because a second peak may
// be equally high.
std::ptrdiff_t first_summit(std::span<const double> g) {
  constexpr double near = 0.75, fallen = 0.5;
  const double largest = *std::ranges::max_element(g);
  auto top = std::ranges::find_if(g, [&](double x) { return x >= near * largest; });
  for (auto k = top; k != g.end() && *k >= fallen * *top; ++k)
    if (*k > *top) top = k;
  return top - g.begin();
}

// The bins around a maximum in which g is above 90 % of the maximum; at least five bins.
Bins about_summit(std::span<const double> g, std::ptrdiff_t top) {
  constexpr double share = 0.9;
  const auto at = [&](std::ptrdiff_t k) { return g[static_cast<std::size_t>(k)]; };
  const auto last = static_cast<std::ptrdiff_t>(g.size()) - 1;
  std::ptrdiff_t low = top, high = top;
  while (low > 0 && at(low - 1) > share * at(top)) --low;
  while (high < last && at(high + 1) > share * at(top)) ++high;
  return {std::max<std::ptrdiff_t>(0, std::min(low, top - 2)),
          std::min(last, std::max(high, top + 2))};
}

// The bins around the minimum that follows a maximum at distance r: around the smallest g between r
// and 1.6 r, extended by 10 % of r on each side. The result is empty if g is smallest in the last
// bin, because the minimum may lie beyond the last bin.
std::optional<Bins> about_minimum(std::span<const double> g, std::ptrdiff_t top) {
  constexpr double search_end = 1.6, part = 0.1;
  const auto last = static_cast<std::ptrdiff_t>(g.size()) - 1;
  const auto end =
      std::min(last, static_cast<std::ptrdiff_t>(search_end * static_cast<double>(top)));
  const auto lowest = std::min_element(g.begin() + top, g.begin() + end + 1) - g.begin();
  if (lowest == last) return std::nullopt;
  const auto wide = std::max<std::ptrdiff_t>(2, std::lround(part * static_cast<double>(top)));
  return Bins{std::max(top, lowest - wide), std::min(last, lowest + wide)};
}

struct Extremum {
  double position, height;  // position in bins from the middle of bin 0, and height [1]
};

using Cubic = std::array<double, 4>;  // coefficients of 1, x, x², x³

double value(const Cubic& c, double x) { return c[0] + x * (c[1] + x * (c[2] + x * c[3])); }

// The least-squares cubic through `sign` times g at x = −half, −half + 1, ..., half, or a
// polynomial of lower degree for fewer than four points. The cubic is a sum of polynomials that are
// orthogonal on the fitted points. The points are symmetric about 0. Each orthogonal polynomial is
// therefore x times the previous polynomial, minus a multiple of the polynomial two degrees lower.
Cubic fitted_cubic(std::span<const double> g, double sign) {
  const double half = static_cast<double>(g.size() - 1) / 2;
  Cubic sum{}, polynomial{1}, last{};
  double last_square = 1;
  for (std::size_t degree = 0; degree < std::min(g.size(), sum.size()); ++degree) {
    double square = 0, product = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      const double p = value(polynomial, static_cast<double>(i) - half);
      square += p * p;
      product += p * sign * g[i];
    }
    const double ratio = square / std::exchange(last_square, square);
    Cubic next{};
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += product / square * polynomial[k];
      next[k] = (k > 0 ? polynomial[k - 1] : 0) - ratio * last[k];
    }
    last = std::exchange(polynomial, next);
  }
  return sum;
}

// The maximum of the least-squares cubic through `sign` times g in a range of bins.
Extremum maximum(std::span<const double> g, const Bins& bins, double sign) {
  const double middle = static_cast<double>(bins.low + bins.high) / 2,
               half = static_cast<double>(bins.high - bins.low) / 2;
  const Cubic c = fitted_cubic(g.subspan(static_cast<std::size_t>(bins.low),
                                         static_cast<std::size_t>(bins.high - bins.low + 1)),
                               sign);
  // The maximum is where the slope is zero, given by one of the two roots of the slope. An end of
  // the range is used only if the slope has no zero inside the range, because noise may make the
  // value at the end higher.
  const double root = std::sqrt(c[2] * c[2] - 3 * c[1] * c[3]);
  const double inside = c[2] < 0 ? c[1] / (root - c[2]) : (-c[2] - root) / (3 * c[3]);
  const double end = value(c, -half) > value(c, half) ? -half : half;
  const double best = std::abs(inside) < half ? inside : end;
  return {middle + best, sign * value(c, best)};
}

// Number of tasks over which pairs of sites are distributed, each with a separate histogram.
constexpr std::size_t tasks = 32;

std::size_t checked_bins(const RadialSettings& settings) {
  const double bins = settings.cutoff / settings.bin + 1e-9;
  require_memory(sizeof(std::uint64_t) * tasks * static_cast<double>(settings.pairs.size()) * bins,
                 fmt::format("g(r) histograms of {:.3g} bins", bins), "use wider bins");
  return static_cast<std::size_t>(bins);
}

}  // namespace

std::vector<std::string> molecules_with(const Topology& topology, const std::string& selection) {
  std::vector<std::string> found;
  for (const auto& [molecule, count] : topology.parts)
    if (count_sites(selection, molecule) > 0 &&
        std::ranges::find(found, molecule.name) == found.end())
      found.push_back(molecule.name);
  return found;
}

double count_pairs(const Topology& topology, const SitePair& pair) {
  double within = 0;
  for (const auto& [molecule, count] : topology.parts)
    within += static_cast<double>(count) * count_sites(pair[0], molecule) *
              count_sites(pair[1], molecule);
  return (count_sites(pair[0], topology) * count_sites(pair[1], topology) - within) /
         (pair[0] == pair[1] ? 2 : 1);
}

std::vector<SitePair> site_pairs(const Topology& topology) {
  std::vector<std::string> words;
  for (const auto& [molecule, count] : topology.parts)
    for (const Site& site : molecule.sites) {
      std::string word = without_digits(site.name);
      if (molecules_with(topology, word).size() > 1) word = molecule.name + ":" + word;
      if (site.mass > 0 && std::ranges::find(words, word) == words.end()) words.push_back(word);
    }
  std::vector<SitePair> pairs;
  for (std::size_t a = 0; a < words.size(); ++a)
    for (std::size_t b = a; b < words.size(); ++b)
      if (const SitePair pair{words[a], words[b]}; count_pairs(topology, pair) > 0)
        pairs.push_back(pair);
  return pairs;
}

RadialDistribution::RadialDistribution(const Topology& topology, const RadialSettings& settings)
    : pairs_(settings.pairs),
      cutoff_(settings.cutoff),
      width_(settings.bin),
      bins_(checked_bins(settings)) {
  // Sites that are selected by the same site names form a kind.
  std::vector<std::string> words, all_names;
  for (const SitePair& pair : pairs_) words.insert(words.end(), pair.begin(), pair.end());
  std::vector<std::vector<bool>> kinds;
  for (const auto& [molecule, count] : topology.parts) {
    auto& sites = sites_.emplace_back();
    bodies_.push_back(count);
    for (const Site& site : molecule.sites) {
      all_names.push_back(site.name);
      std::vector<bool> kind;
      for (const std::string& word : words) kind.push_back(names(word, molecule, site));
      if (std::find(kind.begin(), kind.end(), true) == kind.end()) continue;
      const auto known = std::ranges::find(kinds, kind);
      sites.emplace_back(site.r, static_cast<std::size_t>(known - kinds.begin()));
      if (known == kinds.end()) kinds.push_back(kind);
    }
  }
  for (std::size_t w = 0; w < words.size(); ++w)
    if (std::ranges::none_of(kinds, [&](const auto& kind) { return kind[w]; }))
      throw Error(fmt::format("no site is named '{}'{} (the sites are: {})", words[w],
                              did_you_mean(words[w], all_names), join_names(all_names)));

  // Site kinds a and b count once for each order in which they match the two selections of a pair.
  // If both selections are the same, the kinds count only once.
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
  for (const SitePair& pair : pairs_) {
    pairs_of_sites_.push_back(count_pairs(topology, pair));
    sites_of_first_.push_back(count_sites(pair[0], topology));
    sites_of_second_.push_back(count_sites(pair[1], topology));
  }
}

void RadialDistribution::add(const State& state, Workers& workers,
                             const std::optional<StepError>& error) {
  const Vec3<double> edge = state.box.edge, half = edge / 2.0;
  // A cutoff of half an edge is accepted if the edge was rounded in a text file.
  if (cutoff_ > state.box.shortest_edge() / 2 * (1 + 1e-6))
    throw Error(fmt::format(
        "the maximum distance of {:g} nm is more than half of the shortest box edge ({:.4f} nm) at "
        "{:g} ps; give a shorter distance, with a margin of 5 % if a barostat changes the box",
        cutoff_, state.box.shortest_edge(), state.time));
  std::vector<WrappedSite> placed;
  std::size_t i = 0;
  for (std::size_t part = 0; part < sites_.size(); ++part)
    for (const std::size_t end = i + bodies_[part]; i < end; ++i)
      for (const auto& [r, kind] : sites_[part])
        placed.push_back({wrapped(state.q[i] + to_lab(state.orientation[i], r), state.box),
                          static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(kind)});
  const CellList sites(placed, state.box, cutoff_);

  // Counts are integers, so that the sum does not depend on the distribution over tasks.
  std::vector<std::vector<std::uint64_t>> histograms(tasks);
  const double reach2 = std::pow(static_cast<double>(bins_) * width_, 2);
  workers.each(tasks, [&](std::size_t task) {
    std::vector<std::uint64_t>& histogram = histograms[task];
    histogram.assign(pairs_.size() * bins_, 0);
    const auto count = [&](const WrappedSite& one, const WrappedSite& two) {
      const double r2 = norm2(nearest(one.r - two.r, edge, half));
      if (r2 >= reach2 || one.body == two.body) return;
      const auto bin = std::min(bins_ - 1, static_cast<std::size_t>(std::sqrt(r2) / width_));
      for (const auto& [p, times] : counts_[one.kind][two.kind])
        histogram[p * bins_ + bin] += times;
    };
    sites.each_pair(count, task, tasks);
  });
  std::vector<double> sample(pairs_.size() * bins_ + 1, 0.0);
  for (const auto& histogram : histograms)
    for (std::size_t k = 0; k < histogram.size(); ++k)
      sample[k] += static_cast<double>(histogram[k]);
  const double volume = state.box.volume();
  for (double& count : sample) count *= volume;
  sample.back() = volume;
  blocks_.add(sample);
  if (error) response_.add(*error, sample);
}

double RadialDistribution::shell(std::size_t bin) const {
  const auto k = static_cast<double>(bin);
  return 4.0 / 3 * units::pi * (3 * k * (k + 1) + 1) * width_ * width_ * width_;
}

std::vector<double> RadialDistribution::g(std::size_t pair, std::span<const double> mean) const {
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

std::vector<SeriesEstimate> RadialDistribution::g(std::size_t pair) const {
  const std::vector<SeriesEstimate> estimates = series_estimates(blocks_.means());
  std::vector<SeriesEstimate> g(bins_);
  for (std::size_t k = 0; k < bins_; ++k) {
    const double scale = 1 / (pairs_of_sites_[pair] * shell(k));
    const SeriesEstimate& counts = estimates[pair * bins_ + k];
    g[k] = {counts.value * scale, counts.error * scale, counts.known};
  }
  return g;
}

std::vector<double> RadialDistribution::coordination(std::size_t pair) const {
  return neighbours(pair, blocks_.means().mean());
}

double RadialDistribution::neighbours_within(std::size_t pair, double bins,
                                             std::span<const double> mean) const {
  const std::vector<double> n = neighbours(pair, mean);  // neighbours up to the end of each bin
  const double ends = std::max(0.0, bins - 1);
  const auto k = std::min(static_cast<std::size_t>(ends), bins_ - 2);
  return n[k] + (ends - static_cast<double>(k)) * (n[k + 1] - n[k]);
}

std::optional<RadialDistribution::Peak> RadialDistribution::first_peak(std::size_t pair) const {
  const BlockMeans means = blocks_.means();
  return first_peak(pair, means.mean(), [&](const auto& f) { return series_estimate(means, f); });
}

std::optional<RadialDistribution::Peak> RadialDistribution::first_peak_bias(
    std::size_t pair, double degrees_of_freedom, FixedMeans fixed) const {
  return first_peak(pair, means(),
                    [&](const auto& f) { return response_.bias(degrees_of_freedom, fixed, f); });
}

std::optional<RadialDistribution::Peak> RadialDistribution::first_peak(
    std::size_t pair, std::span<const double> overall, const Estimate& estimate) const {
  const std::vector<double> smooth = smoothed(g(pair, overall));
  // The result is NaN in all bins if no two molecules have such sites.
  if (smooth.size() < 2 || !(*std::ranges::max_element(smooth) > 0)) return std::nullopt;
  const std::ptrdiff_t summit = first_summit(smooth);
  if (summit + 1 == static_cast<std::ptrdiff_t>(bins_)) return std::nullopt;
  // The same bins are used for the mean of all blocks and for the means that omit a block. With
  // different bins, the fitted cubic would change discontinuously.
  using Mean = std::span<const double>;
  const auto top = [&, bins = about_summit(smooth, summit)](Mean mean) {
    return maximum(g(pair, mean), bins, 1);
  };
  Peak peak{estimate([&](Mean mean) { return (top(mean).position + 0.5) * width_; }),
            estimate([&](Mean mean) { return top(mean).height; }), std::nullopt};
  const std::optional<Bins> bins = about_minimum(smooth, summit);
  if (!bins) return peak;
  const auto end = [&](Mean mean) { return maximum(g(pair, mean), *bins, -1).position + 0.5; };
  const SeriesEstimate around_first =
      estimate([&](Mean mean) { return neighbours_within(pair, end(mean), mean); });
  const double ratio = sites_of_first_[pair] / sites_of_second_[pair];
  peak.shell = {estimate([&](Mean mean) { return end(mean) * width_; }),
                around_first,
                {around_first.value * ratio, around_first.error * ratio, around_first.known}};
  return peak;
}

}  // namespace polhode
