// SPDX-License-Identifier: MIT
// Diffusion and viscosity from made-up displacements in the long box of OrthoBoXY.
#include <doctest/doctest.h>

#include <vector>

#include "polhode/io/topology/molecule_file.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

namespace {

// SI, by CODATA 2018, independent of the units of the program.
constexpr double k_B = 1.380649e-23, nm = 1e-9, pi = 3.14159265358979323846;
constexpr double T = 300, liquid_viscosity = 0.7e-3;                              // [K], [Pa s]
constexpr double side = 1.5;                                                      // [nm]
constexpr double ratio = 2.7933596497;                                            // [busch2023]
constexpr double time_step = 0.004, interval = time_step * steps_of_lags / lags;  // [ps]
constexpr double D0 = 3e-9;                                                       // [m²/s]

/// Displacements along the axes in a segment, times a factor.
BlockMeans::Block segment(double factor) {
  const double slower = 8.1711245653 * k_B * T / (6 * pi * liquid_viscosity * ratio * side * nm);
  BlockMeans::Block block{1000, std::vector<double>(3 * lags)};
  for (std::size_t k = 0; k < 3 * lags; ++k) {
    double D = D0 - slower;
    if (k < 2 * lags) D = k < lags ? D0 + 1e-10 : D0 - 1e-10;
    const double t = static_cast<double>(k % lags) * interval;
    block.sum[k] = block.weight * (2 * factor * D * 1e6 * t + 0.01);  // m²/s = 1e6 nm²/ps
  }
  return block;
}

std::vector<Replica> replicas() {
  std::vector<Replica> list;
  for (std::uint64_t k = 0; k < 4; ++k) {
    Replica replica{.index = k, .step = time_step, .state = State{1, Box{Vec3<double>{3, 3, 3}}}};
    replica.elongated = {State{1, Box{Vec3<double>{side, side, ratio * side}}},
                         std::vector<BlockMeans::Block>(12, segment(1)),
                         {{3, segment(1 + 0.01 * static_cast<double>(k))}}};
    list.push_back(replica);
  }
  return list;
}

MeasuredProperty measured(const char* name) {
  const Topology topology{{{read_molecule("spce"), 100}}};
  const Mixing mixing;
  return estimate({&property(name)}, {topology, mixing, {T, 0}, replicas()});
}

}  // namespace

// In a box of this ratio, Dx = Dy = D0, and Dz is smaller by 8.1711245653 kT/(6π η Lz) [busch2023].
TEST_CASE("a long box has diffusion without a correction, and the viscosity") {
  const MeasuredProperty D = measured("diffusion-orthoboxy");
  REQUIRE(D.value.known == Known::yes);
  CHECK(!D.finite_size);
  CHECK(D.value.value == doctest::Approx(D0 * 1e9).epsilon(1e-9));
  REQUIRE(D.step_bound);
  // The mean over pairs of -0, -1, -2 and -3 % at half of the step.
  CHECK(D.step_bound->difference.value == doctest::Approx(-0.015 * D0 * 1e9).epsilon(1e-6));
  const MeasuredProperty viscosity = measured("viscosity-orthoboxy");
  REQUIRE(viscosity.value.known == Known::yes);
  // The constants of the program have ten digits, and their difference loses one.
  CHECK(viscosity.value.value == doctest::Approx(liquid_viscosity * 1e3).epsilon(1e-8));
  CHECK(measured("diffusion").value.known != Known::yes);
}
