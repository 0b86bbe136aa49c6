// SPDX-License-Identifier: MIT
// Spreads charges onto the grid: the weights of a pack of charges at once, then one charge after
// the other, eight grid points of a row at a time.
#include "mesh_positions.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T, std::size_t order>
void spread(const SpreadJob<T>& job) {
  using Real = Pack<T>;
  constexpr std::size_t width = Real::width, stride = std::max(width, Run<T>::length);
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  alignas(pack_bytes) T along_x[width * stride], along_y[order * width], along_z[order * width];
  std::int32_t index[3][width];
  T* const grid = job.grid.values.data();
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width) {
    places.load(job.records, slot);
    const std::size_t lanes = std::min(width, job.bodies.end - slot);
    for (std::size_t site = 0; site < job.bodies.charges.size(); ++site) {
      Real w[3][order], slope[order];
      for (std::size_t d = 0; d < 3; ++d)
        b_spline<order>(places.place(site, d, index[d]), w[d], slope);
      const Real q(static_cast<T>(job.bodies.charges[site]));
      for (std::size_t c = 0; c < stride; c += width) {
        Real rows[width];
        transpose<T>([&](std::size_t k) { return c + k < order ? w[0][c + k] * q : Real(); }, rows);
        for (std::size_t lane = 0; lane < width; ++lane)
          rows[lane].store(along_x + lane * stride + c);
      }
      for (std::size_t k = 0; k < order; ++k) {
        w[1][k].store(along_y + k * width);
        w[2][k].store(along_z + k * width);
      }
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Run<T> x = Run<T>::load(along_x + lane * stride);
        T* const origin = grid + index[0][lane];
        const std::ptrdiff_t* const row_at = job.grid.row_at.data() + index[1][lane];
        Run<T> y[order];
        T* rows[order];
        for (std::size_t j = 0; j < order; ++j) {
          y[j] = Run<T>::all(along_y[j * width + lane]);
          rows[j] = origin + row_at[j];
        }
        const std::ptrdiff_t* const plane_at = job.plane_at + index[2][lane];
        for (std::size_t k = 0; k < order; ++k) {
          const std::ptrdiff_t plane = plane_at[k];
          if (plane < 0) continue;
          const Run<T> xz = x * Run<T>::all(along_z[k * width + lane]);
          for (std::size_t j = 0; j < order; ++j)
            fma(xz, y[j], Run<T>::load(rows[j] + plane)).store(rows[j] + plane);
        }
      }
    }
  }
}

template <class T>
void spread_in_order(const SpreadJob<T>& job) {
  with_order(job.order, [&]<std::size_t order>() { spread<T, order>(job); });
}

}  // namespace

void spread_charges(const SpreadJob<double>& job) { spread_in_order(job); }
void spread_charges(const SpreadJob<float>& job) { spread_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
