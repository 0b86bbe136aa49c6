// SPDX-License-Identifier: MIT
// Pairs of molecules in packs: one molecule with as many partners as a pack is wide. The records of
// the partners are turned into packs, the forces on them are turned back and added one by one.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "polhode/base/pack_places.hpp"
#include "polhode/forces/molecule_pair.hpp"
#include "polhode/forces/pair_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The difference of a coordinate of centres [nm], from the numbers in their records.
inline Pack<double> coordinate_difference(Pack<double> partner, double own, double) {
  return partner - Pack<double>(own);
}
inline Pack<float> coordinate_difference(Pack<float> partner, float own, float unit) {
  std::int32_t bits;
  std::memcpy(&bits, &own, sizeof bits);
  return fixed_point_difference(partner, bits) * Pack<float>(unit);
}
inline Pack<double> coordinate_sum(Pack<double> a, Pack<double> b) { return a + b; }
inline Pack<float> coordinate_sum(Pack<float> a, Pack<float> b) { return fixed_point_sum(a, b); }

// The rows of a chunk, one after the other: fetch the partners, compute the pairs, add up what they
// did. A row is added up only after the next one's partners were fetched, so that the processor
// need not wait for the last results of a row: fetching does not depend on them.
template <class T, class Shape>
class PairRows {
 public:
  using Real = Pack<T>;

  explicit PairRows(const PairJob<T>& job)
      : job_(job),
        shape_(job.table),
        strengths_(job.table.template strengths<T>()),
        own_(window(job.chunk.part)),
        partner_(window(job.partner_part)),
        numbers_((2 + 3 * shape_.sites_b + Real::width) / Real::width * Real::width),
        far_apart_(job.list.slots().size() > 8192 && job.list.slots().parts.size() == 1) {
    for (std::size_t d = 0; d < 3; ++d)
      unit_[d] = static_cast<T>(job.list.box().edge[d] / static_cast<double>(fixed_point_edge));
    const std::size_t packs = job.chunk.longest_row / Real::width * (numbers_ + 6) +
                              3 * (shape_.sites_a + 1);  // of a row
    Column<T>& space = job.sums.template scratch<T>();
    if (space.size() < 2 * packs * Real::width) space = Column<T>(2 * packs * Real::width);
    now_.scratch = space.data();
    before_.scratch = space.data() + packs * Real::width;
  }

