// SPDX-License-Identifier: MIT
// The free rotation in closed form, for every top and any time.
#pragma once

#include "polhode/math/theta.hpp"
#include "polhode/rotor/orbit.hpp"

namespace polhode {

/// Two independent methods for the elliptic integral of the third kind.
enum class ThirdKind {
  carlson,  ///< Carlson's R_J by duplication within a half period, plus whole half periods
  theta,    ///< a linear term minus the argument of a theta function; R_J if ThetaIntegral does not
            ///< apply
};

/// The angle φ by which the body precesses about L, measured in frames that follow a body axis.
///
/// The usual angle [vanzon2007a] is measured in frames that follow the axis z that L circles. The
/// integrand for z contains 1 + N sn² with N = (J_y−J_x)J_z/((J_z−J_y)J_x). N diverges as J_y →
/// J_z, when L passes close to the axis. Following the axis x instead gives the same integral with
/// n = m/N. The smaller of n and N is used and is at most 1, so near-symmetric tops are not a
/// special case. In both cases, with the moment J_f of the axis to which L is closest (u = 0),
///
///     φ = |L| t/J_f ± κ ∫ sn²/(1 + n sn²) du from u₀ to u₀ + p t,   κ² = n(1+n)(n+m).
class PrecessionAngle {
 public:
  explicit PrecessionAngle(const Orbit& orbit, ThirdKind way = ThirdKind::carlson)
      : orbit_(orbit), way_(ThetaIntegral::applies(orbit.modulus) ? way : ThirdKind::carlson) {
    const double Jx = orbit.moment(orbit.x), Jy = orbit.moment(orbit.y), Jz = orbit.moment(orbit.z);
    const double m = orbit.modulus.k * orbit.modulus.k;
    const double N = std::abs(Jy - Jx) / std::abs(Jz - Jy) * (Jz / Jx);
    const bool about_z = N <= 1;
    const double ratio = orbit.Ax / orbit.Az;
    axis = about_z ? orbit.z : orbit.x;
    n_ = about_z ? N : ratio * ratio;
    steady_ = orbit.norm_L() / (about_z ? Jx : Jz);
    kappa_ = std::copysign(std::sqrt(n_ * (1 + n_) * (n_ + m)), about_z ? Jx - Jz : Jz - Jx);
  }

  /// The angle φ(t), without reduction to a single turn.
  /// @param v  result of Orbit::elapsed(t)
  /// @param u  result of Orbit::at(v)
  double operator()(double t, const Orbit::Elapsed& v, const JacobiFunctions& u) const {
    // The integral follows from the addition theorem of the third kind [byrd1971, 116.03]. The
    // remaining part from u₀ to u₀ + v depends on u₀ only through an angle. This angle never
    // crosses ±π, because the cosine is positive wherever the sine vanishes.
    const double sign = std::fmod(v.half_periods, 2.0) == 0 ? 1 : -1;
    const double s0 = orbit_.start().sn, sv = sign * v.reduced.sn;
    const double addition = std::atan2(std::abs(kappa_) * s0 * sv * u.sn,
                                       1 + n_ * u.sn * (u.sn) - n_ * s0 * sv * u.cn * u.dn);
    const double from_0 = way_ == ThirdKind::theta ? by_theta(t, v) : by_carlson(v);
    return steady_ * t + std::copysign(1.0, kappa_) * (from_0 + addition);
  }

  /// The integral |κ| ∫₀ᵛ sn²/(1 + n sn²) du for v = p t, from the theta functions.
  double by_theta(double t, const Orbit::Elapsed& v) const {
    const ThetaIntegral integral(n_, orbit_.modulus, orbit_.K);
    return integral.rate() * (orbit_.p * t) - integral.argument(v.v);
  }

  /// The precession angle, computed from R_J.
  double by_carlson(const Orbit::Elapsed& v) const {
    const double k = orbit_.modulus.k;
    if (orbit_.modulus.complement == 0) {
      const double root_n = std::sqrt(n_);
      return root_n * v.v - std::atan(root_n * v.reduced.sn);
    }
    double integral = std::copysign(
        third_kind_integral({std::abs(v.reduced.sn), v.reduced.cn, v.reduced.dn}, n_, k),
        v.reduced.sn);
    if (v.half_periods != 0)
      integral +=
          2 * v.half_periods * third_kind_integral({1, 0, orbit_.modulus.complement}, n_, k);
    return std::abs(kappa_) * integral;
  }

  std::size_t axis;  ///< body axis that the frames follow

 private:
  const Orbit& orbit_;
  ThirdKind way_;
  double n_, steady_, kappa_;
};

/// Computes the free rotation of a top over a time t in closed form.
///
/// @param J    principal moments [u nm²] in any order; at most one moment may be zero (linear body)
/// @param L    body-frame angular momentum [u nm²/ps], zero along a vanishing moment
/// @param t    time [ps], any sign and magnitude
/// @param way  method by which the integral of the third kind is computed
/// @return   rotation with |q| = 1 to within 2 ε, and L(t). Errors are a few ε (1 + k), where k is
///           the condition number: the change of the result, in ε, when each input changes by 1 ε.
///           k is about 4.6 |ω t| for a well-behaved top, and exponential in p t near the
///           separatrix. The digits do not depend on the scale of the units.
/// @source   jacobi1849; vanzon2007a; tests/unit/rotor_truth_test.cpp
inline FreeRotation closed_rotation(const Vec3<double>& J, const Vec3<double>& L, double t,
                                    ThirdKind way = ThirdKind::carlson) {
  const ScaledTop top(J, L, t);
  const bool linear = J.x == 0 || J.y == 0 || J.z == 0;
  if (linear || Orbit::is_stationary(top))
    return {rotation_quaternion(top.t * scaled(top.inverse_J(), top.L)), L};

  const Orbit orbit(top);
  const PrecessionAngle phi(orbit, way);
  const Orbit::Elapsed v = orbit.elapsed(top.t);
  const JacobiFunctions u = orbit.at(v);
  const Vec3<double> later = orbit.L_at(u);
  return {precession({top.L, phi.axis}, {later, phi.axis}, phi(top.t, v, u)),
          top.in_units_of_caller(later * (orbit.norm_L() / std::hypot(later.x, later.y, later.z)))};
}

}  // namespace polhode
