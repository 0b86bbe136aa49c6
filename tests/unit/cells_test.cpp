// SPDX-License-Identifier: MIT
// Cells and the order of bodies by cells.
#include "polhode/forces/pairs/cells.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "scenes.hpp"

using namespace polhode;

TEST_CASE("cells fill the box and are about half as wide as the range") {
  for (const Vec3<double> edge : {Vec3<double>{3, 3, 3}, {0.9, 7.3, 2.2}, {1, 1, 5000}}) {
    const CellGrid grid(Box{edge}, 1.0);
    for (std::size_t d = 0; d < 3; ++d) {
      CHECK(grid.cells[d] >= 1);
      CHECK(grid.cells[d] <= 1024);
      CHECK(grid.width(d) * double(grid.cells[d]) == doctest::Approx(edge[d]).epsilon(1e-15));
      CHECK(grid.width(d) >= std::min(0.5, edge[d]));
      if (grid.cells[d] > 1 && grid.cells[d] < 1024) CHECK(grid.width(d) < 1);
      CHECK(grid.coordinate(0, d) == 0);
      CHECK(grid.coordinate(-1e-18, d) == 0);
      CHECK(grid.coordinate(edge[d], d) == grid.cells[d] - 1);  // x mod edge may round to edge
      for (std::size_t c = 0; c < grid.cells[d]; ++c)
        CHECK(grid.coordinate((double(c) + 0.5) * grid.width(d), d) == c);
    }
    CHECK(grid.index(grid.cells[0] - 1, grid.cells[1] - 1, grid.cells[2] - 1) == grid.size() - 1);
    if (grid.cells[0] > 1) CHECK(grid.index(1, 0, 0) == 1);
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
  const CellGrid grid(scene.state.box, 0.8);
  for (const int threads : {1, 3}) {
    Workers workers(threads);
    Slots slots(topology);
    CHECK(slots.size() == 192 + 64 + 64);
    for (int again = 0; again < 2; ++again) slots.sort(scene.state, grid, workers);
    std::vector<int> seen(scene.state.size(), 0);
    for (std::size_t p = 0; p < slots.parts.size(); ++p) {
      const Slots::Part& part = slots.parts[p];
      CHECK(part.first % slot_block == 0);
      CHECK(part.count == topology.parts[p].count);
      for (std::size_t c = 0; c < grid.size(); ++c)
        for (std::uint32_t s = slots.cell_begin(grid, p, c);
             s < slots.cell_end[p * grid.size() + c]; ++s) {
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
          CHECK(c == grid.index(grid.coordinate(place.x, 0), grid.coordinate(place.y, 1),
                                grid.coordinate(place.z, 2)));
        }
      CHECK(slots.cell_end[(p + 1) * grid.size() - 1] == part.end());
      const std::uint32_t next =
          p + 1 < slots.parts.size() ? slots.parts[p + 1].first : std::uint32_t(slots.size());
      for (std::uint32_t s = part.end(); s < next; ++s)  // left over: a body of the type
        CHECK(scene.bodies.part[slots.body[s]] == p);
    }
    CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
    scene.state.q.set(7, {NAN, 0, 0});
    CHECK_THROWS_AS(slots.sort(scene.state, grid, workers), RunError);
    scene.state.q.set(7, {0, 0, 0});
  }
}
