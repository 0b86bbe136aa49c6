// SPDX-License-Identifier: MIT
#include "forces/laws/resized.hpp"

#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

LennardJones<> resized(LennardJones<> law, double s) {
  const double s6 = std::pow(s, 6);
  return {law.c6 * s6, law.c12 * s6 * s6};
}
Mie<> resized(Mie<> law, double s) {
  law.sigma2 *= s * s;
  return law;
}
Buckingham<> resized(const Buckingham<>& law, double s) {
  return {law.A, law.B / s, law.c6 * std::pow(s, 6), law.inner_limit2 * s * s};
}
Tabulated<> resized(const Tabulated<>& law, double) {
  throw Error("the distances of table '" + law.table->name() +
              "' cannot be scaled, because the table would end before the cutoff");
}

}  // namespace

ShortRange<double> resized(const ShortRange<double>& potential, double factor) {
  if (factor == 1) return potential;
  return std::visit([&](const auto& law) { return ShortRange<double>(resized(law, factor)); },
                    potential.law());
}

}  // namespace polhode
