// SPDX-License-Identifier: MIT
// The trajectory of the angular momentum in the body frame, in Jacobi's elliptic functions of time.
// The energy ellipsoid and the sphere |L| = const intersect in two loops, and the trajectory is one
// of these loops.
#pragma once

#include <cmath>
#include <cstddef>

#include "polhode/math/elliptic.hpp"
#include "polhode/rotor/scaled_top.hpp"

namespace polhode {

/// The orbit of the body-frame angular momentum: L_x = A_x cn u, L_y = A_y sn u, L_z = A_z dn u
/// with u = u₀ + p t. L circles the axis z, the axis y has the middle moment, and x is the third
/// axis. The amplitudes have signs, so the axes may be left-handed, and the moments may be in any
/// order [jacobi1849; vanzon2007a, Sec. 3, with positive amplitudes].
///
/// Every invariant is computed from the components of L, as a sum of terms with the same sign.
/// Therefore 2E J − L² is never computed as a difference. Square roots are stored instead of
/// squares, because even a component of 1e-170 decides when a body flips over near its middle axis.
class Orbit {
 public:
  /// @param top  top with three positive moments and with L not parallel to ω = J⁻¹ L (check this
  ///   with is_stationary())
  explicit Orbit(const ScaledTop& top) : moment_(top.J), L_(std::hypot(top.L.x, top.L.y, top.L.z)) {
    const Vec3<double>& J = top.J;
    std::size_t low = 0, middle = 1, high = 2;
    if (J[middle] < J[low]) std::swap(low, middle);
    if (J[high] < J[middle]) std::swap(high, middle);
    if (J[middle] < J[low]) std::swap(low, middle);

    // The sign of L² − 2E J_y = (α − β)(α + β) decides which of the two extreme axes L circles.
    const double alpha = std::abs(top.L[high]) * std::sqrt((J[high] - J[middle]) / J[high]);
    const double beta = std::abs(top.L[low]) * std::sqrt((J[middle] - J[low]) / J[low]);
    x = alpha >= beta ? low : high;
    y = middle;
    z = alpha >= beta ? high : low;
    const bool cyclic = (x + 1) % 3 == y;

    const double zx = std::abs(J[z] - J[x]), zy = std::abs(J[z] - J[y]), yx = std::abs(J[y] - J[x]);
    const Vec3<double>& L = top.L;
    // W_z = |2E J_z − L²|, W_x = |2E J_x − L²|
    const double root_Wz = std::hypot(L[x] * std::sqrt(zx / J[x]), L[y] * std::sqrt(zy / J[y]));
    const double root_Wx = std::hypot(L[y] * std::sqrt(yx / J[y]), L[z] * std::sqrt(zx / J[z]));
    Ax = std::sqrt(J[x] / zx) * root_Wz;
    Ay = std::sqrt(J[y] / zy) * root_Wz;
    Az = std::copysign(std::sqrt(J[z] / zx) * root_Wx, L[z]);
    if ((J[z] > J[x]) != ((Az > 0) == cyclic))
      Ax = -Ax;  // The sign of A_x makes L_y' equal to A_y
                 // p cn dn.
    p = std::sqrt(zy / (J[x] * J[y] * J[z])) * root_Wx;
    modulus.k = std::min(1.0, std::sqrt(yx / zy) * (root_Wz / root_Wx));
    // 1 − m = (J_z − J_x)(L² − 2E J_y)/(...), computed from L² − 2E J_y, because 1 − m would lose
    // digits
    modulus.complement = std::min(1.0, std::sqrt(zx / zy) * (std::sqrt(std::abs(alpha - beta)) *
                                                             std::sqrt(alpha + beta) / root_Wx));
    K = quarter_period(modulus);
    start_ = {L[y] / Ay, L[x] / Ax, L[z] / Az};
  }

  /// Whether the body-frame L is constant, L × J⁻¹L = 0. L is constant for spherical tops, for
  /// rotation about a principal axis, and for L = 0.
  static bool is_stationary(const ScaledTop& top) {
    const auto parallel = [&](std::size_t i, std::size_t j) {
      return top.L[i] * top.L[j] * (top.J[i] - top.J[j]) == 0;
    };
    return parallel(0, 1) && parallel(1, 2) && parallel(2, 0);
  }

