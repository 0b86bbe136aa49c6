// SPDX-License-Identifier: MIT
// Three-dimensional vectors and matrices over any Real: double, float, a pack, a dual number.
#pragma once

#include <cstddef>

#include "polhode/base/real.hpp"

namespace polhode {

template <class Real>
struct Vec3 {
  Real x{}, y{}, z{};

  constexpr Real& operator[](std::size_t k) { return k == 0 ? x : k == 1 ? y : z; }
  constexpr const Real& operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }

  constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  constexpr Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  constexpr Vec3& operator*=(Real s) { return *this = *this * s; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(Real s, const Vec3& a) { return a * s; }
  friend constexpr Vec3 operator/(const Vec3& a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

template <class Real>
constexpr Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Adds a cross product, sum += a × b, in an order suited to fused multiply-adds.
template <class Real>
constexpr void add_cross(Vec3<Real>& sum, const Vec3<Real>& a, const Vec3<Real>& b) {
  add_product(sum.x, a.y, b.z);
  add_product(sum.y, a.z, b.x);
  add_product(sum.z, a.x, b.y);
  subtract_product(sum.x, a.z, b.y);
  subtract_product(sum.y, a.x, b.z);
  subtract_product(sum.z, a.y, b.x);
}

/// Adds a scaled vector, sum += s a.
template <class Real>
constexpr void add_scaled(Vec3<Real>& sum, const Real& s, const Vec3<Real>& a) {
  add_product(sum.x, s, a.x);
  add_product(sum.y, s, a.y);
  add_product(sum.z, s, a.z);
}

/// The element-wise product of two vectors, such as J⁻¹ L for a diagonal tensor J held as a Vec3.
template <class Real>
constexpr Vec3<Real> scaled(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <class Real>
constexpr Real norm2(const Vec3<Real>& a) {
  return dot(a, a);
}

template <class Real>
Real norm(const Vec3<Real>& a) {
  return sqrt(norm2(a));
}

/// A 3 × 3 matrix, stored by rows.
template <class Real>
struct Mat3 {
  Vec3<Real> row0{}, row1{}, row2{};

  constexpr Vec3<Real>& operator[](std::size_t k) { return k == 0 ? row0 : k == 1 ? row1 : row2; }
  constexpr const Vec3<Real>& operator[](std::size_t k) const {
    return k == 0 ? row0 : k == 1 ? row1 : row2;
  }

  friend constexpr Vec3<Real> operator*(const Mat3& m, const Vec3<Real>& v) {
    return {dot(m.row0, v), dot(m.row1, v), dot(m.row2, v)};
  }
};

template <class Real>
constexpr Mat3<Real> transpose(const Mat3<Real>& m) {
  return {{m.row0.x, m.row1.x, m.row2.x},
          {m.row0.y, m.row1.y, m.row2.y},
          {m.row0.z, m.row1.z, m.row2.z}};
}

template <class Real>
constexpr Mat3<Real> operator*(const Mat3<Real>& a, const Mat3<Real>& b) {
  const Mat3<Real> bt = transpose(b);
  return {bt * a.row0, bt * a.row1, bt * a.row2};
}

}  // namespace polhode
