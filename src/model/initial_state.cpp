// SPDX-License-Identifier: MIT
#include "model/initial_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"
#include "polhode/model/centre_of_mass.hpp"
#include "polhode/model/degrees_of_freedom.hpp"

namespace polhode {
namespace {

// Purposes of random numbers; each purpose has a separate stream.
enum Stream : std::uint64_t { shuffling, orientations, momenta };

// Numbers of lattice cells along each edge. Cells are added one by one, always along the edge with
// the longest cells, until all bodies fit.
std::array<std::size_t, 3> cells(std::size_t bodies, const Vec3<double>& edge) {
  std::array<std::size_t, 3> n = {1, 1, 1};
  while (n[0] * n[1] * n[2] < bodies) {
    std::size_t max_width = 0;
    const auto width = [&](std::size_t k) { return edge[k] / static_cast<double>(n[k]); };
    for (std::size_t k = 1; k < 3; ++k)
      if (width(k) > width(max_width)) max_width = k;
    ++n[max_width];
  }
  return n;
}

// Assigns a lattice point to every body. The assignment of points to components is random
// (Fisher-Yates shuffle). The bodies of each component are in lattice order, so that neighbours in
// the box are neighbours in memory.
std::vector<std::size_t> draw_lattice_points(const Topology& topology, std::size_t places,
                                             Random random) {
  std::vector<std::size_t> place(places);
  std::iota(place.begin(), place.end(), std::size_t{0});
  for (std::size_t i = places; i > 1; --i) std::swap(place[i - 1], place[random.below(i)]);
  auto first = place.begin();
  for (const auto& part : topology.parts) {
    const auto last = first + static_cast<std::ptrdiff_t>(part.count);
    std::sort(first, last);
    first = last;
  }
  return place;
}

}  // namespace

Box cubic_box(const Topology& topology, double density) {
  const double edge = std::cbrt(topology.mass() / density);
  return {{edge, edge, edge}};
}

State lattice(const Topology& topology, const Box& box, std::uint64_t seed) {
  if (!(std::min({box.edge.x, box.edge.y, box.edge.z}) > 0))
    throw Error("the shortest edge of the box is " + std::to_string(box.shortest_edge()) +
                " nm; it must be longer than 0 nm");
  const auto n = cells(topology.size(), box.edge);
  const auto place = draw_lattice_points(topology, n[0] * n[1] * n[2], Random(seed, shuffling));
  Random random(seed, orientations);
  State state(topology.size(), box);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const std::array cell = {place[i] % n[0], place[i] / n[0] % n[1], place[i] / (n[0] * n[1])};
    Vec3<double> q;
    for (std::size_t k = 0; k < 3; ++k)
      q[k] = (static_cast<double>(cell[k]) + 0.5) * box.edge[k] / static_cast<double>(n[k]);
    state.q.set(i, q);
    state.orientation.set(i, random.orientation());
  }
  return state;
}

void draw_momenta(State& state, const Topology& topology, double temperature, std::uint64_t seed) {
  const Bodies bodies(topology);
  const double kT = units::boltzmann * temperature;
  Random random(seed, momenta);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto normal3 = [&] {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      return Vec3<double>{x, y, z};
    };
    const Vec3<double> J = bodies.J[i];
    state.p.set(i, std::sqrt(bodies.m[i] * kT) * normal3());
    const Vec3<double> width{std::sqrt(J.x * kT), std::sqrt(J.y * kT), std::sqrt(J.z * kT)};
    state.ell.set(i, to_lab(state.orientation[i], scaled(width, normal3())));
  }
  remove_total_momentum(state, bodies);
  double twice_energy = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
    twice_energy +=
        norm2(state.p[i]) * bodies.inverse_m[i] + dot(L, scaled(bodies.inverse_J[i], L));
  }
  if (twice_energy == 0) return;
  const double factor = std::sqrt(degrees_of_freedom(topology).all() * kT / twice_energy);
  scale(state.p, factor);
  scale(state.ell, factor);
}

}  // namespace polhode
