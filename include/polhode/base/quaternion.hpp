// SPDX-License-Identifier: MIT
// Unit quaternions as orientations: (w, x, y, z) is the active rotation A, body → lab. The
// transpose of A is the matrix S of the papers, lab → body: x_body = S x_lab.
#pragma once

#include "polhode/base/vec3.hpp"

namespace polhode {

template <class Real>
struct Quaternion {
  Real w{1}, x{}, y{}, z{};

  constexpr Vec3<Real> vector() const { return {x, y, z}; }

  friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

template <class Real>
constexpr Quaternion<Real> conjugate(const Quaternion<Real>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

template <class Real>
constexpr Real norm2(const Quaternion<Real>& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

template <class Real>
constexpr Quaternion<Real> scaled(const Quaternion<Real>& q, Real s) {
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}

/// The normalized quaternion q / |q|.
template <class Real>
Quaternion<Real> normalized(const Quaternion<Real>& q) {
  return scaled(q, Real(1) / sqrt(norm2(q)));
}

/// The matrix S of the papers, which takes lab-frame vectors to the body frame: x_body = S x_lab.
template <class Real>
constexpr Mat3<Real> matrix_S(const Quaternion<Real>& q) {
  const Real two(2);
  return {{q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z, two * (q.x * q.y + q.w * q.z),
           two * (q.x * q.z - q.w * q.y)},
          {two * (q.x * q.y - q.w * q.z), q.w * q.w - q.x * q.x + q.y * q.y - q.z * q.z,
           two * (q.y * q.z + q.w * q.x)},
          {two * (q.x * q.z + q.w * q.y), two * (q.y * q.z - q.w * q.x),
           q.w * q.w - q.x * q.x - q.y * q.y + q.z * q.z}};
}

/// The product S v, which expresses a lab-frame vector in the body frame.
template <class Real>
constexpr Vec3<Real> to_body(const Quaternion<Real>& q, const Vec3<Real>& v) {
  return matrix_S(q) * v;
}

/// The product Sᵀ v, which expresses a body-frame vector in the lab frame.
template <class Real>
constexpr Vec3<Real> to_lab(const Quaternion<Real>& q, const Vec3<Real>& v) {
  return transpose(matrix_S(q)) * v;
}

}  // namespace polhode
