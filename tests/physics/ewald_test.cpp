// SPDX-License-Identifier: MIT
// Direct Ewald sums: published energies of water, and independence of the splitting parameter.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include "ewald.hpp"
#include "physics/force_laws.hpp"
#include "polhode/base/units.hpp"
#include "skip.hpp"

using namespace polhode;

namespace {

// The folder of the reference configurations: next to the project, or in an environment variable.
std::string nist_file(const std::string& name) {
  const char* const folder = std::getenv("POLHODE_NIST_SPCE");
  const std::string tests = POLHODE_TEST_DATA;
  return (folder ? std::string(folder) : tests + "/../../../shared/data/nist_spce") + "/" + name;
}

PointCharges nist_water(std::istream& in, const Box& cube) {
  PointCharges water;
  Vec3<double> r;
  while (in >> r.x >> r.y >> r.z) {  // rows H, H, O [Å]
    const std::size_t k = water.size();
    water.r.push_back(0.1 * r);
    if (k % 3 > 0) {  // atoms are in the box, so those of a molecule may be on different sides
      const Vec3<double>& first = water.r[k / 3 * 3];
      water.r[k] = first + cube.minimum_image(water.r[k] - first);
    }
    water.q.push_back(k % 3 == 2 ? -0.84760 : 0.42380);
    water.body.push_back(k / 3);
  }
  return water;
}

// Random charges, some in pairs of one body, with a net charge.
PointCharges few_charges(const Box& box, unsigned seed) {
  PointCharges charges;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> even;
  for (std::size_t body = 0; body < 5; ++body) {
    const Vec3<double> at{even(random), even(random), even(random)};
    for (std::size_t k = 0; k <= body % 2; ++k) {
      charges.r.push_back(scaled(at, box.edge) + 0.1 * double(k) * Vec3<double>{0.6, 0.8, 0.1});
      charges.q.push_back(even(random) + (body % 3 == 0 ? -1.2 : 0.1));
      charges.body.push_back(body);
    }
  }
  return charges;
}

constexpr EwaldRange all{1.3, 120};
const Box box{{1.1, 1.3, 1.2}};

}  // namespace

// Six digits of E/k_B [K] with the constants of that page, CODATA 2010.
TEST_CASE("energies of water by term equal those published by NIST") {
  struct Row {
    int configuration;
    double edge;  // [nm]
    double van_der_waals, tail, real, reciprocal, self, intramolecular;
  };
  const std::array<Row, 4> rows{
      {{1, 2, 9.95387e4, -8.23715e2, -5.58889e5, 6.27009e3, -2.84469e6, 2.80999e6},
       {2, 2, 1.93712e5, -3.29486e3, -1.19295e6, 6.03495e3, -5.68938e6, 5.61998e6},
       {3, 2, 3.54344e5, -7.41343e3, -1.96297e6, 5.24461e3, -8.53407e6, 8.42998e6},
       {4, 3, 4.48593e5, -1.37286e4, -3.57226e6, 7.58785e3, -1.42235e7, 1.41483e7}}};
  const double boltzmann = 1.3806488e-23, charge = 1.602176565e-19, permittivity = 8.854187817e-12;
  const double strength =
      charge * charge / (4 * units::pi * permittivity * boltzmann) * 1e9;  // [K nm]
  const double sigma = 0.316555789, epsilon = 78.19743111;                 // [nm], [K]
  for (const Row& row : rows) {
    const std::string path =
        nist_file("spce" + std::to_string(row.configuration) + ".etomica_HHO.pos");
    std::ifstream in(path);
    if (!in) {
      return skip("there is no " + path + "; set POLHODE_NIST_SPCE to its folder");
    }
    CAPTURE(row.configuration);
    const Box cube{{row.edge, row.edge, row.edge}};
    const PointCharges water = nist_water(in, cube);
    const auto six_digits = [](double value, double published) {
      const double unit = std::pow(10, std::floor(std::log10(std::abs(published))) - 5);
      CAPTURE(value);
      CAPTURE(published);
      CHECK(std::abs(value - published) < 0.501 * unit);
    };
    // |n|² < 27
    const EwaldEnergies e = ewald_sum(water, cube, GaussianSplit{5.6 / row.edge},
                                      {1.0, 2 * units::pi / row.edge * std::sqrt(26.5)})
                                .energy;
    const double kelvin = strength / units::coulomb;
    six_digits(kelvin * e.pairs, row.real);
    six_digits(kelvin * e.reciprocal, row.reciprocal);
    six_digits(kelvin * e.self, row.self);
    six_digits(kelvin * e.intramolecular, row.intramolecular);
    CHECK(std::abs(e.background) < 1e-15 * std::abs(e.self));

    const auto lj = LennardJones<>::of(sigma, epsilon);
    double u = 0;
    for (std::size_t i = 2; i < water.size(); i += 3)
      for (std::size_t j = i + 3; j < water.size(); j += 3) {
        const double r2 = norm2(cube.minimum_image(water.r[j] - water.r[i]));
        if (r2 < 1) u += lj(InversePowers<double>(r2), r2).u;
      }
    six_digits(u, row.van_der_waals);
    const double molecules = double(water.size()) / 3;
    six_digits(2 * units::pi / 3 * molecules * molecules / cube.volume() * (lj.c12 / 3 - lj.c6),
               row.tail);
  }
}

