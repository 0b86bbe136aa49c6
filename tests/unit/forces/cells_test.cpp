// SPDX-License-Identifier: MIT
// Cells and the order of bodies by cells.
#include "forces/pairs/cells.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "scenes.hpp"

using namespace polhode;

// Blocks of 16 bodies are as long as they are wide, within the rounding of the number of columns
// and layers; cells are slices of these blocks, about as many as half the bodies.
TEST_CASE("cells fill the box, and their number is bounded by that of the bodies") {
  for (const Vec3<double> edge : {Vec3<double>{3, 3, 3}, {0.9, 7.3, 2.2}, {1, 1, 5000}})
    for (const std::size_t bodies : {0u, 1u, 16u, 1000u, 100000u}) {
      const CellGrid grid(Box{edge}, bodies);
      const double block = std::cbrt(16 * edge.x * edge.y * edge.z / std::max(1.0, double(bodies)));
      double bound = 1;
      for (std::size_t d = 0; d < 3; ++d) {
        const double slices = d == 2 ? 8 : 1;
        CHECK(grid.cells[d] >= 1);
        CHECK(grid.width(d) * double(grid.cells[d]) == doctest::Approx(edge[d]).epsilon(1e-15));
        CHECK(std::abs(double(grid.cells[d]) - slices * edge[d] / block) <= 1);
        CHECK(grid.coordinate(0, d) == 0);
        CHECK(grid.coordinate(-1e-18, d) == 0);
        CHECK(grid.coordinate(edge[d], d) == grid.cells[d] - 1);  // x mod edge may round to edge
        for (std::size_t c = 0; c < grid.cells[d]; ++c)
          CHECK(grid.coordinate((double(c) + 0.5) * grid.width(d), d) == c);
        bound *= slices * edge[d] / block + 1;
      }
      CHECK(double(grid.size()) <= bound);
    }
}

TEST_CASE("consecutive cells share a face, and each cell has one number") {
  const CellGrid grid(Box{{3, 2.2, 4}}, 900);
  std::vector<std::array<std::size_t, 3>> cells(grid.size());
  std::vector<int> seen(grid.size(), 0);
  for (std::size_t z = 0; z < grid.cells[2]; ++z)
    for (std::size_t y = 0; y < grid.cells[1]; ++y)
      for (std::size_t x = 0; x < grid.cells[0]; ++x) {
        REQUIRE(grid.index(x, y, z) < grid.size());
        ++seen[grid.index(x, y, z)];
        cells[grid.index(x, y, z)] = {x, y, z};
      }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  for (std::size_t k = 1; k < grid.size(); ++k) {
    std::size_t steps = 0;
    for (std::size_t d = 0; d < 3; ++d)
      steps += std::max(cells[k][d], cells[k - 1][d]) - std::min(cells[k][d], cells[k - 1][d]);
    CHECK(steps == 1);
  }
}

TEST_CASE("slots are a permutation of the bodies of each type, ordered by cells") {
  Topology topology;
  topology.parts.push_back({read_molecule("tip4p"), 130});
  topology.parts.push_back({read_molecule("argon"), 64});
  topology.parts.push_back({read_molecule("co2"), 1});
  scenes::Scene scene = scenes::spread(topology, {2, 3, 1.5}, 4);
  for (std::size_t i = 0; i < scene.state.size(); i += 2)  // outside by several edges
    scene.state.q.add(i, {-6, 9, 150});
  scene.state.q.set(5, {-1e-18, 0, 3 - 1e-18});  // rounds to an edge of the box
  for (const int threads : {1, 3}) {
    Workers workers(threads);
    Slots slots(topology);
    CHECK(slots.size() == 192 + 64 + 64);
    for (int again = 0; again < 2; ++again) slots.sort(scene.state, workers);
    std::vector<int> seen(scene.state.size(), 0);
    for (std::size_t p = 0; p < slots.parts.size(); ++p) {
      const Slots::Part& part = slots.parts[p];
      CHECK(part.first % slot_block == 0);
      CHECK(part.count == topology.parts[p].count);
      const CellGrid grid(scene.state.box, part.count);
      std::size_t last = 0;
      for (std::uint32_t s = part.first; s < part.end(); ++s) {
        const std::uint32_t body = slots.body[s];
        ++seen[body];
        CHECK(scene.bodies.part[body] == p);
        CHECK(slots.built_at[s] == scene.state.q[body]);
        const Vec3<double> place = slots.place[s];
        for (std::size_t d = 0; d < 3; ++d) {
          CHECK(place[d] >= 0);
          CHECK(place[d] <= grid.edge[d]);
          const double edges = (scene.state.q[body][d] - place[d]) / grid.edge[d];
          CHECK(std::abs(edges - std::round(edges)) < 1e-12);  // roundings of about 100 edges
        }
        const std::size_t cell = grid.index(
            grid.coordinate(place.x, 0), grid.coordinate(place.y, 1), grid.coordinate(place.z, 2));
        CHECK(cell >= last);
        last = cell;
      }
      const std::uint32_t next =
          p + 1 < slots.parts.size() ? slots.parts[p + 1].first : std::uint32_t(slots.size());
      for (std::uint32_t s = part.end(); s < next; ++s)  // left over: a body of the type
        CHECK(scene.bodies.part[slots.body[s]] == p);
    }
    CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
    scene.state.q.set(7, {NAN, 0, 0});
    CHECK_THROWS_AS(slots.sort(scene.state, workers), RunError);
    scene.state.q.set(7, {0, 0, 0});
  }
}
