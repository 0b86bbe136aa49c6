// SPDX-License-Identifier: MIT
// Vectors of LAMMPS, three doubles in memory.
#pragma once

#include "polhode/base/vec3.hpp"

namespace polhode::lammps {

inline Vec3<double> vector(const double* r) { return {r[0], r[1], r[2]}; }
inline void set(double* r, const Vec3<double>& v) { r[0] = v.x, r[1] = v.y, r[2] = v.z; }

/// The products of the components.
inline Vec3<double> componentwise(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace polhode::lammps
