// SPDX-License-Identifier: MIT
// Functions common to XTC and TRR files: XDR numbers, boxes as three vectors, atoms without names.
#pragma once

#include "binary.hpp"

namespace polhode {

inline constexpr std::endian xdr = std::endian::big;

/// The three vectors of a box, each with x, y, z [nm].
template <class Real>
Box take_box(BinaryInput& in) {
  std::array<double, 9> m;
  for (double& x : m) x = static_cast<double>(in.take<Real>("the box"));
  for (std::size_t k = 0; k < 9; ++k) {
    if (!std::isfinite(m[k])) in.refuse("the box has a number that is not finite");
    if (k % 4 != 0 && m[k] != 0)
      in.refuse(
          "the box is triclinic, and only rectangular (orthorhombic) boxes are supported; build "
          "the system in a rectangular box, for example with gmx solvate -box 3 3 3");
    if (k % 4 == 0 && !(m[k] > 0))
      in.refuse(fmt::format("a box edge is {} nm; it must be longer than 0 nm", m[k]));
  }
  return {{m[0], m[4], m[8]}};
}

inline void put_box(BinaryOutput& out, const Box& box) {
  for (std::size_t k = 0; k < 9; ++k)
    out.put(k % 4 == 0 ? static_cast<float>(box.edge[k / 4]) : 0.0f);
}

inline void put_vector(BinaryOutput& out, const Vec3<double>& v) {
  for (std::size_t k = 0; k < 3; ++k) out.put(static_cast<float>(v[k]));
}

/// The number of atoms in a header.
inline std::size_t take_count(BinaryInput& in) {
  const auto count = in.take<std::int32_t>("the number of atoms");
  if (count < 0) in.refuse(fmt::format("the number of atoms is {}; it must be 0 or more", count));
  return static_cast<std::size_t>(count);
}

}  // namespace polhode