  template <Ending ending, bool energies>
  void run() {
    const auto parts = job_.list.slots().parts.size();
    for (std::uint32_t slot = job_.chunk.first; slot < job_.chunk.end; ++slot) {
      const ListChunk::Row row = job_.chunk.row(slot, job_.partner_part, parts);
      if (row.begin == row.end) continue;
      now_.slot = slot;
      now_.entries = &job_.chunk.entries[row.begin];
      now_.whole = (row.ending - row.begin) / Real::width;
      now_.packs = (row.end - row.begin) / Real::width;
      if (far_apart_) prefetch(row.end, row.end - row.begin);
      fetch(now_);
      add_up(before_);
      compute<ending, energies>(now_);
      std::swap(now_, before_);
    }
    add_up(before_);
    if constexpr (energies) {
      job_.sums.lennard_jones += sum(lennard_jones_);
      job_.sums.coulomb += sum(coulomb_);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) job_.sums.virial[i][k] += sum(virial_[i][k]);
    }
  }

 private:
  // A row of the list with its numbers: for each pack the records of the partners, turned, and
  // forces and torques on them; then the force on the row's body, less its sign, and what each of
  // its sites does.
  struct Row {
    std::uint32_t slot = 0;
    const std::uint32_t* entries = nullptr;
    std::size_t whole = 0, packs = 0;
    T* scratch = nullptr;
  };
  T* partners(const Row& row, std::size_t pack) const {
    return row.scratch + pack * (numbers_ + 6) * Real::width;
  }
  T* loads(const Row& row, std::size_t pack) const {
    return partners(row, pack) + numbers_ * Real::width;
  }

  // Where the sums of a molecule type's slots are.
  struct Window {
    double* sums;
    std::uint32_t first;  // the window's first slot
    std::int32_t count;   // slots of the type
    double* of(std::uint32_t slot) const {
      const auto k = static_cast<std::int32_t>(slot - first);
      const std::int32_t wrapped = k + (k >> 31 & count);  // no branch: it would be mispredicted
      return sums + static_cast<std::size_t>(wrapped) * ChunkSums::stride;
    }
  };
  Window window(std::size_t part) const {
    return {&job_.sums.values[job_.sums.first[part] * ChunkSums::stride],
            job_.chunk.windows[part].first,
            static_cast<std::int32_t>(job_.list.slots().parts[part].count)};
  }

  // Asks the caches for what the next row will most likely need: the entries after this one's.
  void prefetch(std::size_t begin, std::size_t count) const {
    const std::size_t end = std::min(begin + count, job_.chunk.entries.size());
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t slot = Neighbour(job_.chunk.entries[k]).slot();
      __builtin_prefetch(job_.records.of(slot));
      __builtin_prefetch(partner_.of(slot), 1);
    }
  }

  auto own_site(const Row& row) const {
    const T* const sites = job_.records.of(row.slot) + 3;
    return [sites](std::size_t a) {
      return Vec3<Real>{Real(sites[3 * a]), Real(sites[3 * a + 1]), Real(sites[3 * a + 2])};
    };
  }

  void fetch(const Row& row) const {
    const std::uint32_t* entry = row.entries;
    for (std::size_t pack = 0; pack < row.packs; ++pack, entry += Real::width) {
      T* to = partners(row, pack);
      const T *record[Real::width], *shift[Real::width];
      for (std::size_t lane = 0; lane < Real::width; ++lane) {
        const Neighbour partner(entry[lane]);
        record[lane] = job_.records.of(partner.slot());
        shift[lane] = job_.records.shift(partner.image());
      }
      for (std::size_t k = 0; k < numbers_; k += Real::width) {
        Real column[Real::width];
        transpose<T>(
            [&](std::size_t lane) __attribute__((always_inline)) {
              const Real numbers = Real::load(record[lane] + k);
              return k < 3 ? coordinate_sum(numbers, Real::load(shift[lane] + k)) : numbers;
            },
            column);
        for (const Real& c : column) c.store(to), to += Real::width;
      }
    }
  }

  template <Ending ending, bool energies>
  void compute(const Row& row) {
    const T* const own = job_.records.of(row.slot);
    std::array<Vec3<Real>, Shape::most_a> f_a;  // what each site does to the partners
    each(
        shape_.sites_a, [&](auto a) __attribute__((always_inline)) { f_a[a] = {}; });
    Vec3<Real> f;
    Real lennard_jones, coulomb;
    Mat3<Real> virial;

    const auto pairs_of = [&]<Ending how>(std::size_t pack) __attribute__((always_inline)) {
      const T* const number = partners(row, pack);
      const auto column = [&](std::size_t k) { return Real::load(number + k * Real::width); };
      Vec3<Real> R;
      for (std::size_t d = 0; d < 3; ++d) R[d] = coordinate_difference(column(d), own[d], unit_[d]);
      const PairLoad<Real> pair = molecule_pair<how, energies>(
          shape_, strengths_, job_.laws, R, own_site(row),
          [&](std::size_t b) {
            return Vec3<Real>{column(3 + 3 * b), column(4 + 3 * b), column(5 + 3 * b)};
          },
          f_a.data());
      f += pair.f;
      if constexpr (energies) {
        lennard_jones += pair.lennard_jones;
        coulomb += pair.coulomb;
        for (std::size_t d = 0; d < 3; ++d) virial[d] += R[d] * pair.f;
      }
      store(pair.f, loads(row, pack));
      store(pair.tau_b, loads(row, pack) + 3 * Real::width);
    };
    for (std::size_t pack = 0; pack < row.whole; ++pack)
      pairs_of.template operator()<Ending::none>(pack);
    for (std::size_t pack = row.whole; pack < row.packs; ++pack)
      pairs_of.template operator()<ending>(pack);

    T* to = partners(row, row.packs);
    store(f, to);
    each(
        shape_.sites_a, [&](auto a) __attribute__((always_inline)) {
          store(f_a[a], to += 3 * Real::width);
        });
    if constexpr (energies) {
      const auto add = [](Pack<double>& total, Real what) {
        for (const Pack<double>& part : widened(what)) total += part;
      };
      add(lennard_jones_, lennard_jones);
      add(coulomb_, coulomb);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) add(virial_[i][k], virial[i][k]);
    }
  }

  // Forces and torques on the partners and on the row's body, to their sums.
  void add_up(const Row& row) const {
    const std::uint32_t* entry = row.entries;
    for (std::size_t pack = 0; pack < row.packs; ++pack, entry += Real::width) {
      const T* const load = loads(row, pack);
      std::array<Real, 6> column;
      for (std::size_t k = 0; k < 6; ++k) column[k] = Real::load(load + k * Real::width);
      add_to_records(column,
                     [&](std::size_t lane) { return partner_.of(Neighbour(entry[lane]).slot()); });
    }
    if (row.packs == 0) return;
    const T* from = partners(row, row.packs);
    const Vec3<Real> f = loaded(from);
    Vec3<Real> tau;
    const auto site = own_site(row);
    each(
        shape_.sites_a, [&](auto a) __attribute__((always_inline)) {
          tau -= cross(site(a), loaded(from += 3 * Real::width));
        });
    add_sums_to_record(std::array{-f.x, -f.y, -f.z, tau.x, tau.y, tau.z}, own_.of(row.slot));
  }

  static void store(const Vec3<Real>& v, T* to) {
    v.x.store(to), v.y.store(to + Real::width), v.z.store(to + 2 * Real::width);
  }
  static Vec3<Real> loaded(const T* from) {
    return {Real::load(from), Real::load(from + Real::width), Real::load(from + 2 * Real::width)};
  }

  const PairJob<T>& job_;
  const Shape shape_;
  const PairStrengths<T>& strengths_;
  const Window own_, partner_;
  const std::size_t numbers_;  // of a partner's record, in whole packs
  const bool far_apart_;       // records and sums exceed the second-level cache
  Vec3<T> unit_;
  Row now_, before_;
  Pack<double> lennard_jones_, coulomb_;
  Mat3<Pack<double>> virial_;
};

