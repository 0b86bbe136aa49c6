// SPDX-License-Identifier: MIT
#include "forces/mesh/mesh_charges.hpp"

#include <algorithm>
#include <utility>

#include "base/blocks.hpp"
#include "forces/pairs/pair_table.hpp"

namespace polhode {
namespace {

/// The number of slabs. Slabs are at least order − 1 points thick, and consist of whole tiles,
/// whatever the tile shape. The number of slabs is even, so that even and odd slabs also alternate
/// across the periodic boundary. If possible, the number of slabs is a multiple of four, so that a
/// few threads share the slabs evenly.
std::size_t number_of_slabs(const MeshSettings& settings) {
  constexpr std::size_t max_slabs = 64;
  const std::size_t tiles = settings.points[1] / mesh_multiple,
                    thickness = blocks(static_cast<std::size_t>(settings.order - 1), mesh_multiple),
                    thin = std::min(tiles / thickness, max_slabs);
  return thin < 2 ? 1 : thin < 4 ? 2 : thin / 4 * 4;
}

}  // namespace

template <class T>
MeshCharges<T>::MeshCharges(const Topology& topology, const MeshSettings& settings)
    : settings_(settings), slabs_(number_of_slabs(settings)), slab_end_(slabs_) {
  for (const auto& part : topology.parts) {
    const InteractionSites sites(part.molecule);
    parts_.emplace_back();
    for (std::size_t k = 0; k < sites.charged; ++k) parts_.back().push_back(sites.sites[k].charge);
  }
  const std::size_t tiles = settings.points[1] / mesh_multiple;
  for (std::size_t y = 0; y < settings.points[1]; ++y)
    slab_of_.push_back(static_cast<std::uint8_t>(y / mesh_multiple * slabs_ / tiles));
}

template <class T>
void MeshCharges<T>::make_blocks(const Slots& slots) {
  std::size_t charges = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p].empty()) continue;
    const Slots::Part& part = slots.parts[p];
    for (std::size_t first = part.first; first < part.end(); first += slots_at_once) {
      const std::size_t end = std::min<std::size_t>(part.end(), first + slots_at_once);
      blocks_.push_back({p, first, end, numbers_});
      numbers_ += (end - first + slot_block - 1) / slot_block * slot_block * parts_[p].size();
      charges += (end - first) * parts_[p].size();
    }
  }
  records_ = Column<T>(numbers_ * ChargeRecord::stride);
  row_.resize(numbers_);
  next_.resize(blocks_.size() * slabs_);
  order_.resize(charges);
}

/// Calls visit(index) for each charge of a block.
template <class T>
template <class Visit>
void MeshCharges<T>::each_charge(const Block& block, const Visit& visit) const {
  std::size_t number = block.charge;
  for (std::size_t first = block.first; first < block.end; first += slot_block)
    for (std::size_t site = 0; site < parts_[block.part].size(); ++site, number += slot_block)
      for (std::size_t k = 0; k < std::min(slot_block, block.end - first); ++k) visit(number + k);
}

template <class T>
void MeshCharges<T>::place(const Slots& slots, const SiteRecords<T>& records,
                           const SiteRecords<T>* displacements, const Box& box, Workers& workers) {
  if (blocks_.empty()) make_blocks(slots);
  if (displacements && moves_.size() == 0) moves_ = records_;
  const auto place_charges =
      POLHODE_CURRENT_OVERLOAD(place_charges, void (*)(const PlaceChargesJob<T>&));
  workers.each(blocks_.size(), [&](std::size_t b) {
    const Block& block = blocks_[b];
    place_charges({box,
                   records,
                   {parts_[block.part], block.first, block.end},
                   settings_.points,
                   &records_[block.charge * ChargeRecord::stride],
                   &row_[block.charge],
                   displacements,
                   displacements ? &moves_[block.charge * ChargeRecord::stride] : nullptr});
    std::uint32_t* const count = &next_[b * slabs_];
    std::fill_n(count, slabs_, 0);
    each_charge(block,
                [&](std::size_t n) { ++count[slab_of_[static_cast<std::size_t>(row_[n])]]; });
  });
  std::uint32_t at = 0;
  for (std::size_t slab = 0; slab < slabs_; ++slab) {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::uint32_t count = std::exchange(next_[b * slabs_ + slab], at);
      at += count;
    }
    slab_end_[slab] = at;
  }
  workers.each(blocks_.size(), [&](std::size_t b) {
    std::uint32_t* const next = &next_[b * slabs_];
    each_charge(blocks_[b], [&](std::size_t n) {
      order_[next[slab_of_[static_cast<std::size_t>(row_[n])]]++] = static_cast<std::uint32_t>(n);
    });
  });
}

template <class T>
std::span<const std::uint32_t> MeshCharges<T>::in_slab(std::size_t slab) const {
  const std::size_t first = slab == 0 ? 0 : slab_end_[slab - 1];
  return {&order_[first], slab_end_[slab] - first};
}

template class MeshCharges<double>;
template class MeshCharges<float>;

}  // namespace polhode
