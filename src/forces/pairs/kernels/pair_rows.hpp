// SPDX-License-Identifier: MIT
// The pair loops: a molecule interacts with several partners at once, one per lane. The partners'
// records are transposed into packs. The forces on the partners are transposed back and added one
// by one.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "base/pack_functions.hpp"
#include "base/pack_integers.hpp"
#include "forces/pairs/molecule_pair.hpp"
#include "forces/pairs/pair_loops.hpp"
#include "math/dual.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The difference of one coordinate of two centres [nm], computed from their records.
inline Pack<double> coordinate_difference(Pack<double> partner, double own, double) {
  return partner - Pack<double>(own);
}
inline Pack<float> coordinate_difference(Pack<float> partner, float own, float unit) {
  std::int32_t bits;
  std::memcpy(&bits, &own, sizeof bits);
  return fixed_point_difference(partner, bits) * Pack<float>(unit);
}

// Coordinate d of the centres of partners, shifted to the periodic images given by the list
// entries.
inline Pack<double> in_image(Pack<double> c, PackIndex<double> words, std::size_t d, double edge) {
  return c + as_doubles((words << 2 * d) >> 30) * Pack<double>(edge);
}
inline Pack<float> in_image(Pack<float> c, PackIndex<float> words, std::size_t d, double) {
  static_assert(fixed_point_edge == 1 << 30);  // the two highest bits count box edges
  return fixed_point_sum(c, (words << 2 * d) & Neighbour::top_bits);
}

// Processes the rows of a chunk pack by pack, as a software pipeline. While the pairs of a pack are
// computed, the processor also transposes the partner records of the next pack, and adds up the
// results of the previous pack. Transposing and adding mostly move data, whereas pairs need mostly
// arithmetic, so the stages overlap well. Each stage is a separate function. If a stage were
// inlined into the pair loop, the stage would be compiled again for each potential and kind of
// result. Inlining would greatly increase the compile time, without making the loops faster.
//
// If Number is a dual number, the records of displacements are read as well, and the derivatives of
// forces and torques are added up.
template <class Number, class Shape, class Law>
class PairRows {
 public:
  using Real = Constant<Number>;
  using T = typename Real::value_type;
  static constexpr bool slopes = is_dual<Number>;

  PairRows(const PairJob<T>& job, const PairStrengths<Law>& strengths)
      : job_(job),
        shape_(job.table),
        strengths_(strengths),
        own_(window(job.chunk.part)),
        partner_(window(job.partner_part)),
        ghosts_(ghost_window()),
        numbers_((2 + 3 * shape_.sites_b + Real::width) / Real::width * Real::width),
        edge_(job.list.box().edge),
        far_apart_(job.list.slots().size() > 8192 && job.list.slots().parts.size() == 1) {
    for (std::size_t d = 0; d < 3; ++d)
      unit_[d] = static_cast<T>(edge_[d] / static_cast<double>(fixed_point_edge));
  }

  // With dual numbers, functions are too long to be inlined by default.
  template <CutoffTreatment treatment>
  [[gnu::flatten]] void run_with_slopes() {
    run<treatment, false>();
  }

