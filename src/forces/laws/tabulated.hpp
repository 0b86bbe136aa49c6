// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "forces/laws/pair_value.hpp"
#include "polhode/base/error.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// A potential given by a table of energies, interpolated by a cubic spline. Below the first
/// distance of the table, u and s are NaN, so that the run stops. Beyond the last distance u is
/// constant. Pairs inside the cutoff are never beyond the last distance.
template <class T = double>
struct Tabulated {
  std::shared_ptr<const PotentialTable> table;
  T first = 0;            ///< first distance [nm]
  T inverse_spacing = 0;  ///< inverse spacing of the distances [1/nm]
  T intervals = 0;        ///< number of intervals, as a floating-point number

  using Parameters = TabulatedLaw;
  /// Mixes the tables of two sites. The result is the table that both sites have in common. If the
  /// tables differ, the result is empty.
  template <class Mean>
  static std::optional<Parameters> mixed(const Parameters& x, const Parameters& y, const Mean&) {
    return x == y ? std::optional(x) : std::nullopt;
  }
  static Tabulated of(double, double, const TabulatedLaw& law) {
    return {law.table, static_cast<T>(law.table->first()), static_cast<T>(1 / law.table->spacing()),
            static_cast<T>(law.table->intervals())};
  }
  /// @throws Error  always, because the scaled table would end before the cutoff
  Tabulated scaled_by(double) const {
    throw Error("the distances of table '" + table->name() +
                "' cannot be scaled, because the table would end before the cutoff");
  }
  Tabulated<float> rounded() const {
    return {table, static_cast<float>(first), static_cast<float>(inverse_spacing),
            static_cast<float>(intervals)};
  }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real r2) const {
    using C = Constant<Real>;
    const Real one_over_r = inverse_r.first(), last = constant<Real>(intervals);
    const Real place =
        (r2 * one_over_r - C(first)) * C(inverse_spacing);  // distance in units of intervals
    // The order of these comparisons keeps the index inside the table even if r is NaN.
    Real t = select(place < last, place, last);
    t = select(t > Real(0), t, Real(0));
    Real k = floor(t);
    k = select(k < last, k, last - constant<Real>(1));
    const Real x = t - k;
    const auto coefficient = [&](int power) {
      return table_entry(table->template coefficients<T>(),
                         C(4) * value_of(k) + constant<Real>(power));
    };
    const C c1 = coefficient(1), c2 = coefficient(2), c3 = coefficient(3);
    const Real u = coefficient(0) + x * (c1 + x * (c2 + x * c3));
    const Real slope = c1 + x * (C(2) * c2 + x * (C(3) * c3));
    const Real s = slope * C(-inverse_spacing) * one_over_r;
    const auto too_close = r2 < Real(constant<Real>(first * first));
    const Real nothing(constant<Real>(std::numeric_limits<double>::quiet_NaN()));
    return {select(too_close, nothing, u),
            select(too_close, nothing, select(place < last, s, Real(0)))};
  }

  /// A table has no integral from a distance to infinity.
  /// @throws Error  always, because a table has no values beyond its end
  double integral_beyond(double) const {
    throw Error("a dispersion correction needs the potential at all distances, but table '" +
                table->name() +
                "' has no values beyond its end; leave dispersion_correction and "
                "slab_dispersion out");
  }
};

}  // namespace polhode
