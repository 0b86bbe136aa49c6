// SPDX-License-Identifier: MIT
#include "model/initial_state.hpp"

#include <algorithm>
#include <cmath>

#include "../errors.hpp"
#include "polhode/base/units.hpp"
#include "polhode/run/study/study.hpp"

using namespace polhode;

namespace {

Molecule bent() {
  return rigid_molecule("bent", {{.name = "A", .r = {0, 0, 0}, .mass = 16},
                                 {.name = "B", .r = {0.076, 0.059, 0}, .mass = 1},
                                 {.name = "C", .r = {-0.076, 0.059, 0}, .mass = 1}});
}
Molecule rod() {
  return rigid_molecule("rod", {{.name = "A", .r = {0, 0, 0}, .mass = 14},
                                {.name = "B", .r = {0.11, 0, 0}, .mass = 14}});
}
Molecule atom() { return rigid_molecule("atom", {{.name = "A", .mass = 40}}); }

}  // namespace

TEST_CASE("a lattice spreads molecules evenly and mixes components") {
  const Topology topology{{{bent(), 60}, {atom(), 65}}};
  const Box box = cubic_box(topology, 1000);
  CHECK(topology.mass() / box.volume() == doctest::Approx(1000).epsilon(1e-14));
  const State state = lattice(topology, box, 1);
  // 125 bodies fill 5 x 5 x 5 cells: neighbours are one cell apart.
  double nearest = 1e9;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      nearest = std::min(nearest, norm(box.minimum_image(state.q[i] - state.q[j])));
  CHECK(nearest == doctest::Approx(box.edge.x / 5).epsilon(1e-12));
  // Shuffled: the first component's mean height is that of 60 draws from 5 layers without
  // replacement, whose standard deviation is edge √(2/25) √((125 − 60)/(124 · 60)) = 0.026 edges.
  double height = 0;
  for (std::size_t i = 0; i < 60; ++i) height += state.q[i].z / 60 / box.edge.z;
  CHECK(std::abs(height - 0.5) < 5 * 0.027);
  // The bodies of a component follow the lattice: along x, then y, then z.
  const auto place = [&](std::size_t i) {
    const Vec3<double> cell = state.q[i] / (box.edge.x / 5);
    return 25 * std::floor(cell.z) + 5 * std::floor(cell.y) + std::floor(cell.x);
  };
  for (std::size_t i = 1; i < state.size(); ++i) CHECK((i == 60 || place(i - 1) < place(i)));
  const State again = lattice(topology, box, 1), other = lattice(topology, box, 2);
  CHECK(again.q[3] == state.q[3]);
  CHECK(again.orientation[3] == state.orientation[3]);
  CHECK(!(other.orientation[3] == state.orientation[3]));
}

TEST_CASE("a long box has more cells along its long edge") {
  const Topology topology{{{atom(), 32}}};
  const State state = lattice(topology, {{1, 1, 4}}, 1);
  // 2 x 2 x 8 cells of edge 0.5.
  double nearest = 1e9;
  for (std::size_t i = 1; i < state.size(); ++i)
    nearest = std::min(nearest, norm(state.box.minimum_image(state.q[i] - state.q[0])));
  CHECK(nearest == doctest::Approx(0.5).epsilon(1e-12));
  check_error([&] { lattice(topology, {{1, 1, 0}}, 1); }, {"0.000000 nm", "longer than 0 nm"});
}

TEST_CASE("momenta follow the Maxwell distribution") {
  const std::size_t n = 2000;
  const Topology topology{{{bent(), n}, {rod(), n}, {atom(), n}}};
  State state = lattice(topology, {{10, 10, 10}}, 5);
  const double T = 297, kT = units::boltzmann * T;
  draw_momenta(state, topology, T, 6);

  Vec3<double> total{};
  double twice_energy = 0;
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    Vec3<double> p2{}, L2{};
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      const Vec3<double> p = state.p[i], L = to_body(state.orientation[i], state.ell[i]);
      total += p;
      p2 += scaled(p, p) / static_cast<double>(n);
      L2 += scaled(L, L) / static_cast<double>(n);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      // Each component's share x²/(m kT) is a mean of n squares of normal deviates: standard error
      // √(2/n). Five of them; the removal of the total momentum and the rescaling change less, by
      // 1/n and √(2/(10 n)).
      const double five = 5 * std::sqrt(2.0 / static_cast<double>(n));
      CHECK(std::abs(p2[k] / (molecule.mass * kT) - 1) < five);
      if (molecule.J[k] > 0)
        CHECK(std::abs(L2[k] / (molecule.J[k] * kT) - 1) < five);
      else
        CHECK(L2[k] < 1e-28 * kT * 40);  // rounding of a vector turned into the lab and back
      twice_energy += static_cast<double>(n) * p2[k] / molecule.mass;
      if (molecule.J[k] > 0) twice_energy += static_cast<double>(n) * L2[k] / molecule.J[k];
    }
  }
  // Sums of 6000 momenta of about 10 u nm/ps, each rounded at 1e-16: below 6000 · 10 · 1e-16.
  CHECK(norm(total) < 6e-11);
  const double degrees_of_freedom = 3 * 3.0 * n - 3 + 3.0 * n + 2.0 * n;
  // As many rounded additions as above, which err in a random direction.
  CHECK(twice_energy / (degrees_of_freedom * kT) == doctest::Approx(1).epsilon(1e-13));
}

TEST_CASE("a single body rotates at the temperature without translation") {
  const Topology topology{{{rod(), 1}}};
  State state = lattice(topology, {{1, 1, 1}}, 1);
  draw_momenta(state, topology, 100, 1);
  const Vec3<double> L = to_body(state.orientation[0], state.ell[0]);
  const double J = topology.parts[0].molecule.J.y;
  CHECK(state.p[0] == Vec3<double>{});
  CHECK((L.y * L.y + L.z * L.z) / J == doctest::Approx(2 * units::boltzmann * 100).epsilon(1e-14));
  const Topology argon{{{atom(), 1}}};
  State lonely = lattice(argon, {{1, 1, 1}}, 1);
  draw_momenta(lonely, argon, 100, 1);
  CHECK(lonely.p[0] == Vec3<double>{});
}

// If seed and index were added, momenta of one initial configuration would recur with the next
// seed.
TEST_CASE("studies with consecutive seeds share no momenta") {
  const Topology topology{{{atom(), 3}}};
  std::vector<double> seen;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Config config = default_config();
    config.system.seed = seed;
    for (std::size_t r = 0; r < 20; ++r) {
      State state = lattice(topology, {{1, 1, 1}}, seed);
      draw_momenta(state, topology, 100, start_seed(config, r));
      seen.push_back(state.p[0].x);
    }
    State run = lattice(topology, {{1, 1, 1}}, seed);
    draw_momenta(run, topology, 100, seed);
    seen.push_back(run.p[0].x);
  }
  std::sort(seen.begin(), seen.end());
  CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}
