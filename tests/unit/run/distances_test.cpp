// SPDX-License-Identifier: MIT
// Radial distribution functions in the records of replicas, and the coordination number from them.
#include "run/properties/distances.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

namespace {

State random_state(const Topology& topology, const Vec3<double>& edge, std::uint64_t seed) {
  State state(topology.size(), Box{edge});
  Random random(seed);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    state.q.set(i, scaled(edge, Vec3<double>{x, y, z}));
    state.orientation.set(i, random.orientation());
  }
  return state;
}

constexpr std::size_t cells = 4;  // of a face-centred cubic lattice, per edge
constexpr std::size_t atoms = 4 * cells * cells * cells;
const Topology& argon() {
  static const Topology topology{{{read_molecule("argon"), atoms}}};
  return topology;
}

/// A face-centred cubic lattice with an rms displacement of a/40 along each axis.
State lattice(double a, Random& random) {
  constexpr std::array basis = {Vec3<double>{0, 0, 0}, Vec3<double>{0, 0.5, 0.5},
                                Vec3<double>{0.5, 0, 0.5}, Vec3<double>{0.5, 0.5, 0}};
  const double edge = a * cells;
  State state(atoms, Box{{edge, edge, edge}});
  for (std::size_t i = 0; i < atoms; ++i) {
    const std::size_t cell = i / 4;
    const Vec3<double> r{static_cast<double>(cell % cells),
                         static_cast<double>(cell / cells % cells),
                         static_cast<double>(cell / cells / cells)};
    const double x = random.normal(), y = random.normal(), z = random.normal();
    state.q.set(i, a * (r + basis[i % 4] + Vec3<double>{x, y, z} / 40.0));
  }
  return state;
}

/// A segment of dynamics whose correlation functions and spectrum are zero.
BlockMeans::Block lattice_segment(double a, Random& random) {
  constexpr std::size_t frames = 3;
  const std::size_t functions = CorrelationsOfDynamics(argon()).count * lags;
  BlockMeans::Block block{700, std::vector<double>(functions + pressure_bins().size())};
  Distances distances = Distances::within(argon(), lattice(a, random).box);
  for (std::size_t k = 0; k < frames; ++k) distances.add(lattice(a, random));
  for (const double mean : distances.means()) block.sum.push_back(block.weight * mean);
  return block;
}

/// Replicas of slightly different edges, as replicas have them.
std::vector<Replica> replicas_of(std::size_t segments) {
  std::vector<Replica> replicas;
  for (std::uint64_t k = 0; k < 4; ++k) {
    Random random(8, k);
    const double a = 0.53 + 0.001 * static_cast<double>(k);
    Replica replica{.index = k, .step = 0.004, .state = lattice(a, random)};
    replica.dynamics.state = replica.state;
    for (std::size_t n = 0; n < segments; ++n)
      replica.dynamics.segments.push_back(lattice_segment(a, random));
    replica.dynamics.paired = {{0, lattice_segment(a, random)}};
    replicas.push_back(replica);
  }
  return replicas;
}

MeasuredProperty coordination(const std::vector<Replica>& replicas) {
  const Mixing mixing;
  return estimate({&property("coordination-number")}, {argon(), mixing, {90, 0}, replicas});
}

}  // namespace

TEST_CASE("stored distances have the g(r) and the first peak of 'polhode analyze'") {
  const Topology topology{{{read_molecule("tip4p"), 60}, {read_molecule("na-tip4p-ew"), 5}}};
  constexpr double width = 0.004;
  const Vec3<double> edge{1.5, 1.6, 1.7};
  Distances distances = Distances::within(topology, Box{edge});
  CHECK(distances.bins() == 187);  // to half of the shortest edge
  const std::vector<SitePair> pairs = site_pairs(topology);
  RadialDistribution analyzed(topology, {pairs, width * 187, width});
  for (std::uint64_t k = 0; k < 30; ++k) {
    const State state = random_state(topology, edge, k);
    distances.add(state);
    analyzed.add(state);
  }
  // Three pairs of centres, and the pairs of sites in the order of the analysis.
  REQUIRE(distances.pairs().size() == 3 + pairs.size());
  const std::vector<double> means = distances.means();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    CHECK(distances.pairs()[3 + p] == pairs[p]);
    const std::vector<SeriesEstimate> g = analyzed.g(p);
    const std::vector<double> scale = distances.scales(3 + p);
    for (std::size_t k = 0; k < distances.bins(); ++k)
      CHECK(means[distances.index(3 + p, k)] * scale[k] ==
            doctest::Approx(g[k].value).epsilon(1e-12));
  }
  const auto value = [&](const auto& f) { return SeriesEstimate{f(means)}; };
  const auto ours = distances.first_peak(3, means, value), theirs = analyzed.first_peak(0);
  REQUIRE((ours && theirs && ours->shell.has_value() == theirs->shell.has_value()));
  CHECK(ours->position.value == doctest::Approx(theirs->position.value).epsilon(1e-12));
  CHECK(ours->height.value == doctest::Approx(theirs->height.value).epsilon(1e-12));
  // An atom is its centre of mass: sodium has the same counts as a site and as a centre.
  for (std::size_t k = 0; k < distances.bins(); ++k)
    CHECK(means[distances.index(2, k)] == means[distances.index(2 + pairs.size(), k)]);
}

// Atoms of the lattice have 12 neighbours at a/√2 and 6 at a. The rms difference of two
// displacements along a line is a/40 · √2, so the middle of both shells is 4.1 standard deviations
// away, and 2e-5 of the neighbours are beyond it. The cubic may shift the minimum by as much as one
// standard deviation, beyond which are 1e-3 of one shell.
TEST_CASE("the coordination number of a lattice in motion is 12, for replicas of different edges") {
  const std::vector<Replica> replicas = replicas_of(12);
  const MeasuredProperty m = coordination(replicas);
  REQUIRE(m.value.known == Known::yes);
  CHECK(m.obstacle.empty());
  CHECK(m.value.value == doctest::Approx(12).epsilon(1.2e-3));
  CHECK(m.value.error < 0.01);
  CHECK(m.remark.starts_with("first minimum of g(r) at 0.4"));
  REQUIRE(m.step_bound);
  CHECK(m.step_bound->pairs == 4);
  const Mixing mixing;
  const MeasuredPoint point = described({argon(), mixing, {90, 0}, replicas});
  REQUIRE(point.distributions.size() == 1);
  const MeasuredDistribution& d = point.distributions.front();
  CHECK(d.r.size() == 265);  // up to half of the edge of the smallest box, 1.06 nm
  REQUIRE(d.peak);
  CHECK(d.peak->position.value == doctest::Approx(0.5315 / std::sqrt(2)).epsilon(0.01));
}