  /// The functions sn, cn and dn of p t, where t is reduced by `half_periods` times 2K/p.
  struct Elapsed {
    JacobiFunctions reduced;  ///< functions of the reduced argument, |v| ≤ K
    double half_periods;
    double v;  ///< reduced argument
  };
  Elapsed elapsed(double t) const {
    const double v = p * t;
    const double count = std::isinf(K) ? 0.0 : std::nearbyint(v / (2 * K));
    const double rest = count == 0 ? v : std::clamp(v - count * (2 * K), -K, K);
    return {jacobi_functions(rest, modulus, K), count, rest};
  }

  /// The functions sn, cn and dn of u = u₀ + p t by the addition theorem. No inverse function is
  /// needed, because sn, cn and dn of u₀ are ratios of components of L.
  JacobiFunctions at(const Elapsed& v) const {
    const auto [s0, c0, d0] = start_;
    const auto [s, c, d] = v.reduced;
    // The denominator is 1 − m s0² s² = c0² + s0² d². c0² and s0² d² may be as small as 1e-340, so
    // c0 and s0 d are first divided by the larger of the two.
    const double scale = 1 / std::max(std::abs(c0), std::abs(s0) * d);
    const double C0 = c0 * scale, D0 = d0 * scale, C = c * scale, D = d * scale;
    const double denominator = C0 * C0 + s0 * s0 * D * D;
    const double sn = (s0 * C * D + s * C0 * D0) / denominator;
    const double cn = (C0 * C - s0 * s * D0 * D) / denominator;
    const double sign = std::fmod(v.half_periods, 2.0) == 0 ? 1 : -1;
    // The addition theorem for dn would lose digits near the minimum k' of dn.
    return {sign * sn, sign * cn, std::hypot(modulus.complement, modulus.k * cn)};
  }

  Vec3<double> L_at(const JacobiFunctions& f) const {
    Vec3<double> l;
    l[x] = Ax * f.cn;
    l[y] = Ay * f.sn;
    l[z] = Az * f.dn;
    return l;
  }

  const JacobiFunctions& start() const { return start_; }
  double moment(std::size_t axis) const { return moment_[axis]; }
  double norm_L() const { return L_; }

  std::size_t x, y, z;  ///< indices of the body axes that this class calls x, y and z
  double Ax, Ay, Az;    ///< amplitudes of the components of L [units of L]
  double p;             ///< rate of u [1/time]
  Modulus modulus;      ///< modulus k and its complement k'
  double K;             ///< quarter period in u; infinite at the separatrix

 private:
  Vec3<double> moment_;
  double L_;
  JacobiFunctions start_;
};

/// A frame (c₁, c₂, c₃), stored by columns, with c₃ = L/|L| and c₁ along L × e for a body axis e.
struct PrecessionFrame {
  Vec3<double> c1, c2, c3;

  /// @param L     angular momentum, not parallel to `axis`; small components need full relative
  ///   accuracy
  /// @param norm  norm |L|
  PrecessionFrame(const Vec3<double>& L, std::size_t axis) {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double across = std::hypot(L[i], L[j]);
    const double norm = std::hypot(across, L[axis]);
    c3 = L / norm;
    c1[i] = L[j] / across;
    c1[j] = -L[i] / across;
    c2 = cross(c3, c1);
  }
};

/// The rotation from the frame `before` to the frame `after`, with a precession by phi about L. The
/// matrix is P = M(after) R_z(phi) M(before)ᵀ with the passive rotation R_z [vanzon2007a, Sec. 3].
inline Quaternion<double> precession(const PrecessionFrame& before, const PrecessionFrame& after,
                                     double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  const Vec3<double> u = c * before.c1 + s * before.c2;
  const Vec3<double> v = c * before.c2 - s * before.c1;
  Mat3<double> active;  // Pᵀ = u c₁ᵀ + v c₂ᵀ + c₃(0) c₃ᵀ
  for (std::size_t i = 0; i < 3; ++i)
    active[i] = u[i] * after.c1 + v[i] * after.c2 + before.c3[i] * after.c3;
  return quaternion_of(active);
}

}  // namespace polhode
