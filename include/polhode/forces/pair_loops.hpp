// SPDX-License-Identifier: MIT
// The loops of a force evaluation, compiled once per instruction set.
#pragma once

#include <cstring>

#include "polhode/base/column.hpp"
#include "polhode/base/target.hpp"
#include "polhode/forces/laws.hpp"
#include "polhode/forces/neighbours.hpp"
#include "polhode/forces/pair_table.hpp"
#include "polhode/model/load.hpp"

namespace polhode {

/// Where a body and its sites are, one record a slot: three numbers for its centre in the box, then
/// x, y, z of each site relative to the centre, lab frame [nm]. Centres are in nm for double; for
/// float they are in fixed point, 2³⁰ to an edge of the box, as the bits of the number, so that
/// differences of centres are exact before they are rounded.
template <class T>
struct SiteRecords {
  std::size_t stride = 0;  ///< numbers a record; records are aligned for packs
  Column<T> values;
  /// The same layout for each image and for `nowhere`: what is added to a record.
  Column<T> shifts;

  SiteRecords() = default;
  SiteRecords(std::size_t slots, std::size_t most_sites_of_all, const Box& box)
      : stride(Column<T>::padded(3 + 3 * most_sites_of_all)),
        values(slots * stride),
        shifts((Neighbour::images + 1) * shift_stride) {
    for (std::uint32_t image = 0; image <= Neighbour::images; ++image)
      for (std::size_t d = 0; d < 3; ++d) {
        const int edges =
            image == Neighbour::nowhere ? (d == 0 ? nowhere_edges : 0) : image_edges(image)[d];
        T& shift = shifts[image * shift_stride + d];
        if constexpr (std::is_same_v<T, float>) {  // modulo 2³²
          const auto bits = static_cast<std::uint32_t>(edges * std::int64_t{fixed_point_edge});
          std::memcpy(&shift, &bits, sizeof bits);
        } else {
          shift = edges * box.edge[d];
        }
      }
  }
  T* of(std::size_t slot) { return &values[slot * stride]; }
  const T* of(std::size_t slot) const { return &values[slot * stride]; }
  const T* shift(std::uint32_t image) const { return &shifts[image * shift_stride]; }

  /// Two bodies in the box are less than an edge and a skin apart along x. Two edges more and they
  /// are farther apart than an edge less the skin, in fixed point, too, where four edges are none;
  /// that is beyond the reach of any pair.
  static constexpr int nowhere_edges = 2;
  static constexpr std::size_t shift_stride = pack_bytes / sizeof(T);
};

/// Sums of forces [kJ/mol/nm] and torques [kJ/mol] that one chunk of the list does, for the slots
/// in its windows.
struct ChunkSums {
  static constexpr std::size_t stride = 8;  ///< force, torque, and two numbers that stay 0
  Column<double> values;
  std::vector<std::size_t> first;  ///< of each part: its first record
  double lennard_jones = 0, coulomb = 0;
  Mat3<double> virial{};
  Column<double> double_scratch;  ///< of the loops
  Column<float> float_scratch;
  template <class T>
  Column<T>& scratch() {
    if constexpr (std::is_same_v<T, float>)
      return float_scratch;
    else
      return double_scratch;
  }
};

/// A chunk with the partners of one molecule type.
template <class T>
struct PairJob {
  const PairTable& table;
  const PairLaws<T>& laws;
  Truncation truncation;
  bool energies;  ///< and the virial
  const NeighbourList& list;
  const ListChunk& chunk;
  std::size_t partner_part;
  const SiteRecords<T>& records;
  ChunkSums& sums;
};

/// Bodies of one molecule type to be placed.
template <class T>
struct PlaceJob {
  const State& state;
  const Slots& slots;
  const std::vector<Vec3<double>>& sites;  ///< in the order of InteractionSites, body frame [nm]
  std::size_t first, end;                  ///< slots, multiples of slot_block
  SiteRecords<T>& records;
};

POLHODE_DECLARE_LOOPS(
    /// Fills the records of a job's slots; the square of the largest displacement since the list
    /// was built [nm²].
    double place_sites(const PlaceJob<double>& job); double place_sites(const PlaceJob<float>& job);
    /// Adds the forces, torques and, if wanted, energies and virial of a job's pairs to its sums.
    void pair_forces(const PairJob<double>& job); void pair_forces(const PairJob<float>& job);
    /// How many pairs stand in a pack.
    std::size_t pair_lanes(const PairJob<double>*); std::size_t pair_lanes(const PairJob<float>*);)

}  // namespace polhode
