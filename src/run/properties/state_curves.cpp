// SPDX-License-Identifier: MIT
// Polynomials through the results of several state points: where the density has its maximum, and
// properties that are derivatives.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "io/settings/quantity.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

constexpr std::size_t min_points = 3, points_of_cubic = 5;

/// A value with its standard error at a temperature or a pressure.
struct CurvePoint {
  double x = 0;
  SeriesEstimate y;
  const MeasuredPoint* at = nullptr;
};

/// The polynomial of least χ², quadratic or cubic, in x scaled to −1 to 1; the errors of y are
/// known, so its covariance does not depend on the residuals.
class Polynomial {
 public:
  explicit Polynomial(const std::vector<CurvePoint>& points) {
    const auto [low, high] =
        std::ranges::minmax_element(points, [](const auto& a, const auto& b) { return a.x < b.x; });
    middle_ = (low->x + high->x) / 2;
    half_ = (high->x - low->x) / 2;
    fit_.points = points.size();
    fit_.degree = points.size() >= points_of_cubic ? 3 : 2;
    const auto n = static_cast<Eigen::Index>(points.size()),
               count = static_cast<Eigen::Index>(fit_.degree + 1);
    Eigen::MatrixXd A(n, count);
    Eigen::VectorXd b(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const CurvePoint& point = points[static_cast<std::size_t>(k)];
      A.row(k) = powers(point.x, 0) / point.y.error;
      b(k) = point.y.value / point.y.error;
    }
    covariance_ = (A.transpose() * A).inverse();
    c_ = A.colPivHouseholderQr().solve(b);
    fit_.chi_squared = (A * c_ - b).squaredNorm();
  }

  const StateFit& fit() const { return fit_; }
  double low() const { return middle_ - half_; }
  double high() const { return middle_ + half_; }
  /// A derivative; 0: the value.
  double value(double x, int derivative) const { return powers(x, derivative).dot(c_); }
  /// A linear function of the coefficients with its error.
  SeriesEstimate estimate(const Eigen::RowVectorXd& of) const {
    return {of.dot(c_), std::sqrt(of * covariance_ * of.transpose()), Known::yes, 0};
  }
  Eigen::RowVectorXd powers(double x, int derivative) const {
    const double z = (x - middle_) / half_;
    Eigen::RowVectorXd row(static_cast<Eigen::Index>(fit_.degree + 1));
    for (int k = 0; k < row.size(); ++k) {
      double factor = 1;
      for (int d = 0; d < derivative; ++d) factor *= (k - d) / half_;
      row(k) = k < derivative ? 0 : factor * std::pow(z, k - derivative);
    }
    return row;
  }

