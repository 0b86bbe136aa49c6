// SPDX-License-Identifier: MIT
// The short-range potential of a pair of sites. Each pair can have any potential of the list below.
// Systems with only Lennard-Jones potentials use separate loops, in which the potential is known at
// compile time.
#pragma once

#include <variant>

#include "forces/laws/buckingham.hpp"
#include "forces/laws/lennard_jones.hpp"
#include "forces/laws/mie.hpp"
#include "forces/laws/tabulated.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

template <class T = double>
class ShortRange {
 public:
  using Law = std::variant<LennardJones<T>, Mie<T>, Buckingham<T>, Tabulated<T>>;

  ShortRange() = default;
  template <class Chosen>
  explicit ShortRange(Chosen law) : law_(std::move(law)) {}

  bool is_lennard_jones() const { return std::holds_alternative<LennardJones<T>>(law_); }
  const Law& law() const { return law_; }
  bool is_zero() const { return is_lennard_jones() && lennard_jones().c12 == 0; }
  /// The potential u(r/factor), in which all distances are multiplied by a factor, in double
  /// precision.
  /// @throws Error  if the factor of a tabulated potential is not 1
  ShortRange scaled_by(double factor) const {
    if (factor == 1) return *this;
    return std::visit([&](const auto& law) { return ShortRange(law.scaled_by(factor)); }, law_);
  }
  ShortRange<float> rounded() const {
    return std::visit([](const auto& law) { return ShortRange<float>(law.rounded()); }, law_);
  }
  /// The parameters of a Lennard-Jones potential; other potentials are not allowed.
  LennardJones<T> lennard_jones() const { return std::get<LennardJones<T>>(law_); }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real r2) const {
    return std::visit([&](const auto& law) { return law(inverse_r, r2); }, law_);
  }
  double integral_beyond(double a) const {
    return std::visit([&](const auto& law) { return law.integral_beyond(a); }, law_);
  }

 private:
  Law law_;
};

/// The law with the parameters of a site, or of a pair. A law ignores σ and ε if it has other
/// parameters.
ShortRange<double> short_range(double sigma, double epsilon, const ShortRangeLaw& law);

/// The potential between two sites, mixed from the potentials of both sites. Either may be zero.
/// The mixing rule gives σ and ε, and mixed() of the law gives its other parameters.
/// @throws Error  if the laws are of different kinds, or refer to different tables
ShortRange<double> mix(const Site& a, const Site& b, MixingRule rule);

}  // namespace polhode
