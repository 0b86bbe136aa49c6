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
  if (settings.truncation != Truncation::molecule_switch && settings.cutoff + 2 * reach > shortest)
    throw Error(
        fmt::format("cutoff {:.3f} nm and the largest molecule ({:.3f} nm from its centre to a "
                    "site) do not fit "
                    "the shortest box edge ({:.3f} nm): a molecule would meet its own image; take "
                    "a larger box or "
                    "a cutoff of at most {:.3f} nm",
                    settings.cutoff, reach, shortest, floored(shortest - 2 * reach)));
}

// Work is cut by the number of bodies alone, so that sums do not depend on the number of threads:
// pieces large enough that a piece's own rows outweigh those of its neighbours that it touches.
std::vector<ListChunk> chunks_of(const Slots& slots) {
  std::vector<ListChunk> chunks;
  const std::size_t all = slots.size();
  const std::size_t wanted = all < 1000 ? 8 : all < 100000 ? 16 : 64;
  const std::size_t blocks = std::max<std::size_t>(1, all / slot_block / wanted);
  for (std::uint32_t part = 0; part < slots.parts.size(); ++part) {
    const Slots::Part& p = slots.parts[part];
    for (std::uint32_t s = p.first; s < p.end();) {
      const auto end =
          std::min<std::uint32_t>(s + static_cast<std::uint32_t>(blocks * slot_block), p.end());
      ListChunk chunk;
      chunk.part = part, chunk.first = s, chunk.end = end;
      chunks.push_back(std::move(chunk));
      s = end;
    }
  }
  return chunks;
}

}  // namespace

NeighbourList::NeighbourList(const Topology& topology, const ForceSettings& settings,
                             const Box& box)
    : box_(box), slots_(topology), chunks_(chunks_of(slots_)) {
  check_box(topology, settings, box);
  if (slots_.size() > Neighbour::slot_mask)
    throw Error(
        fmt::format("{} molecules are more than the neighbour list can number ({}); run a "
                    "smaller system",
                    topology.size(), Neighbour::slot_mask));
  // Centres are at most cutoff + reach_a + reach_b apart when two sites are within the cutoff, and
  // at least that much closer when all of them are within the switch.
  const bool by_site = settings.truncation != Truncation::molecule_switch;
  const double from = settings.truncation == Truncation::site_shift ? 0.0 : settings.switch_from;
  double longest = 0;
  const auto reach = [&](const auto& a, const auto& b) {
    return by_site ? a.molecule.reach() + b.molecule.reach() : 0.0;
  };
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) longest = std::max(longest, settings.cutoff + reach(a, b));
  // One image in each direction is enough while the range is within the shortest edge.
  const double skin = std::min(settings.skin, box.shortest_edge() - longest);
  if (skin <= 0)
    throw Error(
        fmt::format("cutoff {:.3f} nm and the size of the molecules fill the shortest box "
                    "edge ({:.3f} nm); take a larger box or a shorter cutoff",
                    settings.cutoff, box.shortest_edge()));
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) {
      const double listed = settings.cutoff + reach(a, b) + skin;
      const double whole = std::max(0.0, from - reach(a, b) - skin);
      ranges_.push_back({listed * listed, whole * whole});
    }
  range_ = longest + skin;
  allowed2_ = skin * skin / 4;
  grid_ = CellGrid(box, range_);
}

std::size_t NeighbourList::lanes() const {
  std::size_t n = 0;
  for (const ListChunk& chunk : chunks_) n += chunk.entries.size();
  return n;
}

void NeighbourList::build(const State& state, std::size_t width) {
  const auto begin = std::chrono::steady_clock::now();
  slots_.sort(state, grid_);
  std::vector<std::int32_t> fixed[3];
  const Column<double>* const place[3] = {&slots_.place.x, &slots_.place.y, &slots_.place.z};
  for (std::size_t d = 0; d < 3; ++d) {
    fixed[d].resize(slots_.size() + slot_block);
    const double scale = static_cast<double>(fixed_point_edge) / box_.edge[d];
    for (std::size_t s = 0; s < slots_.size(); ++s)
      fixed[d][s] = static_cast<std::int32_t>((*place[d])[s] * scale);
  }
  const ListJob job{grid_, slots_, ranges_, fixed, width};
  for (ListChunk& chunk : chunks_) POLHODE_CURRENT_LOOPS(find_partners)(job, chunk);
  width_ = width;
  ++rebuilds_;
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace polhode
