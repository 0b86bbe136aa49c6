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

/// The bins with the weights of their means.
struct Points {
  std::span<const double> mean;
  const ModeBins& bins;
  double series;

  double degrees_of_freedom(std::size_t bin) const {
    return 2 * information * series * static_cast<double>(bins.count(bin));
  }
};

template <int degree>
SpectrumFit fit(const Points& points, std::size_t bins) {
  constexpr int size = degree + 1, max_iterations = 50;
  constexpr double converged = 1e-10;
  using Vector = Eigen::Matrix<double, size, 1>;
  const double highest = points.bins.middle(bins - 1);
  const auto powers = [&](std::size_t b) {
    const double x = std::pow(points.bins.middle(b) / highest, 2);
    Vector v = Vector::Ones();
    for (int k = 1; k < size; ++k) v(k) = v(k - 1) * x;
    return v;
  };
  Eigen::Matrix<double, size, size> information_matrix = decltype(information_matrix)::Zero();
  Vector first = Vector::Zero();
  for (std::size_t b = 0; b < bins; ++b) {
    const Vector v = powers(b);
    const double weight = points.degrees_of_freedom(b) / 2;
    information_matrix += weight * v * v.transpose();
    first += weight * std::log(points.mean[b]) * v;
  }
  const Eigen::LDLT<Eigen::Matrix<double, size, size>> solver(information_matrix);
  Vector c = solver.solve(first);
  for (int n = 0; n < max_iterations; ++n) {  // scoring: the likelihood is concave
    Vector gradient = Vector::Zero();
    for (std::size_t b = 0; b < bins; ++b) {
      const Vector v = powers(b);
      gradient += points.degrees_of_freedom(b) / 2 * (points.mean[b] * std::exp(-v.dot(c)) - 1) * v;
    }
    const Vector change = solver.solve(gradient);
    const double size_of_change = change.template lpNorm<Eigen::Infinity>();
    c += change / std::max(1.0, size_of_change);
    if (size_of_change < converged) break;
  }
  SpectrumFit done{c(0), 0};
  for (std::size_t b = 0; b < bins; ++b) {
    const double ratio = points.mean[b] * std::exp(-powers(b).dot(c));
    done.deviance += points.degrees_of_freedom(b) * (ratio - 1 - std::log(ratio));
  }
  return done;
}

/// A fit that contributes to the mean.
struct Contribution {
  double criterion;  ///< −2 × logarithm of its probability, up to a constant
  double log_value, max_mode;
};

template <int degree>
void add_fits(std::vector<Contribution>& all, const Points& points) {
  constexpr std::size_t parameters = degree + 1, shorter = 3;
  std::vector<SpectrumFit> fits(points.bins.size() + 1);
  for (std::size_t n = parameters; n < fits.size(); ++n) fits[n] = fit<degree>(points, n);
  std::size_t inner = parameters;
  for (std::size_t n = parameters + 2; n < fits.size(); ++n) {
    const double highest = points.bins.middle(n - 1);
    while (inner < n && shorter * points.bins.middle(inner) <= highest) ++inner;
    const double free_parameters = static_cast<double>(parameters + points.bins.size() - n);
    all.push_back({fits[n].deviance + 2 * free_parameters, fits[inner].log_value, highest});
  }
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

ZeroFrequency zero_frequency(std::span<const double> mean, double series, const ModeBins& bins) {
  if (std::any_of(mean.begin(), mean.end(), [](double x) { return !(x > 0); }))
    return {std::numeric_limits<double>::quiet_NaN(), 0};
  const Points points{mean, bins, series};
  std::vector<Contribution> all;
  add_fits<1>(all, points);
  add_fits<2>(all, points);
  const double best = std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
                        return a.criterion < b.criterion;
                      })->criterion;
  ZeroFrequency found;
  double sum = 0;
  for (const auto& [criterion, log_value, highest] : all) {
    const double probability = std::exp((best - criterion) / 2);
    sum += probability;
    found.value += probability * std::exp(log_value);
    found.max_mode += probability * highest;
  }
  return {found.value / sum, found.max_mode / sum};
}

}  // namespace polhode
