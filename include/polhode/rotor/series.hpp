// SPDX-License-Identifier: MIT
// The free rotation over one time step, branch-free, for numbers and packs alike.
#pragma once

#include "polhode/base/quaternion.hpp"

namespace polhode {

template <class Real>
Quaternion<Real> rotation_series(const Vec3<Real>& inverse_J, const Vec3<Real>& L, Real t) {
  constexpr int order = 18;
  Quaternion<Real> q[order + 1];
  Vec3<Real> l[order + 1], w[order + 1];
  q[0] = {Real(1), Real(0), Real(0), Real(0)};
  l[0] = L;
  w[0] = scaled(inverse_J, L);
  Quaternion<Real> r = q[0];
  Real power(1);
  for (int n = 0; n < order; ++n) {
    Quaternion<Real> dq{Real(0), Real(0), Real(0), Real(0)};
    Vec3<Real> dl{Real(0), Real(0), Real(0)};
    for (int k = 0; k <= n; ++k) {
      const Quaternion<Real> term =
          q[k] * Quaternion<Real>{Real(0), w[n - k].x, w[n - k].y, w[n - k].z};
      dq = {dq.w + term.w, dq.x + term.x, dq.y + term.y, dq.z + term.z};
      dl += cross(l[k], w[n - k]);
    }
    q[n + 1] = scaled(dq, Real(0.5 / (n + 1)));
    l[n + 1] = dl * Real(1.0 / (n + 1));
    w[n + 1] = scaled(inverse_J, l[n + 1]);
    power = power * t;
    r = {r.w + power * q[n + 1].w, r.x + power * q[n + 1].x, r.y + power * q[n + 1].y,
         r.z + power * q[n + 1].z};
  }
  return r;
}

}  // namespace polhode