  /// Where the polynomial has a maximum, if it has one.
  std::optional<double> maximum() const {
    // The derivative c₁ + 2 c₂ z + 3 c₃ z² falls through zero at the root that does not cancel
    // when c₃ vanishes.
    const double c1 = c_(1), c2 = c_(2), c3 = fit_.degree == 3 ? c_(3) : 0;
    const double discriminant = c2 * c2 - 3 * c1 * c3;
    if (!(discriminant > 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    if (c2 > 0 && c3 == 0) return std::nullopt;
    const double z = c2 <= 0 ? c1 / (-c2 + root) : (-c2 - root) / (3 * c3);
    return middle_ + half_ * z;
  }

 private:
  double middle_ = 0, half_ = 1;
  StateFit fit_;
  Eigen::VectorXd c_;
  Eigen::MatrixXd covariance_;
};

using Choice = SeriesEstimate MeasuredPoint::*;

/// Curves of a quantity over one variable, by the value of the other; those with enough points.
std::vector<std::vector<CurvePoint>> curves_of(const std::vector<MeasuredPoint>& points,
                                               Choice quantity, double StatePoint::*variable,
                                               double StatePoint::*constant) {
  std::map<double, std::vector<CurvePoint>> by_constant;
  for (const MeasuredPoint& point : points) {
    if (point.at.constant_volume()) continue;  // such a point is on none of these curves
    const SeriesEstimate& y = point.*quantity;
    if (y.known != Known::yes || !(y.error > 0)) continue;
    std::vector<CurvePoint>& curve = by_constant[point.at.*constant];
    const double x = point.at.*variable;
    if (std::ranges::none_of(curve, [&](const auto& other) { return other.x == x; }))
      curve.push_back({x, y, &point});
  }
  std::vector<std::vector<CurvePoint>> curves;
  for (auto& [value, curve] : by_constant) {
    std::ranges::sort(curve, [](const auto& a, const auto& b) { return a.x < b.x; });
    if (curve.size() >= min_points) curves.push_back(std::move(curve));
  }
  return curves;
}

const MeasuredProperty* requested(const MeasuredPoint& point, std::string_view name) {
  const auto found = std::ranges::find_if(point.properties, [&](const MeasuredProperty& m) {
    return name == m.request.property->name;
  });
  return found == point.properties.end() ? nullptr : &*found;
}

/// Why there is no maximum between the points, and where it may be.
std::string no_maximum(const Polynomial& density) {
  const double low = density.low(), high = density.high();
  const bool falls = density.value(low, 0) > density.value(high, 0);
  return fmt::format(
      "the density has no maximum between {:g} K and {:g} K; measure at {} "
      "temperatures",
      low, high, falls ? "lower" : "higher");
}

DensityMaximum maximum_of(const std::vector<CurvePoint>& curve) {
  const Polynomial density(curve);
  DensityMaximum m{.pressure = curve.front().at->at.pressure, .fit = density.fit()};
  const std::optional<double> T = density.maximum();
  if (!T || !(*T > density.low() && *T < density.high())) {
    m.obstacle = no_maximum(density);
    return m;
  }
  // A shift of the slope moves the maximum by the shift over the curvature.
  const double error =
      density.estimate(density.powers(*T, 1)).error / std::abs(density.value(*T, 2));
  if (error > (density.high() - density.low()) / 2) {
    m.obstacle = fmt::format(
        "the maximum of the density is not determined: its error would be "
        "{:.2g} K; request a smaller error of the density",
        error);
    return m;
  }
  m.temperature = {*T, error, Known::yes, 0};
  m.density = density.estimate(density.powers(*T, 0));
  return m;
}

/// Slopes at all points but the first and the last, where a polynomial is least certain.
/// @param of  the property from the slope, and its factor
template <class Factor>
void add_slopes(std::vector<SlopeValue>& list, const std::vector<CurvePoint>& curve,
                const char* name, const Factor& factor) {
  const Polynomial y(curve);
  for (std::size_t k = 1; k + 1 < curve.size(); ++k) {
    const MeasuredProperty* m = requested(*curve[k].at, name);
    if (!m) continue;
    const SeriesEstimate slope =
        scaled(y.estimate(y.powers(curve[k].x, 1)), factor(y.value(curve[k].x, 0)));
    const bool known = m->value.known == Known::yes;
    const double error = std::hypot(slope.error, m->value.error);
    list.push_back({m->request.property, curve[k].at->at, slope, m->value,
                    known && error > 0 ? (slope.value - m->value.value) / error : std::nan(""),
                    y.fit()});
  }
}

}  // namespace

bool StateFit::misfit() const {
  const auto n = static_cast<double>(degrees_of_freedom());
  return n > 0 && chi_squared > n + 3 * std::sqrt(2 * n);
}

std::string StateFit::text() const {
  const std::string polynomial = degree == 3 ? "cubic polynomial" : "quadratic polynomial";
  if (degrees_of_freedom() == 0) return polynomial + " through the points";
  return fmt::format("{}, chi2 {:.2g} with {} degrees of freedom{}", polynomial, chi_squared,
                     degrees_of_freedom(),
                     misfit() ? ": the points deviate from it by more than their errors" : "");
}

StateCurves state_curves(const std::vector<MeasuredPoint>& points) {
  constexpr auto T = &StatePoint::temperature, p = &StatePoint::pressure;
  StateCurves found;
  for (const auto& curve : curves_of(points, &MeasuredPoint::density, T, p)) {
    if (requested(*curve.front().at, "density")) found.maxima.push_back(maximum_of(curve));
    add_slopes(found.slopes, curve, "expansivity", [](double rho) { return -1e6 / rho; });
  }
  for (const auto& curve : curves_of(points, &MeasuredPoint::enthalpy, T, p))
    add_slopes(found.slopes, curve, "heat-capacity",
               [](double) { return 1000.0; });  // from kJ/mol/K to J/mol/K
  const double per_bar = unit("bar", Dimension::pressure);
  for (const auto& curve : curves_of(points, &MeasuredPoint::density, p, T))
    add_slopes(found.slopes, curve, "compressibility",
               [&](double rho) { return 1e6 * per_bar / rho; });
  return found;
}

}  // namespace polhode
