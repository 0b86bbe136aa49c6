// SPDX-License-Identifier: MIT
#include "polhode/forces/neighbours.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// A grid of cells at least `range` wide. Cells are reached from a cell by steps of −1, 0, 1 in each
// direction; a step that leaves the box enters the image next to it, so that a grid of one or two
// cells lists every (cell, image) once, too.
struct Grid {
  std::array<std::size_t, 3> cells;

  Grid(const Box& box, double range) {
    for (std::size_t d = 0; d < 3; ++d)
      cells[d] = std::clamp<std::size_t>(static_cast<std::size_t>(box.edge[d] / range), 1, 512);
  }
  std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
  std::size_t coordinate(double x, double edge, std::size_t d) const {
    const auto c = static_cast<std::size_t>(x / edge * static_cast<double>(cells[d]));
    return std::min(c, cells[d] - 1);
  }
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * cells[1] + y) * cells[0] + x;
  }

  struct Step {
    std::size_t coordinate;
    std::uint32_t image;  // 0: below the box, 1: inside, 2: above
  };
  Step step(std::size_t from, int by, std::size_t d) const {
    if (by < 0) return from == 0 ? Step{cells[d] - 1, 0} : Step{from - 1, 1};
    if (by > 0) return from + 1 == cells[d] ? Step{0, 2} : Step{from + 1, 1};
    return {from, 1};
  }
};

void check_box(const Topology& topology, const ForceSettings& settings, const Box& box) {
  const double shortest = box.shortest_edge();
  const auto floored = [](double x) { return std::floor(x * 1000) / 1000; };
  if (settings.cutoff > shortest / 2)
    throw Error(
        fmt::format("cutoff {:.3f} nm is longer than half of the shortest box edge ({:.3f} nm): a "
                    "molecule would "
                    "meet two images of one partner; the longest cutoff for this box is {:.3f} nm",
                    settings.cutoff, shortest, floored(shortest / 2)));
  double reach = 0;
  for (const auto& part : topology.parts) reach = std::max(reach, part.molecule.reach());
  if (settings.truncation == Truncation::reaction_field && settings.cutoff + 2 * reach > shortest)
    throw Error(
        fmt::format("cutoff {:.3f} nm and the largest molecule ({:.3f} nm from its centre to a "
                    "site) do not fit "
                    "the shortest box edge ({:.3f} nm): a molecule would meet its own image; take "
                    "a larger box or "
                    "a cutoff of at most {:.3f} nm",
                    settings.cutoff, reach, shortest, floored(shortest - 2 * reach)));
}

}  // namespace

std::vector<Vec3<double>> image_shifts(const Box& box) {
  std::vector<Vec3<double>> shifts;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        shifts.push_back(scaled(box.edge, Vec3<double>{double(x), double(y), double(z)}));
  return shifts;
}

NeighbourList::NeighbourList(const Topology& topology, const ForceSettings& settings,
                             const Box& box)
    : box_(box), parts_(topology.parts.size()), part_(Bodies(topology).part) {
  check_box(topology, settings, box);
  if (topology.size() > Neighbour::index_mask)
    throw Error(
        fmt::format("{} molecules are more than the neighbour list can number ({}); run a "
                    "smaller system",
                    topology.size(), Neighbour::index_mask));
  // Centres are at most cutoff + reach_a + reach_b apart when two sites are within the cutoff.
  const bool by_site = settings.truncation == Truncation::reaction_field;
  double longest = 0;
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) {
      const double reach = by_site ? a.molecule.reach() + b.molecule.reach() : 0.0;
      reach_.push_back(settings.cutoff + reach);
      longest = std::max(longest, reach_.back());
    }
  // One image in each direction is enough while the range is within the shortest edge.
  const double skin = std::min(settings.skin, box.shortest_edge() - longest);
  if (skin <= 0)
    throw Error(
        fmt::format("cutoff {:.3f} nm and the size of the molecules fill the shortest box "
                    "edge ({:.3f} nm); take a larger box or a shorter cutoff",
                    settings.cutoff, box.shortest_edge()));
  for (const double reach : reach_) range2_.push_back((reach + skin) * (reach + skin));
  range_ = longest + skin;
  allowed2_ = skin * skin / 4;
  const std::size_t n = topology.size();
  built_at_ = home_ = wrapped_ = Vec3Column(n);
  begin_.assign(n * parts_ + 1, 0);
}

