// SPDX-License-Identifier: MIT
// The directional derivative of the forces from the grid along a displacement of the charges. This
// derivative needs the second derivative of the splines.
#include "mesh_sums.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The force on a charge is −q ∇φ. The derivative of this force is −q (∇φ' + (v·∇) ∇φ), where φ' is
// the derivative of the potential on the grid.
template <class Real>
struct Gradient {
  Vec3<Real> value, change;
};

// The gradients ∇φ and ∇φ' + (v·∇) ∇φ, summed over the tiles around a charge, element by element.
// With w, s and c for a spline, its slope and its second derivative, and A, B, C for the sums over
// z of φ times w_z, s_z and c_z, A' and B' for the same sums with φ', the components of the second
// gradient are sums over x and y of
//   s_x w_y (A' + v_z B) + (v_x c_x w_y + v_y s_x s_y) A
//   w_x s_y (A' + v_z B) + (v_x s_x s_y + v_y w_x c_y) A
//   w_x w_y (B' + v_z C) + (v_x s_x w_y + v_y w_x s_y) B
template <class T, std::size_t order>
POLHODE_INLINE inline Gradient<Pack<T>> sum_over_tiles(const MeshGrid<T>& grid,
                                                       const MeshGrid<T>& derivative,
                                                       const GridIndex<T>& index, std::size_t lane,
                                                       const Vec3<T>& v,
                                                       const ChargeWeights<T, order, 2>& weights) {
  using Real = Pack<T>;
  const TilesAround<T, order> tiles(grid, index, lane);
  const Vec3<Real> move{Real(v.x), Real(v.y), Real(v.z)};
  const T *const wz = weights(2, 0, lane), *const sz = weights(2, 1, lane),
                 *const cz = weights(2, 2, lane);
  Gradient<Real> total;
  tiles.each_row([&](std::size_t j) {
    const auto along_y = [&](std::size_t n) { return tiles.along_y(weights(1, n, lane), j); };
    const Real wy = along_y(0), sy = along_y(1), cy = along_y(2);
    tiles.each_column([&](std::size_t i) {
      const T* const stack = grid.values.data() + tiles.stack(i, j);
      const T* const change = derivative.values.data() + tiles.stack(i, j);
      Real A, B, C, dA, dB;
      for (std::size_t k = 0; k < order; ++k) {
        const Real potential = Real::load(stack + k * Real::width),
                   slope = Real::load(change + k * Real::width);
        A = fma(potential, Real(wz[k]), A);
        B = fma(potential, Real(sz[k]), B);
        C = fma(potential, Real(cz[k]), C);
        dA = fma(slope, Real(wz[k]), dA);
        dB = fma(slope, Real(sz[k]), dB);
      }
      const Real wx = tiles.along_x(weights(0, 0, lane), i),
                 sx = tiles.along_x(weights(0, 1, lane), i),
                 cx = tiles.along_x(weights(0, 2, lane), i);
      const Real ww = wx * wy, sw = sx * wy, ws = wx * sy, ss = sx * sy;
      dA = fma(move.z, B, dA);
      dB = fma(move.z, C, dB);
      total.value += Vec3<Real>{sw * A, ws * A, ww * B};
      total.change += Vec3<Real>{fma(sw, dA, (move.x * (cx * wy) + move.y * ss) * A),
                                 fma(ws, dA, (move.x * ss + move.y * (wx * cy)) * A),
                                 fma(ww, dB, (move.x * sw + move.y * ws) * B)};
    });
  });
  return total;
}

template <class T, std::size_t order>
void gather(const GatherDerivativeJob<T>& derivative) {
  using Real = Pack<T>;
  const GatherJob<T>& job = derivative.forces;
  constexpr std::size_t width = Real::width;
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  GridPositions<T> moves(job.box, job.grid.points, job.bodies.charges.size());
  ChargeWeights<T, order, 2> weights;
  TileSums<T, 2> sums;
  GridIndex<T> index;
  alignas(pack_bytes) T v[3][width];
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width) {
    places.load(job.records, slot);
    moves.load(derivative.displacements, slot);
    const Mask<Real> present = first_lanes<T>(std::min(width, job.bodies.end - slot));
    Vec3<Real> df, dtau;
    for (std::size_t site = 0; site < job.bodies.charges.size(); ++site) {
      const Vec3<Real> move = moves.in_spacings(site);
      Vec3<Real> u;
      for (std::size_t d = 0; d < 3; ++d) {
        u[d] = places.beyond(site, d, index[d]);
        move[d].store(v[d]);
      }
      weights.set(u);
      for (std::size_t lane = 0; lane < width; ++lane) {
        const Gradient<Real> gradient =
            sum_over_tiles<T, order>(job.grid, derivative.derivative, index, lane,
                                     {v[0][lane], v[1][lane], v[2][lane]}, weights);
        sums.set(0, lane, gradient.value);
        sums.set(1, lane, gradient.change);
      }
      const Vec3<Real> force = force_of(sums(0), job, site, present),
                       change = force_of(sums(1), job, site, present);
      df += change;
      dtau += cross(places.arm(site), change) + cross(moves.arm(site), force);
    }
    add_to_records(std::array{df.x, df.y, df.z, dtau.x, dtau.y, dtau.z}, [&](std::size_t lane) {
      return job.sums + (slot + lane) * ChunkSums<T>::stride;
    });
  }
}

template <class T>
void gather_in_order(const GatherDerivativeJob<T>& job) {
  with_order(job.forces.order, [&]<std::size_t order>() { gather<T, order>(job); });
}

}  // namespace

void gather_derivative(const GatherDerivativeJob<double>& job) { gather_in_order(job); }
void gather_derivative(const GatherDerivativeJob<float>& job) { gather_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
