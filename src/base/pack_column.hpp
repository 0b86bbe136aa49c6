// SPDX-License-Identifier: MIT
// Loads and stores packs of column values, with one body per lane.
#pragma once

#include "polhode/base/column.hpp"

namespace polhode {

template <class Real>
Vec3<Real> load_pack(const Vec3Column& c, std::size_t i) {
  return {Real::load(&c.x[i]), Real::load(&c.y[i]), Real::load(&c.z[i])};
}

template <class Real>
Quaternion<Real> load_pack(const QuaternionColumn& c, std::size_t i) {
  return {Real::load(&c.w[i]), Real::load(&c.x[i]), Real::load(&c.y[i]), Real::load(&c.z[i])};
}

template <class Real>
void store_pack(const Vec3<Real>& v, Vec3Column& c, std::size_t i) {
  v.x.store(&c.x[i]);
  v.y.store(&c.y[i]);
  v.z.store(&c.z[i]);
}

template <class Real>
void store_pack(const Quaternion<Real>& q, QuaternionColumn& c, std::size_t i) {
  q.w.store(&c.w[i]);
  q.x.store(&c.x[i]);
  q.y.store(&c.y[i]);
  q.z.store(&c.z[i]);
}

}  // namespace polhode