  template <CutoffTreatment treatment, bool energies>
  void run() {
    std::uint32_t slot = with_partners(job_.chunk.first);
    if (slot == job_.chunk.end) return;
    const std::uint32_t* const entries = job_.chunk.entries.data();
    std::size_t pack = 0;  // counted from the start of the chunk
    fetch(entries + row(slot).begin, pack);
    while (slot < job_.chunk.end) {
      const ListChunk::Row here = row(slot);
      const std::uint32_t following = with_partners(slot + 1);
      const std::uint32_t* const end = entries + here.end;
      const std::uint32_t* const after =  // after the last pack, any partners may be loaded
          entries + (following < job_.chunk.end ? row(following).begin : here.begin);
      RowSums sums;
      const auto each_pack = [&]<CutoffTreatment how>(std::uint32_t from,
                                                      std::uint32_t to) POLHODE_INLINE_LAMBDA {
        for (const std::uint32_t* entry = entries + from; entry != entries + to; ++pack) {
          entry += Real::width;
          fetch(entry == end ? after : entry, pack + 1);
          compute<how, energies>(slot, pack, sums);
          add_up(pack - 1);
        }
      };
      if constexpr (!changes_all_distances(treatment))
        each_pack.template operator()<without_truncation(treatment)>(here.begin, here.truncated);
      each_pack.template operator()<treatment>(here.truncated, here.end);
      add_row<energies>(slot, sums);
      slot = following;
    }
    add_up(pack - 1);
    if constexpr (energies) {
      job_.sums.van_der_waals += sum(van_der_waals_);
      job_.sums.coulomb += sum(coulomb_);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) job_.sums.virial[i][k] += sum(virial_[i][k]);
    }
  }

 private:
  ListChunk::Row row(std::uint32_t slot) const {
    return job_.chunk.row(slot, job_.partner_part, job_.list.slots().parts.size());
  }
  // The first slot at or after `slot` that has partners, or the end of the chunk if no such slot is
  // left.
  std::uint32_t with_partners(std::uint32_t slot) const {
    while (slot < job_.chunk.end && row(slot).begin == row(slot).end) ++slot;
    return slot;
  }

  // Data of one pack that the pipeline stages exchange through memory; two packs are in progress at
  // a time.
  struct Stage {
    static constexpr std::size_t numbers = (3 + 3 * Shape::max_b + Real::width) * Real::width;
    alignas(pack_bytes) T partners[numbers];
    alignas(pack_bytes) T displacements[slopes ? numbers : 1];
    alignas(pack_bytes) T loads[6 * Real::width] = {};  // forces and torques on the partners
    std::int32_t places[Real::width] = {};              // places of their sums in the window
  };
  Stage& stage(std::size_t pack) { return stages_[pack % 4]; }

  // Sums over the partners in a row, for the body to which the row belongs.
  struct RowSums {
    Vec3<Real> f, tau;
    Real van_der_waals, coulomb;
    Mat3<Real> virial;
  };

  // Location of the sums for the slots of one molecule type.
  struct Window {
    T* sums;
    std::int32_t first;  // first slot of the window
    std::int32_t count;  // number of slots of the type
    T* at(std::int32_t place) const { return sums + place * std::ptrdiff_t{ChunkSums<T>::stride}; }
    T* of(std::uint32_t slot) const {
      const std::int32_t k = static_cast<std::int32_t>(slot) - first;
      return at(k < 0 ? k + count : k);
    }
  };
  Window window(std::size_t part) const {
    return {job_.sums.values.data() + job_.sums.first[part] * ChunkSums<T>::stride,
            static_cast<std::int32_t>(job_.chunk.windows[part].first),
            static_cast<std::int32_t>(job_.list.slots().parts[part].count)};
  }

  // Location of the sums for the ghosts of the partners' type, which are in the same rows.
  struct GhostWindow : Window {
    std::int32_t first_slot;  // first slot of all ghosts of this type
    std::int32_t shift;       // place of the partners' window in this window
  };
  std::optional<GhostWindow> ghost_window() const {
    const auto ghosts = job_.list.ghosts_of(job_.partner_part);
    if (!ghosts) return std::nullopt;
    const auto first = [&](std::size_t part) {
      return static_cast<std::int32_t>(job_.sums.first[part]);
    };
    return GhostWindow{window(*ghosts),
                       static_cast<std::int32_t>(job_.list.slots().parts[*ghosts].first),
                       first(job_.partner_part) - first(*ghosts)};
  }

  // Places of the sums of partners in the window.
  PackIndex<T> places_of(PackIndex<T> slots) const {
    const PackIndex<T> places = (slots - partner_.first).wrap(partner_.count);
    if (!ghosts_) return places;
    return ((slots - ghosts_->first).wrap(ghosts_->count) - ghosts_->shift)
        .replaced_if_negative(slots - ghosts_->first_slot, places);
  }

  // Prefetches data that the next packs will probably need.
  void prefetch(const std::uint32_t* entry) const {
    constexpr std::size_t packs_ahead = 4;
    const std::uint32_t* const later = entry + packs_ahead * Real::width;
    if (later + Real::width > job_.chunk.entries.data() + job_.chunk.entries.size()) return;
    for (std::size_t lane = 0; lane < Real::width; ++lane) {
      const std::uint32_t slot = Neighbour(later[lane]).slot();
      __builtin_prefetch(job_.records.of(slot));
      __builtin_prefetch(partner_.of(slot), 1);
    }
  }

  [[gnu::noinline]] void fetch(const std::uint32_t* entry, std::size_t pack) {
    if (far_apart_) prefetch(entry);
    Stage& to = stage(pack);
    const auto words = PackIndex<T>::load(entry);
    places_of(words & Neighbour::slot_mask).store(to.places);
    turn(job_.records, entry, to.partners, [&](Real number, std::size_t k) {
      return k < 3 ? in_image(number, words, k, edge_[k]) : number;
    });
    if constexpr (slopes)
      turn(*job_.displacements, entry, to.displacements, [](Real number, auto) { return number; });
  }

  // Transposes the records of partners into packs. Pack k contains number k of each record,
  // converted by as(pack, k).
  template <class As>
  POLHODE_INLINE void turn(const SiteRecords<T>& records, const std::uint32_t* entry, T* to,
                           const As& as) const {
    const T* record[Real::width];
    for (std::size_t lane = 0; lane < Real::width; ++lane)
      record[lane] = records.of(Neighbour(entry[lane]).slot());
    for (std::size_t k = 0; k < numbers_; k += Real::width) {
      Real column[Real::width];
      transpose<T>([&](std::size_t lane)
                       POLHODE_INLINE_LAMBDA { return Real::load(record[lane] + k); },
                   column);
      for (std::size_t i = 0; i < Real::width; ++i)
        as(column[i], k + i).store(to + (k + i) * Real::width);
    }
  }

  template <CutoffTreatment treatment, bool energies>
  POLHODE_INLINE void compute(std::uint32_t slot, std::size_t pack, RowSums& sums) {
    Stage& at = stage(pack);
    const T* const own_record = job_.records.of(slot);
    [[maybe_unused]] const T* const own_displacement =
        slopes ? job_.displacements->of(slot) : nullptr;
    // Number k in the record of the body, and in the records of its partners.
    const auto own = [&](std::size_t k) -> Number {
      if constexpr (slopes)
        return {Real(own_record[k]), Real(own_displacement[k])};
      else
        return Real(own_record[k]);
    };
    const auto partner = [&](std::size_t k) -> Number {
      const Real number = Real::load(at.partners + k * Real::width);
      if constexpr (slopes)
        return {number, Real::load(at.displacements + k * Real::width)};
      else
        return number;
    };
    Vec3<Number> R;
    for (std::size_t d = 0; d < 3; ++d) {
      const Real partners = Real::load(at.partners + d * Real::width);
      const Real difference = coordinate_difference(partners, own_record[d], unit_[d]);
      if constexpr (slopes)
        R[d] = {difference, (partner(d) - own(d)).slope};
      else
        R[d] = difference;
    }
    const auto site_of = [](const auto& number, std::size_t k) {
      return Vec3<Number>{number(3 + 3 * k), number(4 + 3 * k), number(5 + 3 * k)};
    };
    const PairLoad<Number> pair = molecule_pair<treatment, energies>(
        shape_, strengths_, job_.laws, R, [&](std::size_t a) { return site_of(own, a); },
        [&](std::size_t b) { return site_of(partner, b); });
    sums.f -= value_or_slope(pair.f);
    sums.tau += value_or_slope(pair.tau_a(R));
    if constexpr (energies) {
      sums.van_der_waals += pair.van_der_waals;
      sums.coulomb += pair.coulomb;
      for (std::size_t d = 0; d < 3; ++d) sums.virial[d] += R[d] * pair.f;
    }
    store(value_or_slope(pair.f), at.loads);
    store(value_or_slope(pair.tau_b), at.loads + 3 * Real::width);
  }
  static Vec3<Real> value_or_slope(const Vec3<Real>& v) { return v; }
  static Vec3<Real> value_or_slope(const Vec3<Dual<Real>>& v) { return slope(v); }

  // Adds the forces and torques on the partners of a pack to their sums. Before the first pack the
  // forces to add are zero, so any partner may receive them.
  [[gnu::noinline]] void add_up(std::size_t pack) {
    const Stage& from = stage(pack);
    std::array<Real, 6> load;
    for (std::size_t k = 0; k < 6; ++k) load[k] = Real::load(from.loads + k * Real::width);
    add_to_records(load, [&](std::size_t lane) { return partner_.at(from.places[lane]); });
  }

  template <bool energies>
  POLHODE_INLINE void add_row(std::uint32_t slot, const RowSums& row) {
    add_sums_to_record(std::array{row.f.x, row.f.y, row.f.z, row.tau.x, row.tau.y, row.tau.z},
                       own_.of(slot));
    if constexpr (energies) {
      const auto add = [](Pack<double>& total, Real what) {
        for (const Pack<double>& part : promote(what)) total += part;
      };
      add(van_der_waals_, row.van_der_waals);
      add(coulomb_, row.coulomb);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) add(virial_[i][k], row.virial[i][k]);
    }
  }

  static void store(const Vec3<Real>& v, T* to) {
    v.x.store(to), v.y.store(to + Real::width), v.z.store(to + 2 * Real::width);
  }
  const PairJob<T>& job_;
  const Shape shape_;
  const PairStrengths<Law>& strengths_;
  const Window own_, partner_;
  const std::optional<GhostWindow> ghosts_;
  const std::size_t numbers_;  // numbers of a partner's record, rounded up to whole packs
  const Vec3<double> edge_;    // box edges [nm]
  const bool far_apart_;       // whether records and sums exceed the second-level cache
  Vec3<T> unit_;
  Stage stages_[4];
  Pack<double> van_der_waals_, coulomb_;
  Mat3<Pack<double>> virial_;
};