template <class T, class Shape>
void run(const PairJob<T>& job) {
  PairRows<T, Shape> rows(job);
  const auto with = [&]<Ending ending>() {
    if (job.energies)
      rows.template run<ending, true>();
    else
      rows.template run<ending, false>();
  };
  switch (job.truncation) {
    case Truncation::molecule_switch:
      return with.template operator()<Ending::molecule_switch>();
    case Truncation::site_switch:
      return with.template operator()<Ending::site_switch>();
    case Truncation::site_shift:
      return with.template operator()<Ending::site_shift>();
  }
}

// The first of the shapes that fits, or the general path.
template <class T, class... Shapes>
void run_fitting(const PairJob<T>& job) {
  if (!((Shapes::fits(job.table) && (run<T, Shapes>(job), true)) || ...)) run<T, AnyShape>(job);
}

template <class T>
void pair_forces_of(const PairJob<T>& job) {
  run_fitting<T,                             // sites, charged, dispersive
              FixedShape<4, 3, 1>,           // four-site water
              FixedShape<3, 3, 1>,           // three-site water
              FixedShape<5, 4, 1>,           // five-site water
              FixedShape<1, 0, 1>,           // noble gases
              FixedShape<1, 1, 1>,           // ions
              FixedShape<2, 2, 2>,           // linear, two sites
              FixedShape<3, 3, 3>,           // linear, three sites
              FixedShape<3, 3, 2>,           // and with a charge between them
              FixedShape<4, 3, 1, 1, 1, 1>,  // ions in water
              FixedShape<1, 1, 1, 4, 3, 1>>(job);
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
