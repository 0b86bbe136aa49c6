// SPDX-License-Identifier: MIT
#include "forces/pairs/neighbours.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stopwatch.hpp"
#include "forces/pairs/centre_ranges.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

void check_box(const Topology& topology, const ForceSettings& settings, const Box& box) {
  const double shortest = box.shortest_edge();
  const auto round_down = [](double x) { return std::floor(x * 1000) / 1000; };
  const double cutoff = std::max(settings.cutoff, cutoff_of_charges(settings));
  if (cutoff > shortest / 2)
    throw Error(fmt::format(
        "{} {:.3f} nm is longer than half of the shortest box edge ({:.3f} nm), so a molecule "
        "would interact with two images of another molecule; the maximum cutoff is {:.3f} nm",
        cutoff > settings.cutoff ? "coulomb_cutoff" : "cutoff", cutoff, shortest,
        round_down(shortest / 2)));
  const double extent = topology.extent();
  if (settings.truncation != Truncation::molecule_switch && cutoff + 2 * extent > shortest)
    throw Error(
        fmt::format("cutoff {:.3f} nm and the largest molecule ({:.3f} nm from its centre to a "
                    "site) do not fit into the shortest box edge ({:.3f} nm); use a larger box or "
                    "a cutoff of at most {:.3f} nm",
                    cutoff, extent, shortest, round_down(shortest - 2 * extent)));
}

// The division into chunks depends only on the number of bodies, so that sums do not depend on the
// number of threads. A chunk is so large that it has more rows than slots in other chunks that
// receive its forces.
std::vector<ListChunk> chunks_of(const Slots& slots, std::size_t parts) {
  std::vector<ListChunk> chunks;
  const std::size_t all = slots.size();
  const std::size_t min_chunks = all < 1000 ? 8 : all < 400000 ? 16 : 32;
  const std::size_t blocks = std::max<std::size_t>(1, all / slot_block / min_chunks);
  for (std::uint32_t part = 0; part < parts; ++part) {
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

void check_count(const Topology& topology) {
  double molecules = 0, slots = 0;
  for (const auto& part : topology.parts) {
    const auto count = static_cast<double>(part.count);
    molecules += count;
    slots += std::ceil(count / slot_block) * slot_block;
  }
  if (slots > Neighbour::slot_mask)
    throw Error(fmt::format(
        "{:.0f} molecules are more than the neighbour list can index ({}); use fewer molecules",
        molecules, Neighbour::slot_mask));
}

void check_edges(const Box& box) {
  // Fixed-point positions have errors of up to 2⁻³⁰ of an edge. The search for partners allows for
  // a round-off of 1e-5 nm.
  constexpr double max_range = 8192;  // [nm]
  for (std::size_t d = 0; d < 3; ++d)
    if (!(box.edge[d] <= max_range))
      throw Error(
          fmt::format("a box edge is {:g} nm long; it must be at most {:g} nm, since the "
                      "resolution of positions is 2^-30 of an edge",
                      box.edge[d], max_range));
}

NeighbourList::NeighbourList(const Topology& topology, const ForceSettings& settings,
                             const Box& box, std::size_t ghost_parts)
    : own_parts_(topology.parts.size() - ghost_parts),
      slots_((check_count(topology), topology)),
      tree_(slots_),
      chunks_(chunks_of(slots_, own_parts_)) {
  set_box(topology, settings, box);
}

void NeighbourList::set_box(const Topology& topology, const ForceSettings& settings,
                            const Box& box) {
  check_edges(box);
  check_box(topology, settings, box);
  std::vector<CentreRanges> ranges;
  double max_range = 0;
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) {
      ranges.push_back(centre_ranges(settings, a.molecule, b.molecule));
      max_range = std::max(max_range, ranges.back().largest);
    }
  // One periodic image in each direction is enough, provided that the range does not exceed the
  // shortest edge.
  const double skin = std::min(settings.skin, box.shortest_edge() - max_range);
  if (skin <= 0)
    throw Error(
        fmt::format("the cutoff of {:.3f} nm and the size of the molecules fill the shortest box "
                    "edge ({:.3f} nm); use a larger box or a shorter cutoff",
                    std::max(settings.cutoff, cutoff_of_charges(settings)), box.shortest_edge()));
  ranges_.clear();
  for (const CentreRanges& range : ranges) {
    const double listed = range.largest + skin, inside = std::max(0.0, range.inside - skin);
    ranges_.push_back({listed * listed, inside * inside});
  }
  allowed2_ = skin * skin / 4;
  box_ = box;
  width_ = 0;
  reserve_rows();
}

/// Reserves memory for the rows of a system with uniform density, so that rows need not grow.
void NeighbourList::reserve_rows() {
  for (ListChunk& chunk : chunks_) {
    double row = 0;
    for (std::size_t b = chunk.part; b < slots_.parts.size(); ++b) {
      const double listed = std::sqrt(ranges_[chunk.part * slots_.parts.size() + b].listed2);
      const double sphere = 4 * std::numbers::pi / 3 * listed * listed * listed;
      row += slots_.parts[b].count * sphere / box_.volume() * (b == chunk.part ? 0.5 : 1.0);
    }
    chunk.entries.reserve(static_cast<std::size_t>(1.05 * row * (chunk.end - chunk.first)));
  }
}

std::size_t NeighbourList::lanes() const {
  std::size_t n = 0;
  for (const ListChunk& chunk : chunks_) n += chunk.entries.size();
  return n;
}

void NeighbourList::build(const State& state, std::size_t width, Workers& workers) {
  const Stopwatch watch;
  slots_.sort(state, workers);
  tree_.update(slots_, box_, workers);
  const ListJob job{box_, slots_, tree_, ranges_, own_parts_, width};
  const auto find = POLHODE_CURRENT_LOOPS(find_partners);
  workers.each(chunks_.size(), [&](std::size_t c) { find(job, chunks_[c]); });
  width_ = width;
  ++rebuilds_;
  seconds_ += watch.seconds();
}

}  // namespace polhode