template <class Number, class Shape, class Law, class T>
void run(const PairJob<T>& job, const PairStrengths<Law>& strengths) {
  PairRows<Number, Shape, Law> rows(job, strengths);
  const auto with = [&]<CutoffTreatment treatment>() {
    if constexpr (is_dual<Number>)
      rows.template run_with_slopes<treatment>();
    else if (job.energies)
      rows.template run<treatment, true>();
    else
      rows.template run<treatment, false>();
  };
  switch (job.treatment) {
    case CutoffTreatment::molecule_switch:
      return with.template operator()<CutoffTreatment::molecule_switch>();
    case CutoffTreatment::site_switch:
      return with.template operator()<CutoffTreatment::site_switch>();
    case CutoffTreatment::site_shift:
      return with.template operator()<CutoffTreatment::site_shift>();
    default:
      return with.template operator()<CutoffTreatment::smooth>();
  }
}

// Runs the unrolled loop of the first shape that fits the molecules. If no shape fits, or if a
// potential is not Lennard-Jones, the general loop is used.
template <class Number, class... Shapes, class T>
void run_fitting(const PairJob<T>& job) {
  if (!job.table.has_lennard_jones_alone())
    return run<Number, AnyShape<4>>(job, job.table.template any_law<T>());
  const PairStrengths<LennardJones<T>>& strengths = job.table.template lennard_jones<T>();
  if (!((Shapes::fits(job.table) && (run<Number, Shapes>(job, strengths), true)) || ...))
    run<Number, AnyShape<4>>(job, strengths);
}

using FourSiteWater = FixedShape<4, 3, 1>;  // numbers of sites, charged sites and sites with a
                                            // short-range potential
using ThreeSiteWater = FixedShape<3, 3, 1>;
using FiveSiteWater = FixedShape<5, 4, 1>;

template <class T>
void pair_forces_of(const PairJob<T>& job) {
  run_fitting<Pack<T>, FourSiteWater, ThreeSiteWater, FiveSiteWater,
              FixedShape<1, 0, 1>,           // noble gases
              FixedShape<1, 1, 1>,           // ions
              FixedShape<2, 2, 2>,           // linear molecules with two sites
              FixedShape<3, 3, 3>,           // linear molecules with three sites
              FixedShape<3, 3, 2>,           // two such sites with a charge between them
              FixedShape<4, 3, 1, 1, 1, 1>,  // ions in water
              FixedShape<1, 1, 1, 4, 3, 1>>(job);
}

// The loops for derivatives have fewer shapes, because derivatives are needed less often and for
// fewer kinds of molecules.
template <class T>
void pair_derivative_of(const PairJob<T>& job) {
  run_fitting<Dual<Pack<T>>, FourSiteWater, ThreeSiteWater, FiveSiteWater>(job);
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
