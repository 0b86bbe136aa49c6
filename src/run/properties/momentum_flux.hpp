// SPDX-License-Identifier: MIT
// The time integrals of the pressure tensor, from which the viscosity follows.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// The five independent components of a traceless symmetric tensor, which have equal variances in a
/// fluid [daivis1994].
inline std::array<double, 5> independent_components(const Mat3<double>& P) {
  const double xy = (P[0].y + P[1].x) / 2, yz = (P[1].z + P[2].y) / 2, zx = (P[2].x + P[0].z) / 2;
  return {(2 * P[0].x - P[1].y - P[2].z) / (2 * std::sqrt(3.0)), (P[1].y - P[2].z) / 2, yz, zx, xy};
}

/// The time integrals of five pressure tensor components by the trapezoidal rule, stored as
/// displacements of two bodies. Their mean square grows like the displacement of a diffusing
/// particle.
class MomentumFlux {
 public:
  /// @param interval  time between samples [ps]
  explicit MomentumFlux(double interval) : interval_(interval) {}

  /// Adds the next sample of the pressure tensor. The integrals begin at the first sample.
  void add(const Mat3<double>& pressure) {
    const std::array<double, 5> now = independent_components(pressure);
    for (std::size_t k = 0; k < now.size(); ++k)
      integral_[k] += first_ ? 0 : (last_[k] + now[k]) / 2 * interval_;
    last_ = now;
    first_ = false;
  }
  /// Returns three of the integrals for body 0, and the other two for body 1 [kJ/mol/nm³ ps].
  Vec3<double> displacement(std::size_t body) const {
    return body == 0 ? Vec3<double>{integral_[0], integral_[1], integral_[2]}
                     : Vec3<double>{integral_[3], integral_[4], 0};
  }

 private:
  double interval_;
  bool first_ = true;
  std::array<double, 5> integral_{}, last_{};
};

}  // namespace polhode
