// SPDX-License-Identifier: MIT
#include "polhode/math/fit.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace polhode {

Estimate mean(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double v : values) sum += v;
  const double average = sum / n;
  double squares = 0;
  for (const double v : values) squares += (v - average) * (v - average);
  return {average, n > 1 ? std::sqrt(squares / (n - 1) / n) : 0.0};
}

// Each value in `without` is computed without one of the points. The jackknife variance (n − 1)/n Σ
// (value − mean)² is (n − 1)² times the variance of the mean of these values.
double jackknife_error(std::span<const double> without) {
  return mean(without).error * static_cast<double>(without.size() - 1);
}

Estimate slope(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  const double x0 = mean(x).value, y0 = mean(y).value;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x0) * (x[i] - x0);
    xy += (x[i] - x0) * (y[i] - y0);
  }
  const double b = xy / xx;
  double residual = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double r = y[i] - y0 - b * (x[i] - x0);
    residual += r * r;
  }
  return {b, n > 2 ? std::sqrt(residual / (n - 2) / xx) : 0.0};
}

Line weighted_line(std::span<const double> x, std::span<const Estimate> y) {
  double w = 0, wx = 0, wy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double weight = 1 / (y[i].error * y[i].error);
    w += weight, wx += weight * x[i], wy += weight * y[i].value;
  }
  const double x0 = wx / w, y0 = wy / w;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double weight = 1 / (y[i].error * y[i].error);
    xx += weight * (x[i] - x0) * (x[i] - x0);
    xy += weight * (x[i] - x0) * (y[i].value - y0);
  }
  const double b = xy / xx;
  return {{y0 - b * x0, std::sqrt(1 / w + x0 * x0 / xx)}, {b, std::sqrt(1 / xx)}};
}

double misfit_p_value(const Line& line, std::span<const double> x, std::span<const Estimate> y) {
  if (x.size() < 3) return 1;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares +=
        std::pow((y[i].value - line.intercept.value - line.slope.value * x[i]) / y[i].error, 2);
  const auto free = static_cast<double>(x.size() - 2);
  return boost::math::cdf(boost::math::complement(
      boost::math::fisher_f(free, line.degrees_of_freedom), squares / free));
}

double p_value(const Estimate& estimate, double degrees_of_freedom) {
  if (estimate.value == 0) return 1;
  if (estimate.error == 0) return 0;
  const boost::math::students_t t(degrees_of_freedom);
  return 2 *
         boost::math::cdf(boost::math::complement(t, std::abs(estimate.value / estimate.error)));
}

double three_sigma_quantile(double degrees_of_freedom) {
  constexpr double beyond = 0.0013498980316300946;  // probability above the mean by more than three
                                                    // standard deviations, for a normal
                                                    // distribution
  return degrees_of_freedom == 0 ? 3
                                 : boost::math::quantile(boost::math::complement(
                                       boost::math::students_t(degrees_of_freedom), beyond));
}

}  // namespace polhode