void NeighbourList::update(const State& state) {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t n = state.size();
  double moved2 = rebuilds_ == 0 ? 2 * allowed2_ : 0;
  for (std::size_t i = 0; i < n; ++i) {
    wrapped_.x[i] = state.q.x[i] - home_.x[i];
    wrapped_.y[i] = state.q.y[i] - home_.y[i];
    wrapped_.z[i] = state.q.z[i] - home_.z[i];
    const double dx = state.q.x[i] - built_at_.x[i];
    const double dy = state.q.y[i] - built_at_.y[i];
    const double dz = state.q.z[i] - built_at_.z[i];
    const double d2 = dx * dx + dy * dy + dz * dz;
    moved2 = d2 > moved2 ? d2 : moved2;
  }
  if (!(moved2 < allowed2_)) build(state);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void NeighbourList::build(const State& state) {
  const std::size_t n = state.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(norm2(state.q[i])))
      throw RunError(fmt::format("the position of molecule {} is not finite", i + 1));
  ++rebuilds_;
  const Grid grid(box_, range_);
  built_at_ = state.q;
  cell_of_.resize(n);
  in_cell_.resize(n);
  cell_begin_.assign(grid.size() + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3<double> home;
    std::size_t c[3];
    for (std::size_t d = 0; d < 3; ++d) {
      const double edge = box_.edge[d];
      home[d] = std::floor(state.q[i][d] / edge) * edge;
      c[d] = grid.coordinate(std::max(state.q[i][d] - home[d], 0.0), edge, d);
    }
    home_.set(i, home);
    wrapped_.set(i, state.q[i] - home);
    cell_of_[i] = static_cast<std::uint32_t>(grid.index(c[0], c[1], c[2]));
    ++cell_begin_[cell_of_[i] + 1];
  }
  for (std::size_t c = 0; c < grid.size(); ++c) cell_begin_[c + 1] += cell_begin_[c];
  std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::size_t i = 0; i < n; ++i) in_cell_[next[cell_of_[i]]++] = static_cast<std::uint32_t>(i);

  const std::vector<Vec3<double>> shifts = image_shifts(box_);
  entries_.clear();
  std::vector<std::vector<Neighbour>> found(parts_);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t here = cell_of_[i];
    const std::size_t cx = here % grid.cells[0], cy = here / grid.cells[0] % grid.cells[1],
                      cz = here / (grid.cells[0] * grid.cells[1]);
    const Vec3<double> q = wrapped_[i];
    for (auto& list : found) list.clear();
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Grid::Step x = grid.step(cx, dx, 0), y = grid.step(cy, dy, 1),
                           z = grid.step(cz, dz, 2);
          const std::uint32_t image = (z.image * 3 + y.image) * 3 + x.image;
          const std::size_t cell = grid.index(x.coordinate, y.coordinate, z.coordinate);
          const Vec3<double> offset = shifts[image] - q;
          for (std::size_t k = cell_begin_[cell]; k < cell_begin_[cell + 1]; ++k) {
            const std::uint32_t j = in_cell_[k];
            if (j <= i) continue;
            if (norm2(wrapped_[j] + offset) < range2_[part_[i] * parts_ + part_[j]])
              found[part_[j]].emplace_back(j, image);
          }
        }
    for (std::size_t part = 0; part < parts_; ++part) {
      longest_row_ = std::max(longest_row_, found[part].size());
      begin_[i * parts_ + part] = entries_.size();
      entries_.insert(entries_.end(), found[part].begin(), found[part].end());
    }
  }
  begin_[n * parts_] = entries_.size();
}

}  // namespace polhode
