// SPDX-License-Identifier: MIT
// The thermal conductivity from made-up spectra of the heat flux, and segments with the heat flux.
#include <doctest/doctest.h>

#include <vector>

#include "io/settings/quantity.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica_file.hpp"

using namespace polhode;

namespace {

constexpr double T = 300, lambda = 0.85;  // [K], [W/(m K)]
constexpr double time_step = 0.004,
                 segment_length = time_step * steps_of_lags * windows_in_segment;  // [ps]

/// The spectrum of a flux whose correlations decrease with a time of 0.2 ps, times a factor.
BlockMeans::Block segment(double factor) {
  // SI, by CODATA 2018, independent of the units of the program: V S(0) = 2 k T² λ.
  constexpr double k_B = 1.380649e-23, N_A = 6.02214076e23;
  constexpr double kJ_per_mol = 1e3 / N_A, nm = 1e-9, ps = 1e-12;
  constexpr double S0 =
      2 * k_B * T * T * lambda / (kJ_per_mol * kJ_per_mol / (nm * ps));  // (kJ/mol)²/(nm ps)
  BlockMeans::Block block{1, {}};
  for (std::size_t b = 0; b < pressure_bins().size(); ++b) {
    const double wt = 2 * 3.14159265358979 * 0.2 * pressure_bins().middle(b) / segment_length;
    block.sum.push_back(factor * S0 / (1 + wt * wt));
  }
  return block;
}

MeasuredProperty measured() {
  const Topology topology{{{read_molecule("spce"), 100}}};
  const Mixing mixing;
  std::vector<Replica> replicas;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const double shift = 0.01 * static_cast<double>(k);
    Replica replica{.index = k, .step = time_step, .state = State{1, Box{Vec3<double>{3, 3, 3}}}};
    replica.conduction = {.state = replica.state,
                          .segments = std::vector<BlockMeans::Block>(12, segment(1)),
                          .paired = {{3, segment(1 + shift)}}};
    replicas.push_back(replica);
  }
  return estimate({&property("thermal-conductivity")}, {topology, mixing, {T, 0}, replicas});
}

MeasureSettings conduction_settings(const char* molecule) {
  MeasureRequest request{.system = molecule, .properties = {"thermal-conductivity"}};
  request.molecules = {"32", "molecules"};
  request.at = {"160 K, 500 bar", "at"};
  return request.settings();
}

}  // namespace

// The exact spectrum is fitted by polynomials in the square of the frequency, to a thousandth.
TEST_CASE("the thermal conductivity is V S(0)/(2 k T²) with the spectrum of the heat flux") {
  const MeasuredProperty m = measured();
  REQUIRE(m.value.known == Known::yes);
  CHECK(m.value.value == doctest::Approx(lambda).epsilon(1e-3));
  REQUIRE(m.step_bound);
  // The mean over pairs of -0, -1, -2 and -3 % at half of the step.
  CHECK(m.step_bound->difference.value == doctest::Approx(-0.015 * lambda).epsilon(1e-3));
}

TEST_CASE("segments with the heat flux have the same bits in one piece and in several") {
  const MeasureSettings settings = conduction_settings("argon");
  const auto after = [&](std::size_t segments, const std::string& record) {
    return perform(settings, {0, 3, {3, 0, 0, 0, 0, segments}, 0.02, record});
  };
  const std::string one = after(1, ""), both = after(2, "");
  CHECK(after(2, one) == both);
  const PointSystem point(settings, settings.points.front());
  const Replica replica = parse_replica(both, "record", 3, point.identity);
  CHECK(replica_bytes(replica, point.identity) == both);
  REQUIRE(replica.conduction.segments.size() == 2);
  CHECK(replica.conduction.paired.size() == 1);
  CHECK(replica.dynamics.segments.empty());
  for (const double power : replica.conduction.segments.front().sum) CHECK(power > 0);
}

TEST_CASE("the thermal conductivity of a mixture, or with the dispersion of a slab, is refused") {
  const Property& conductivity = property("thermal-conductivity");
  const Topology one{{{read_molecule("argon"), 64}}},
      mixture{{{read_molecule("argon"), 32}, {read_molecule("n2"), 32}}};
  CHECK(why_not(conductivity, one, {}).empty());
  CHECK(why_not(conductivity, one, {.slab_dispersion = true}).find("dispersion_correction") !=
        std::string::npos);
  CHECK(why_not(conductivity, mixture, {}).find("partial enthalpies") != std::string::npos);
}
