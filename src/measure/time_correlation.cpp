// SPDX-License-Identifier: MIT
#include "measure/time_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace polhode {
namespace {

constexpr std::size_t max_groups = 32;
constexpr std::size_t chunks_per_window = 4;  // more need more transforms, fewer give fewer blocks

using Modes = Column<std::complex<double>>;

bool is_displacement(Product product) { return product >= Product::displacement_x; }

// The number of functions of a vector whose products add up to a Product of two vectors.
std::size_t terms(Product product) {
  return product == Product::dot ? 3 : product == Product::dot_squared ? 6 : 1;
}

// (a · b)² = Σ a_i a_j b_i b_j consists of three squares and of three mixed terms that occur twice.
double term(Product product, std::size_t k, const Vec3<double>& a) {
  if (product == Product::dot) return a[k];
  if (product == Product::dot_squared)
    return k < 3 ? a[k] * a[k] : std::sqrt(2.0) * a[k % 3] * a[(k + 1) % 3];
  const Product first = is_displacement(product) ? Product::displacement_x : Product::x;
  return a[static_cast<std::size_t>(product) - static_cast<std::size_t>(first)];
}

}  // namespace

TimeCorrelation::TimeCorrelation(std::size_t bodies, std::size_t lags,
                                 std::vector<Product> products)
    : bodies_(bodies),
      lags_(lags),
      chunk_((lags + chunks_per_window - 1) / chunks_per_window),
      groups_(std::min(bodies, max_groups)),
      products_(std::move(products)),
      transform_(lags_ + chunk_),  // lags do not wrap around the end
      history_(bodies * 3 * (lags_ + chunk_)),
      sums_(groups_, std::vector(products_.size(), std::vector<double>(lags, 0.0))),
      blocks_(products_.size()) {}

void TimeCorrelation::add(const std::function<Vec3<double>(std::size_t)>& value, Workers& workers) {
  const std::size_t at = before_ + fresh_, row = lags_ + chunk_;
  for (std::size_t i = 0; i < bodies_; ++i) {
    const Vec3<double> a = value(i);
    for (std::size_t k = 0; k < 3; ++k) history_[(3 * i + k) * row + at] = a[k];
  }
  ++fresh_;
  ++frames_;
  if (fresh_ == chunk_) sum_up(workers);
}

// Adds the products of the new frames with all stored frames, and keeps the last window of frames.
void TimeCorrelation::sum_up(Workers& workers) {
  if (fresh_ == 0) return;
  workers.each(groups_, [&](std::size_t group) { sum_up(group); });
  const std::size_t held = before_ + fresh_, kept = std::min(held, lags_), row = lags_ + chunk_;
  std::vector<double> sample(2 * lags_);
  for (std::size_t p = 0; p < products_.size(); ++p) {
    std::fill(sample.begin(), sample.end(), 0.0);
    for (std::size_t lag = 0; lag < std::min(held, lags_); ++lag) {
      for (std::size_t group = 0; group < groups_; ++group) sample[lag] += sums_[group][p][lag];
      sample[lags_ + lag] = static_cast<double>(bodies_ * (held - std::max(before_, lag)));
    }
    blocks_[p].add(sample, static_cast<double>(fresh_));
  }
  for (std::size_t r = 0; r < 3 * bodies_; ++r) {
    double* const series = &history_[r * row];
    std::copy(series + (held - kept), series + held, series);
  }
  before_ = kept;
  fresh_ = 0;
}

// Adds Σ_t b(t) a(t − lag) over new times t, where a contains all frames, and b contains zeros
// followed by the new frames. The transform of Σ_t b(t) a(t − lag) is the transform of b times the
// complex conjugate of the transform of a.
void TimeCorrelation::sum_up(std::size_t group) {
  const std::size_t held = before_ + fresh_, row = lags_ + chunk_;
  Column<double> series(transform_.size());
  Modes all(transform_.modes()), fresh(transform_.modes());
  for (std::size_t p = 0; p < products_.size(); ++p) {
    const Product product = products_[p];
    const bool displacement = is_displacement(product);
    Modes correlation(transform_.modes());
    std::vector<double> squares(held + 1, 0.0);  // Σ |a|² over the group and earlier frames
    for (std::size_t i = group; i < bodies_; i += groups_) {
      const double* const x = &history_[3 * i * row];
      const auto vector = [&](std::size_t t) {
        return Vec3<double>{x[t], x[row + t], x[2 * row + t]};
      };
      // Displacements do not depend on the origin. With an origin close to the positions,
      // differences of squares lose fewer digits.
      const Vec3<double> origin = displacement ? vector(0) : Vec3<double>{};
      for (std::size_t k = 0; k < terms(product); ++k) {
        for (std::size_t t = 0; t < transform_.size(); ++t)
          series[t] = t < held ? term(product, k, vector(t) - origin) : 0.0;
        transform_.forward(series, all);
        for (std::size_t t = 0; t < before_; ++t) series[t] = 0;
        transform_.forward(series, fresh);
        for (std::size_t w = 0; w < transform_.modes(); ++w)
          correlation[w] += fresh[w] * std::conj(all[w]);
      }
      for (std::size_t t = 0; displacement && t < held; ++t)
        squares[t + 1] += std::pow(term(product, 0, vector(t) - origin), 2);
    }
    transform_.backward(correlation, series);
    for (std::size_t t = 0; t < held; ++t) squares[t + 1] += squares[t];
    for (std::size_t lag = 0; lag < std::min(held, lags_); ++lag) {
      const double products = series[lag] / static_cast<double>(transform_.size());
      const std::size_t first = std::max(before_, lag);
      sums_[group][p][lag] = displacement ? squares[held] - squares[first] + squares[held - lag] -
                                                squares[first - lag] - 2 * products
                                          : products;
    }
  }
}

BlockMeans TimeCorrelation::sum_of_means(Workers& workers) {
  std::vector<BlockMeans::Block> sum = means(0, workers).blocks();
  for (std::size_t k = 1; k < products_.size(); ++k) {
    const BlockMeans one = means(k, workers);
    for (std::size_t block = 0; block < sum.size(); ++block)
      for (std::size_t lag = 0; lag < sum[block].sum.size(); ++lag)
        sum[block].sum[lag] += one.blocks()[block].sum[lag];
  }
  return BlockMeans(std::move(sum));
}

BlockMeans TimeCorrelation::means(std::size_t k, Workers& workers) {
  if (bodies_ == 0) return {};
  sum_up(workers);
  const std::size_t lags = std::min({lags_, frames_ / 2 + 1, frames_});
  const BlockMeans raw = blocks_[k].means();
  std::vector<double> mean(lags), per_frame(lags);
  const std::vector<double> total = raw.mean();  // sums and numbers of products, per frame
  for (std::size_t lag = 0; lag < lags; ++lag) {
    per_frame[lag] = total[lags_ + lag];
    mean[lag] = total[lag] / per_frame[lag];
  }
  std::vector<BlockMeans::Block> blocks;
  for (const BlockMeans::Block& part : raw.blocks()) {
    std::vector<double> sum(lags);
    for (std::size_t lag = 0; lag < lags; ++lag)
      sum[lag] = part.weight * mean[lag] +
                 (part.sum[lag] - part.sum[lags_ + lag] * mean[lag]) / per_frame[lag];
    blocks.push_back({part.weight, std::move(sum)});
  }
  return BlockMeans(std::move(blocks));
}

}  // namespace polhode
