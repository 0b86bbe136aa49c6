// SPDX-License-Identifier: MIT
#include "polhode/forces/overlap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

struct Contact {
  std::size_t body;
  Vec3<double> r;  // wrapped
};

using Cell = std::tuple<int, int, int>;

}  // namespace

void check_overlap(const Topology& topology, const State& state) {
  const Bodies bodies(topology);
  const Box& box = state.box;
  // Cells at least as wide as the closest contact: partners are in a cell or next to it.
  int cells[3];
  for (std::size_t d = 0; d < 3; ++d)
    cells[d] = std::max(1, static_cast<int>(box.edge[d] / (2 * closest_contact)));
  const auto cell_of = [&](const Vec3<double>& r, std::size_t d) {
    return std::min(static_cast<int>(r[d] / box.edge[d] * cells[d]), cells[d] - 1);
  };
  std::map<Cell, std::vector<Contact>> grid;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (const Site& site : topology.parts[bodies.part[i]].molecule.sites) {
      if (site.mass == 0 && site.epsilon == 0) continue;
      Vec3<double> r = state.q[i] + to_lab(state.attitude[i], site.r);
      if (!std::isfinite(norm2(r)))
        throw Error(
            fmt::format("molecule {} has a position that is not finite; mend the start", i + 1));
      for (std::size_t d = 0; d < 3; ++d) r[d] -= std::floor(r[d] / box.edge[d]) * box.edge[d];
      const auto wrapped = [&](int c, std::size_t d) { return (c + cells[d]) % cells[d]; };
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dz = -1; dz <= 1; ++dz) {
            const auto near =
                grid.find({wrapped(cell_of(r, 0) + dx, 0), wrapped(cell_of(r, 1) + dy, 1),
                           wrapped(cell_of(r, 2) + dz, 2)});
            if (near == grid.end()) continue;
            for (const Contact& other : near->second) {
              const double distance = norm(box.minimum_image(other.r - r));
              if (other.body != i && distance < closest_contact)
                throw Error(fmt::format(
                    "molecules {} and {} overlap: two of their sites are {:.4f} nm apart, closer "
                    "than "
                    "{:.3f} nm, half of a hydrogen bond; take a lower density or another start",
                    other.body + 1, i + 1, distance, closest_contact));
            }
          }
      grid[{cell_of(r, 0), cell_of(r, 1), cell_of(r, 2)}].push_back({i, r});
    }
}

}  // namespace polhode