// Both ranges are long enough that the truncation error is below rounding: erfc(6 × 1.3), and
// exp(−120²/(4 × 36)). The energy loses digits to its terms of 10⁴ kJ/mol, in about a hundred
// roundings.
TEST_CASE("the Ewald sum does not depend on the splitting parameter") {
  const PointCharges charges = few_charges(box, 5);
  const EwaldSum reference = ewald_sum(charges, box, GaussianSplit{6}, all);
  CHECK(std::abs(reference.energy.background) > 1);
  CHECK(std::abs(reference.energy.intramolecular) > 1);
  const auto check = [&](const EwaldSum& sum, double tolerance) {
    CHECK(std::abs(sum.energy.total() - reference.energy.total()) < tolerance);
    for (std::size_t i = 0; i < charges.size(); ++i)
      CHECK(norm(sum.f[i] - reference.f[i]) < 20 * tolerance);
    CHECK(largest_difference(sum.virial, reference.virial) < 20 * tolerance);
  };
  check(ewald_sum(charges, box, GaussianSplit{6.5}, all), 1e-12 * 1e4);
  // The transform falls as (k a)^−(m+2), from (2m+3)!!: 1e-12 where k a is a few times m.
  check(ewald_sum(charges, box, CompactSplit(0.9, 12), {0.9, 160}), 1e-12 * 1e4);
  check(ewald_sum(charges, box, CompactSplit(1.0, 10), {1.0, 160}), 1e-12 * 1e4);
  check(ewald_sum(charges, box, CompactSplit(1.25, 14), {1.25, 160}), 1e-12 * 1e4);
}

// Central differences of fourth order with a step of 1e-3 nm: h⁴/30 of the fifth derivative of the
// closest pair is 1e-8 of its force, roundings divided by h are smaller.
TEST_CASE("forces and virial of the Ewald sum are derivatives of its energy") {
  const PointCharges charges = few_charges(box, 6);
  const auto check = [&](const auto& split, const EwaldRange& range) {
    const EwaldSum sum = ewald_sum(charges, box, split, range);
    const auto slope = [](const auto& energy, double h) {
      return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    };
    for (std::size_t d = 0; d < 3; ++d) {
      const auto displaced = [&](double x) {
        PointCharges there = charges;
        there.r[1][d] += x;
        return ewald_sum(there, box, split, range).energy.total();
      };
      CHECK(std::abs(slope(displaced, 1e-3) + sum.f[1][d]) < 1e-6 * norm(sum.f[1]));
    }
    // Wave vectors change with the strain, so their range must not truncate any that contribute.
    for (std::size_t d = 0; d < 3; ++d) {
      const auto strained = [&](double x) {
        PointCharges there = charges;
        for (Vec3<double>& r : there.r) r[d] *= 1 + x;
        Box other = box;
        other.edge[d] *= 1 + x;
        return ewald_sum(there, other, split, range).energy.total();
      };
      CHECK(std::abs(slope(strained, 1e-3) + sum.virial[d][d]) < 1e-6 * largest(sum.virial));
    }
  };
  check(GaussianSplit{6}, {1.3, 80});
  check(CompactSplit(0.9, 10), {0.9, 110});
}
