// SPDX-License-Identifier: MIT
// The charges on a mesh, divided into slabs: ranges of the grid along y.
#pragma once

#include <span>
#include <vector>

#include "forces/mesh/mesh_loops.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The charges of all bodies, sorted by slabs. The thickness of a slab is at least the width of a
/// spline minus one point. Charges in non-adjacent slabs therefore never touch the same grid point.
/// All even slabs are processed in parallel, and then all odd slabs. Within a slab, charges are in
/// the order of slots.
template <class T>
class MeshCharges {
 public:
  MeshCharges(const Topology& topology, const MeshSettings& settings);

  /// Charges of the sites of a molecule type [e]; empty if the type has no charges.
  const std::vector<double>& of_part(std::size_t part) const { return parts_[part]; }

  /// Places the charges on the grid and sorts them. If displacements are given, the displacement
  /// record of each charge is also computed.
  void place(const Slots& slots, const SiteRecords<T>& records, const SiteRecords<T>* displacements,
             const Box& box, Workers& workers);

  std::size_t slabs() const { return slabs_; }
  /// Indices of the charges in a slab.
  std::span<const std::uint32_t> in_slab(std::size_t slab) const;
  const T* records() const { return records_.data(); }
  const T* moves() const { return moves_.data(); }

 private:
  // The slots of a task, and the index of their first charge.
  struct Block {
    std::size_t part, first, end, charge;
  };
  void make_blocks(const Slots& slots);
  template <class Visit>
  void each_charge(const Block& block, const Visit& visit) const;

  MeshSettings settings_;
  std::vector<std::vector<double>> parts_;
  std::size_t slabs_;
  std::vector<std::uint8_t> slab_of_;  // slab of each grid point along y
  std::vector<Block> blocks_;
  std::size_t numbers_ = 0;  // number of charges, including charges of unused slots
  Column<T> records_, moves_;
  std::vector<std::int32_t> row_;    // for each charge, the grid point below it along y
  std::vector<std::uint32_t> next_;  // place in the order, by [block, slab]
  std::vector<std::uint32_t> slab_end_;
  std::vector<std::uint32_t> order_;
};

}  // namespace polhode
