// SPDX-License-Identifier: MIT
// Spreads charges onto the grid. Weights are computed for a pack of charges, and then the charges
// and tiles are processed in sequence.
#include "mesh_tiles.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Loads charges, given by their indices, as packs.
template <class T>
class ListedCharges {
 public:
  using Real = Pack<T>;
  GridIndex<T> index;
  Vec3<Real> u;  // distances beyond the grid points
  Real q;

  // If fewer charges than lanes are left, the last charge fills the missing lanes.
  void load(const SpreadJob<T>& job, const std::uint32_t* from) {
    Real number[4];
    load_four<T>(record_of(job, job.charges, from), number);
    for (std::size_t d = 0; d < 3; ++d)
      u[d] = beyond_point(number[d], static_cast<std::int32_t>(job.grid.points[d]), index[d]);
    q = number[3];
  }
  // Prefetches the records of charges that are loaded later.
  static void prefetch(const SpreadJob<T>& job, const std::uint32_t* from) {
    const auto record = record_of(job, job.charges, from);
    for (std::size_t lane = 0; lane < Real::width; ++lane) __builtin_prefetch(record(lane));
  }
  static Vec3<Real> move(const SpreadJob<T>& job, const std::uint32_t* from) {
    Real number[4];
    load_four<T>(record_of(job, job.moves, from), number);
    return {number[0], number[1], number[2]};
  }

 private:
  static auto record_of(const SpreadJob<T>& job, const T* records, const std::uint32_t* from) {
    return [=, last = job.end - 1](std::size_t lane) {
      return records + ChargeRecord::stride * *std::min(from + lane, last);
    };
  }
};

template <class T, std::size_t order>
POLHODE_INLINE inline void add_charge(MeshGrid<T>& grid, const GridIndex<T>& index,
                                      std::size_t lane, const ChargeWeights<T, order, 0>& weights) {
  using Real = Pack<T>;
  const TilesAround<T, order> tiles(grid, index, lane);
  Real z[order];
  for (std::size_t k = 0; k < order; ++k) z[k] = Real(weights(2, 0, lane)[k]);
  Real x[TilesAround<T, order>::Columns::max];
  tiles.each_column([&](std::size_t i) { x[i] = tiles.along_x(weights(0, 0, lane), i); });
  tiles.each_row([&](std::size_t j) {
    const Real y = tiles.along_y(weights(1, 0, lane), j);
    tiles.each_column([&](std::size_t i) POLHODE_INLINE_LAMBDA {
      T* const stack = grid.values.data() + tiles.stack(i, j);
      const Real xy = x[i] * y;
      for (std::size_t k = 0; k < order; ++k)
        fma(xy, z[k], Real::load(stack + k * Real::width)).store(stack + k * Real::width);
    });
  });
}

template <class T, std::size_t order>
void spread(const SpreadJob<T>& job) {
  constexpr std::size_t width = Pack<T>::width;
  if (job.order == job.end) return;
  ListedCharges<T> packs[2];
  ChargeWeights<T, order, 0> weights;
  packs[0].load(job, job.order);
  std::size_t pack = 0;
  for (const std::uint32_t* from = job.order; from < job.end; from += width, ++pack) {
    const ListedCharges<T>& charges = packs[pack % 2];
    ListedCharges<T>& following = packs[(pack + 1) % 2];
    following.load(job, from + width);
    if (job.grid.is_large()) following.prefetch(job, from + 4 * width);
    weights.set(charges.u, charges.q);
    const std::size_t lanes = std::min(width, static_cast<std::size_t>(job.end - from));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (job.grid.is_large()) prefetch_tiles<T, order, true>(job.grid, following.index, lane);
      add_charge<T, order>(job.grid, charges.index, lane, weights);
    }
  }
}

// A charge q that moves along v, in grid spacings, changes the charge on a grid point at the rate q
// (v·∇) w_x w_y w_z = q [(v_x s_x w_y + w_x v_y s_y) w_z + w_x w_y v_z s_z], where s are the slopes
// of w.
template <class T, std::size_t order>
POLHODE_INLINE inline void add_dipole(MeshGrid<T>& grid, const GridIndex<T>& index,
                                      std::size_t lane, const Vec3<T>& v,
                                      const ChargeWeights<T, order, 1>& weights) {
  using Real = Pack<T>;
  const TilesAround<T, order> tiles(grid, index, lane);
  Real z[order], dz[order];
  for (std::size_t k = 0; k < order; ++k) {
    z[k] = Real(weights(2, 0, lane)[k]);
    dz[k] = Real(v.z) * Real(weights(2, 1, lane)[k]);
  }
  tiles.each_row([&](std::size_t j) {
    const Real y = tiles.along_y(weights(1, 0, lane), j),
               dy = Real(v.y) * tiles.along_y(weights(1, 1, lane), j);
    tiles.each_column([&](std::size_t i) {
      T* const stack = grid.values.data() + tiles.stack(i, j);
      const Real x = tiles.along_x(weights(0, 0, lane), i),
                 dx = Real(v.x) * tiles.along_x(weights(0, 1, lane), i);
      const Real by_z = fma(dx, y, x * dy), by_dz = x * y;
      for (std::size_t k = 0; k < order; ++k) {
        T* const tile = stack + k * Real::width;
        fma(by_z, z[k], fma(by_dz, dz[k], Real::load(tile))).store(tile);
      }
    });
  });
}

template <class T, std::size_t order>
void spread_dipoles_of(const SpreadJob<T>& job) {
  constexpr std::size_t width = Pack<T>::width;
  ListedCharges<T> charges;
  ChargeWeights<T, order, 1> weights;
  alignas(pack_bytes) T v[3][width];
  for (const std::uint32_t* from = job.order; from < job.end; from += width) {
    charges.load(job, from);
    weights.set(charges.u, charges.q);
    const Vec3<Pack<T>> move = charges.move(job, from);
    for (std::size_t d = 0; d < 3; ++d) move[d].store(v[d]);
    const std::size_t lanes = std::min(width, static_cast<std::size_t>(job.end - from));
    for (std::size_t lane = 0; lane < lanes; ++lane)
      add_dipole<T, order>(job.grid, charges.index, lane, {v[0][lane], v[1][lane], v[2][lane]},
                           weights);
  }
}

template <class T>
void spread_in_order(const SpreadJob<T>& job) {
  with_order(job.spline, [&]<std::size_t order>() { spread<T, order>(job); });
}
template <class T>
void spread_dipoles_in_order(const SpreadJob<T>& job) {
  with_order(job.spline, [&]<std::size_t order>() { spread_dipoles_of<T, order>(job); });
}

}  // namespace

void spread_charges(const SpreadJob<double>& job) { spread_in_order(job); }
void spread_charges(const SpreadJob<float>& job) { spread_in_order(job); }
void spread_dipoles(const SpreadJob<double>& job) { spread_dipoles_in_order(job); }
void spread_dipoles(const SpreadJob<float>& job) { spread_dipoles_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
