// SPDX-License-Identifier: MIT
// Forces from the potential on the grid, computed with the exact derivatives of the spline weights.
#include "mesh_sums.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The sum Σ φ ∇ w_x w_y w_z over the tiles around a charge, element by element. φ is the potential,
// w is a spline, and s is the slope of w.
template <class T, std::size_t order>
POLHODE_INLINE inline Vec3<Pack<T>> sum_over_tiles(const MeshGrid<T>& grid,
                                                   const GridIndex<T>& index, std::size_t lane,
                                                   const ChargeWeights<T, order, 1>& weights) {
  using Real = Pack<T>;
  const TilesAround<T, order> tiles(grid, index, lane);
  Real wz[order], sz[order];
  for (std::size_t k = 0; k < order; ++k) {
    wz[k] = Real(weights(2, 0, lane)[k]);
    sz[k] = Real(weights(2, 1, lane)[k]);
  }
  Vec3<Real> total;
  tiles.each_row([&](std::size_t j) {
    Vec3<Real> row;  // sums over z and x of φ times s_x w_z, w_x w_z and w_x s_z
    tiles.each_column([&](std::size_t i) POLHODE_INLINE_LAMBDA {
      const T* const stack = grid.values.data() + tiles.stack(i, j);
      Real by_w, by_s;
      for (std::size_t k = 0; k < order; ++k) {
        const Real potential = Real::load(stack + k * Real::width);
        by_w = k == 0 ? potential * wz[k] : fma(potential, wz[k], by_w);
        by_s = k == 0 ? potential * sz[k] : fma(potential, sz[k], by_s);
      }
      const Real wx = tiles.along_x(weights(0, 0, lane), i);
      row.x = fma(by_w, tiles.along_x(weights(0, 1, lane), i), row.x);
      row.y = fma(by_w, wx, row.y);
      row.z = fma(by_s, wx, row.z);
    });
    const Real wy = tiles.along_y(weights(1, 0, lane), j),
               sy = tiles.along_y(weights(1, 1, lane), j);
    total.x = fma(row.x, wy, total.x);
    total.y = fma(row.y, sy, total.y);
    total.z = fma(row.z, wy, total.z);
  });
  return total;
}

template <class T>
void add_arms(const Mat3<Pack<T>>& arms, Mat3<double>& total) {
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t e = 0; e < 3; ++e)
      for (const Pack<double>& part : promote(arms[d][e])) total[d][e] += sum(part);
}

template <class T, std::size_t order>
void gather(const GatherJob<T>& job) {
  using Real = Pack<T>;
  constexpr std::size_t width = Real::width;
  const std::size_t sites = job.bodies.charges.size();
  GridPositions<T> packs[2] = {{job.box, job.grid.points, sites},
                               {job.box, job.grid.points, sites}};
  packs[0].load(job.records, job.bodies.first);
  std::size_t pack = 0;
  ChargeWeights<T, order, 1> weights;
  TileSums<T, 1> sums;
  GridIndex<T> index, later;
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width, ++pack) {
    const GridPositions<T>& places = packs[pack % 2];
    GridPositions<T>& following = packs[(pack + 1) % 2];
    const bool more = slot + width < job.bodies.end, prefetching = more && job.grid.is_large();
    if (more) following.load(job.records, slot + width);
    const Mask<Real> present = first_lanes<T>(std::min(width, job.bodies.end - slot));
    Vec3<Real> f, tau;
    Mat3<Real> arms;
    for (std::size_t site = 0; site < sites; ++site) {
      Vec3<Real> u;
      for (std::size_t d = 0; d < 3; ++d) u[d] = places.beyond(site, d, index[d]);
      if (prefetching)
        for (std::size_t d = 0; d < 3; ++d) following.beyond(site, d, later[d]);
      weights.set(u);
      for (std::size_t lane = 0; lane < width; ++lane) {
        if (prefetching) prefetch_tiles<T, order, false>(job.grid, later, lane);
        sums.set(0, lane, sum_over_tiles<T, order>(job.grid, index, lane, weights));
      }
      const Vec3<Real> force = force_of(sums(0), job, site, present), arm = places.arm(site);
      f += force;
      tau += cross(arm, force);
      for (std::size_t d = 0; d < 3; ++d) arms[d] += arm[d] * force;
    }
    add_to_records(std::array{f.x, f.y, f.z, tau.x, tau.y, tau.z}, [&](std::size_t lane) {
      return job.sums + (slot + lane) * ChunkSums<T>::stride;
    });
    if (job.arms) add_arms(arms, *job.arms);
  }
}

template <class T>
void gather_in_order(const GatherJob<T>& job) {
  with_order(job.order, [&]<std::size_t order>() { gather<T, order>(job); });
}

}  // namespace

void gather_forces(const GatherJob<double>& job) { gather_in_order(job); }
void gather_forces(const GatherJob<float>& job) { gather_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
