// SPDX-License-Identifier: MIT
// Forces from the potential on the grid: the exact gradient with respect to the splines' weights.
// The eight grid points of a row are first summed over the rows, one charge after the other; the
// rest is done for a pack of charges at once.
#include "mesh_positions.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T, int order>
void gather(const GatherJob<T>& job) {
  using Real = Pack<T>;
  constexpr std::size_t width = Real::width, length = Run<T>::length, stride = 3 * length;
  constexpr std::size_t columns = (stride + width - 1) / width * width;
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  alignas(pack_bytes) T along[4][order * width], sums[width * columns] = {};
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
      for (std::size_t k = 0; k < order; ++k)
        for (std::size_t d = 1; d < 3; ++d) {
          w[d][k].store(along[2 * d - 2] + k * width);
          slope[d][k].store(along[2 * d - 1] + k * width);
        }
      for (std::size_t lane = 0; lane < width; ++lane) {
        const T* const origin = job.grid.values.data() + index[0][lane];
        const std::ptrdiff_t* const row_at = job.grid.row_at.data() + index[1][lane];
        const std::ptrdiff_t* const plane_at = job.grid.plane_at.data() + index[2][lane];
        const auto weight = [&](std::size_t which, std::size_t k) {
          return along[which][k * width + lane];
        };
        RunPair<T> y[order];  // weight and slope
        const T* rows[order];
        for (std::size_t j = 0; j < order; ++j) {
          y[j] = RunPair<T>::all(weight(0, j), weight(1, j));
          rows[j] = origin + row_at[j];
        }
        RunPair<T> by_z_weight = RunPair<T>::all(0, 0);
        Run<T> by_z_slope = Run<T>::zero();
        for (std::size_t k = 0; k < order; ++k) {
          RunPair<T> sum = RunPair<T>::twice(rows[0] + plane_at[k]) * y[0];
          for (std::size_t j = 1; j < order; ++j)
            sum = fma(RunPair<T>::twice(rows[j] + plane_at[k]), y[j], sum);
          const T z = weight(2, k);
          by_z_weight = fma(sum, RunPair<T>::all(z, z), by_z_weight);
          by_z_slope = fma(sum.first(), Run<T>::all(weight(3, k)), by_z_slope);
        }
        T* const to = sums + lane * columns;
        by_z_weight.store(to), by_z_slope.store(to + 2 * length);
      }
      Real column[columns];
      for (std::size_t c = 0; c < columns; c += width)
        transpose<T>([&](std::size_t lane) { return Real::load(sums + lane * columns + c); },
                     column + c);
      Vec3<Real> field;
      for (std::size_t c = 0; c < order; ++c) {
        field.x = fma(column[c], slope[0][c], field.x);
        field.y = fma(column[length + c], w[0][c], field.y);
        field.z = fma(column[2 * length + c], w[0][c], field.z);
      }
      Vec3<Real> force;
      for (std::size_t d = 0; d < 3; ++d) {
        const double points = static_cast<double>(job.grid.points[d]);
        const Real factor(static_cast<T>(-job.bodies.charges[site] * points / job.box.edge[d]));
        force[d] = select(present, factor * field[d], Real());
      }
      const Vec3<Real> arm = places.arm(site);
      f += force;
      tau += cross(arm, force);
      for (std::size_t d = 0; d < 3; ++d) arms[d] += arm[d] * force;
    }
    add_to_records(std::array{f.x, f.y, f.z, tau.x, tau.y, tau.z}, [&](std::size_t lane) {
      return job.sums + (slot + lane) * ChunkSums<T>::stride;
    });
    if (job.arms)
      for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t e = 0; e < 3; ++e)
          for (const Pack<double>& part : promote(arms[d][e])) (*job.arms)[d][e] += sum(part);
  }
}

template <class T>
void gather_in_order(const GatherJob<T>& job) {
  with_order(job.order, [&]<int order>() { gather<T, order>(job); });
}

}  // namespace

void gather_forces(const GatherJob<double>& job) { gather_in_order(job); }
void gather_forces(const GatherJob<float>& job) { gather_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
