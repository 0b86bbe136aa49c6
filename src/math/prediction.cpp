// SPDX-License-Identifier: MIT
#include "math/prediction.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "polhode/math/fit.hpp"

namespace polhode {

double t_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double f_quantile(double probability, double numerator_degrees, double denominator_degrees) {
  return boost::math::quantile(boost::math::fisher_f(numerator_degrees, denominator_degrees),
                               probability);
}

ErrorPart summed(std::initializer_list<ErrorPart> parts) {
  double squares = 0, fourth = 0;
  for (const ErrorPart& part : parts) {
    const double square = part.error * part.error;
    squares += square;
    fourth += square * square / part.degrees_of_freedom;
  }
  return {std::sqrt(squares),
          fourth > 0 ? squares * squares / fourth : std::numeric_limits<double>::infinity()};
}

double confidence_half_width(const ErrorPart& part) {
  if (part.error == 0) return 0;
  if (!(part.degrees_of_freedom > 0)) return std::numeric_limits<double>::infinity();
  return t_quantile(0.975, part.degrees_of_freedom) * part.error;
}

double prediction_bound(std::span<const double> values, double probability) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return std::numeric_limits<double>::infinity();
  const Estimate m = mean(values);
  return m.value +
         t_quantile(probability, n - 1) * m.error * std::sqrt(n + 1);  // scatter s = error √n
}

double size_bound(std::span<const double> values, double probability) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return std::numeric_limits<double>::infinity();
  const Estimate m = mean(values);
  return std::abs(m.value) + t_quantile(probability, n - 1) * m.error;
}

}  // namespace polhode
