// SPDX-License-Identifier: MIT
// Forces from the potential on the grid: the exact gradient with respect to the splines' weights.
// The eight grid points of a row are first summed over the rows, one charge after the other; the
// rest is done for a pack of charges at once.
#include "mesh_charges.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

enum Weight { y_w, y_s, z_w, z_s, weights };  // w: a spline, s: its slope

// Around one charge, for each point along x: the potential summed over y and z, times w_y w_z,
// s_y w_z and w_y s_z.
template <class T, std::size_t order>
[[gnu::always_inline]] inline void sum_over_rows(const GridPoints<T>& at,
                                                 const ChargeWeights<T, order, weights>& weight,
                                                 std::size_t lane, T* sums) {
  RunPair<T> y[order];  // weight and slope
  const T* rows[order];
  for (std::size_t j = 0; j < order; ++j) {
    y[j] = RunPair<T>::all(weight(y_w, j, lane), weight(y_s, j, lane));
    rows[j] = at.values + at.row_at[j];
  }
  RunPair<T> by_z_weight = RunPair<T>::all(0, 0);
  Run<T> by_z_slope = Run<T>::zero();
  for (std::size_t k = 0; k < order; ++k) {
    RunPair<T> sum = RunPair<T>::twice(rows[0] + at.plane_at[k]) * y[0];
    for (std::size_t j = 1; j < order; ++j)
      sum = fma(RunPair<T>::twice(rows[j] + at.plane_at[k]), y[j], sum);
    const T z = weight(z_w, k, lane);
    by_z_weight = fma(sum, RunPair<T>::all(z, z), by_z_weight);
    by_z_slope = fma(sum.first(), Run<T>::all(weight(z_s, k, lane)), by_z_slope);
  }
  by_z_weight.store(sums), by_z_slope.store(sums + 2 * Run<T>::length);
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
  constexpr std::size_t width = Real::width, length = Run<T>::length;
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  ChargeWeights<T, order, weights> along;
  RowSums<T, 3> sums;
  std::int32_t index[3][width];
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width) {
    places.load(job.records, slot);
    const Mask<Real> present = first_lanes<T>(std::min(width, job.bodies.end - slot));
    Vec3<Real> f, tau;
    Mat3<Real> arms;
    for (std::size_t site = 0; site < job.bodies.charges.size(); ++site) {
      Real w[3][order], slope[3][order];
      for (std::size_t d = 0; d < 3; ++d)
        b_spline<order>(places.place(site, d, index[d]), w[d], slope[d]);
      for (std::size_t k = 0; k < order; ++k) {
        along.set(y_w, k, w[1][k]), along.set(y_s, k, slope[1][k]);
        along.set(z_w, k, w[2][k]), along.set(z_s, k, slope[2][k]);
      }
      for (std::size_t lane = 0; lane < width; ++lane)
        sum_over_rows<T, order>({job.grid, index, lane}, along, lane, sums.of(lane));
      Real column[RowSums<T, 3>::columns];
      sums.transpose_to(column);
      Vec3<Real> field;
      for (std::size_t c = 0; c < order; ++c) {
        field.x = fma(column[c], slope[0][c], field.x);
        field.y = fma(column[length + c], w[0][c], field.y);
        field.z = fma(column[2 * length + c], w[0][c], field.z);
      }
      const Vec3<Real> force = force_of(field, job, site, present), arm = places.arm(site);
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
