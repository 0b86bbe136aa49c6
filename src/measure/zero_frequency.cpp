// SPDX-License-Identifier: MIT
#include "measure/zero_frequency.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "math/fourier.hpp"
#include "polhode/base/column.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

// Share of the series in the taper at each end. An exponential autocorrelation function of time τ
// then has a bias of −26 (τ/T)², where a series without taper has −τ/T.
constexpr double tapered = 0.1;
// The tapered series has as much information as this share of its length: (mean w²)²/mean w⁴ for
// w = sin² at the ends.
constexpr double information =
    (1 - 1.25 * tapered) * (1 - 1.25 * tapered) / (1 - 93.0 / 64 * tapered);

/// The weight of sample j of n.
double taper(std::size_t j, std::size_t n) {
  const double end = tapered * static_cast<double>(n);
  const double x = (static_cast<double>(std::min(j, n - 1 - j)) + 0.5) / end;
  return x >= 1 ? 1 : std::pow(std::sin(units::pi / 2 * x), 2);
}

/// A polynomial of degree 1 or 2 in ν² through the logarithm of the first bins.
struct SpectrumFit {
  double log_value = 0;  ///< logarithm of the spectrum at zero frequency
  double deviance = 0;   ///< −2 × logarithm of the likelihood relative to a perfect fit
};

/// The number of degrees of freedom of the mean of a bin.
double degrees_of_freedom(const ModeBins& bins, std::size_t bin, double series) {
  return 2 * information * series * static_cast<double>(bins.count(bin));
}

/// Fits the first bins. The number of series is only a common factor of all weights.
template <int degree>
SpectrumFit fit(std::span<const double> mean, const ModeBins& bins, std::size_t count,
                double series = 1) {
  constexpr int size = degree + 1, max_iterations = 50;
  constexpr double converged = 1e-10;
  using Vector = Eigen::Matrix<double, size, 1>;
  const double highest = bins.middle(count - 1);
  const auto powers = [&](std::size_t b) {
    const double x = std::pow(bins.middle(b) / highest, 2);
    Vector v = Vector::Ones();
    for (int k = 1; k < size; ++k) v(k) = v(k - 1) * x;
    return v;
  };
  Eigen::Matrix<double, size, size> information_matrix = decltype(information_matrix)::Zero();
  Vector first = Vector::Zero();
  for (std::size_t b = 0; b < count; ++b) {
    const Vector v = powers(b);
    const double weight = degrees_of_freedom(bins, b, 1) / 2;
    information_matrix += weight * v * v.transpose();
    first += weight * std::log(mean[b]) * v;
  }
  const Eigen::LDLT<Eigen::Matrix<double, size, size>> solver(information_matrix);
  Vector c = solver.solve(first);
  for (int n = 0; n < max_iterations; ++n) {  // scoring: the likelihood is concave
    Vector gradient = Vector::Zero();
    for (std::size_t b = 0; b < count; ++b) {
      const Vector v = powers(b);
      gradient += degrees_of_freedom(bins, b, 1) / 2 * (mean[b] * std::exp(-v.dot(c)) - 1) * v;
    }
    const Vector change = solver.solve(gradient);
    const double size_of_change = change.template lpNorm<Eigen::Infinity>();
    c += change / std::max(1.0, size_of_change);
    if (size_of_change < converged) break;
  }
  SpectrumFit done{c(0), 0};
  for (std::size_t b = 0; b < count; ++b) {
    const double ratio = mean[b] * std::exp(-powers(b).dot(c));
    done.deviance += degrees_of_freedom(bins, b, series) * (ratio - 1 - std::log(ratio));
  }
  return done;
}

SpectrumFit fit(std::size_t degree, std::span<const double> mean, const ModeBins& bins,
                std::size_t count, double series = 1) {
  return degree == 1 ? fit<1>(mean, bins, count, series) : fit<2>(mean, bins, count, series);
}

bool is_positive(std::span<const double> mean) {
  return std::ranges::all_of(mean, [](double x) { return x > 0; });
}

}  // namespace

ModeBins::ModeBins(std::size_t modes) : first_{1} {
  constexpr double growth = 1.15;
  while (first_.back() <= modes)
    first_.push_back(std::max(
        first_.back() + 1, static_cast<std::size_t>(growth * static_cast<double>(first_.back()))));
}

double ModeBins::middle(std::size_t bin) const {
  return static_cast<double>(first_[bin] + first_[bin + 1] - 1) / 2;
}

std::vector<double> binned_periodogram(std::span<const double> series, double interval,
                                       const ModeBins& bins) {
  const RealTransform transform(series.size());
  Column<double> weighted(transform.size());
  double squares = 0;
  for (std::size_t j = 0; j < series.size(); ++j) {
    const double w = taper(j, series.size());
    squares += w * w;
    weighted[j] = w * series[j];
  }
  Column<std::complex<double>> modes(transform.modes());
  transform.forward(weighted, modes);
  std::vector<double> means;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    double sum = 0;
    for (std::size_t k = bins.first(b); k < bins.first(b) + bins.count(b); ++k)
      sum += std::norm(modes[k]);
    means.push_back(sum * interval / (squares * static_cast<double>(bins.count(b))));
  }
  return means;
}

ZeroFrequency::ZeroFrequency(std::span<const double> mean, double series, const ModeBins& bins)
    : bins_(bins) {
  if (!is_positive(mean)) return;
  constexpr double shorter = 2, negligible = 1e-4;
  std::vector<double> criteria, modes;  // −2 × logarithms of probabilities, up to a constant
  for (const std::size_t degree : {1u, 2u}) {
    std::size_t inner = degree + 1;
    for (std::size_t n = degree + 3; n <= bins.size(); ++n) {
      const double highest = bins.middle(n - 1);
      while (inner < n && shorter * bins.middle(inner) <= highest) ++inner;
      const auto parameters = static_cast<double>(degree + 1 + bins.size() - n);
      criteria.push_back(fit(degree, mean, bins, n, series).deviance + 2 * parameters);
      modes.push_back(highest);
      contributions_.push_back({degree, inner, 0});
    }
  }
  const double best = *std::ranges::min_element(criteria);
  double sum = 0;
  for (std::size_t k = 0; k < criteria.size(); ++k)
    sum += contributions_[k].probability = std::exp((best - criteria[k]) / 2);
  for (std::size_t k = 0; k < criteria.size(); ++k)
    max_mode_ += (contributions_[k].probability /= sum) * modes[k];
  std::erase_if(contributions_, [&](const auto& c) { return c.probability < negligible; });
}

double ZeroFrequency::value(std::span<const double> mean) const {
  if (contributions_.empty() || !is_positive(mean)) return std::numeric_limits<double>::quiet_NaN();
  double value = 0, sum = 0;
  for (const auto& [degree, count, probability] : contributions_) {
    value += probability * std::exp(fit(degree, mean, bins_, count).log_value);
    sum += probability;
  }
  return value / sum;
}

}  // namespace polhode
