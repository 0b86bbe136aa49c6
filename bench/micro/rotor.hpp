// SPDX-License-Identifier: MIT
// Bodies to rotate.
#pragma once

#include "polhode/base/column.hpp"

namespace polhode::bench {

struct Tops {
  QuaternionColumn orientation;
  Vec3Column ell, inverse_J;
  explicit Tops(std::size_t count) : orientation(count), ell(count), inverse_J(count) {}
  std::size_t size() const { return ell.size(); }
};

}  // namespace polhode::bench
