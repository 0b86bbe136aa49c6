// SPDX-License-Identifier: MIT
// The directional derivatives of the spread and gather loops: charges on the grid, and forces from
// the potential there, differentiated along a displacement of the charges. They need one more
// derivative of the splines.
#include "mesh_positions.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Per unit of a displacement along v, in grid spacings, a charge q adds to a grid point at u
// q (v·∇) w_x w_y w_z = q [v_x s_x w_y w_z + w_x (v_y s_y w_z + w_y v_z s_z)], s the slopes of w.
template <class T, int order>
void spread(const SpreadDipolesJob<T>& dipoles) {
  using Real = Pack<T>;
  const SpreadJob<T>& job = dipoles.charges;
  constexpr std::size_t width = Real::width, stride = std::max(width, Run<T>::length);
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  GridPositions<T> moves(job.box, job.grid.points, job.bodies.charges.size());
  // q w and q v s along x; w and v s along y and z.
  alignas(pack_bytes) T along_x[2][width * stride], along_y[2][order * width],
      along_z[2][order * width];
  std::int32_t index[3][width];
  T* const grid = job.grid.values.data();
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width) {
    places.load(job.records, slot);
    moves.load(dipoles.displacements, slot);
    const std::size_t lanes = std::min(width, job.bodies.end - slot);
    for (std::size_t site = 0; site < job.bodies.charges.size(); ++site) {
      const Vec3<Real> v = moves.in_spacings(site);
      Real share[2][3][order];  // w, v s
      for (std::size_t d = 0; d < 3; ++d) {
        b_spline<order>(places.place(site, d, index[d]), share[0][d], share[1][d]);
        for (Real& slope : share[1][d]) slope *= v[d];
      }
      const Real q(static_cast<T>(job.bodies.charges[site]));
      for (std::size_t which = 0; which < 2; ++which) {
        for (std::size_t c = 0; c < stride; c += width) {
          Real rows[width];
          transpose<T>(
              [&](std::size_t k) { return c + k < order ? share[which][0][c + k] * q : Real(); },
              rows);
          for (std::size_t lane = 0; lane < width; ++lane)
            rows[lane].store(along_x[which] + lane * stride + c);
        }
        for (std::size_t k = 0; k < order; ++k) {
          share[which][1][k].store(along_y[which] + k * width);
          share[which][2][k].store(along_z[which] + k * width);
        }
      }
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Run<T> x = Run<T>::load(along_x[0] + lane * stride),
                     dx = Run<T>::load(along_x[1] + lane * stride);
        T* const origin = grid + index[0][lane];
        const std::ptrdiff_t* const row_at = job.grid.row_at.data() + index[1][lane];
        Run<T> y[order], dy[order];
        T* rows[order];
        for (std::size_t j = 0; j < order; ++j) {
          y[j] = Run<T>::all(along_y[0][j * width + lane]);
          dy[j] = Run<T>::all(along_y[1][j * width + lane]);
          rows[j] = origin + row_at[j];
        }
        const std::ptrdiff_t* const plane_at = job.plane_at + index[2][lane];
        for (std::size_t k = 0; k < order; ++k) {
          const std::ptrdiff_t plane = plane_at[k];
          if (plane < 0) continue;
          const Run<T> z = Run<T>::all(along_z[0][k * width + lane]),
                       dz = Run<T>::all(along_z[1][k * width + lane]);
          const Run<T> by_y = fma(x, dz, dx * z), by_dy = x * z;
          for (std::size_t j = 0; j < order; ++j)
            fma(by_y, y[j], fma(by_dy, dy[j], Run<T>::load(rows[j] + plane)))
                .store(rows[j] + plane);
        }
      }
    }
  }
}

// The force on a charge is −q ∇φ, its derivative −q (∇φ' + (v·∇) ∇φ), where φ' is the derivative of
// the potential on the grid. With w, s and c for a spline, its slope and its second derivative, and
// the sums over y and z of the potential times
//   A: w_y w_z   B: s_y w_z   C: w_y s_z   and likewise A', B', C' for its derivative,
// the components of the bracket are the sums over x of
//   s (A' + v_y B + v_z C) + v_x c A
//   w (B' + P) + v_x s B   with P: v_y c_y w_z + v_z s_y s_z
//   w (C' + Q) + v_x s C   with Q: v_y s_y s_z + v_z w_y c_z
template <class T, int order>
void gather(const GatherDerivativeJob<T>& derivative) {
  using Real = Pack<T>;
  const GatherJob<T>& job = derivative.forces;
  constexpr std::size_t width = Real::width, length = Run<T>::length, stride = 6 * length;
  constexpr std::size_t columns = (stride + width - 1) / width * width;
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  GridPositions<T> moves(job.box, job.grid.points, job.bodies.charges.size());
  enum Weight { y_w, y_s, y_c, z_w, z_s, z_c, z_s_by_y, z_s_by_z, weights };
  alignas(pack_bytes) T along[weights][order * width], sums[width * columns] = {};
  std::int32_t index[3][width];
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += width) {
    places.load(job.records, slot);
    moves.load(derivative.displacements, slot);
    const Mask<Real> present = first_lanes<T>(std::min(width, job.bodies.end - slot));
    Vec3<Real> df, dtau;
    for (std::size_t site = 0; site < job.bodies.charges.size(); ++site) {
      const Vec3<Real> v = moves.in_spacings(site);
      Real w[3][order], s[3][order], c[3][order];
      for (std::size_t d = 0; d < 3; ++d)
        b_spline<order>(places.place(site, d, index[d]), w[d], s[d], c[d]);
      for (std::size_t k = 0; k < order; ++k) {
        const auto put = [&](Weight which, Real what) { what.store(along[which] + k * width); };
        put(y_w, w[1][k]), put(y_s, s[1][k]), put(y_c, v.y * c[1][k]);
        put(z_w, w[2][k]), put(z_s, s[2][k]), put(z_c, v.z * c[2][k]);
        put(z_s_by_y, v.y * s[2][k]), put(z_s_by_z, v.z * s[2][k]);
      }
      for (std::size_t lane = 0; lane < width; ++lane) {
        const T* const potential = job.grid.values.data() + index[0][lane];
        const T* const change = derivative.derivative.values.data() + index[0][lane];
        const std::ptrdiff_t* const row_at = job.grid.row_at.data() + index[1][lane];
        const std::ptrdiff_t* const plane_at = job.grid.plane_at.data() + index[2][lane];
        const auto weight = [&](Weight which, std::size_t k) {
          return along[which][k * width + lane];
        };
        RunPair<T> y[order];  // w and s
        Run<T> yc[order];
        for (std::size_t j = 0; j < order; ++j) {
          y[j] = RunPair<T>::all(weight(y_w, j), weight(y_s, j));
          yc[j] = Run<T>::all(weight(y_c, j));
        }
        RunPair<T> AB = RunPair<T>::all(0, 0);
        Run<T> C = Run<T>::zero(), dA = C, dB = C, dC = C;  // dB and dC including P and Q
        for (std::size_t k = 0; k < order; ++k) {
          RunPair<T> of_potential = RunPair<T>::all(0, 0), of_change = of_potential;
          Run<T> curved = Run<T>::zero();
          for (std::size_t j = 0; j < order; ++j) {
            const std::ptrdiff_t at = row_at[j] + plane_at[k];
            of_potential = fma(RunPair<T>::twice(potential + at), y[j], of_potential);
            curved = fma(Run<T>::load(potential + at), yc[j], curved);
            of_change = fma(RunPair<T>::twice(change + at), y[j], of_change);
          }
          const T zw = weight(z_w, k);
          const Run<T> z = Run<T>::all(zw), zs = Run<T>::all(weight(z_s, k));
          const Run<T> by_w = of_potential.first(), by_s = of_potential.second();
          const Run<T> change_by_w = of_change.first();
          AB = fma(of_potential, RunPair<T>::all(zw, zw), AB);
          C = fma(by_w, zs, C);
          dA = fma(change_by_w, z, dA);
          dB = fma(curved, z,
                   fma(by_s, Run<T>::all(weight(z_s_by_z, k)), fma(of_change.second(), z, dB)));
          dC = fma(change_by_w, zs,
                   fma(by_s, Run<T>::all(weight(z_s_by_y, k)),
                       fma(by_w, Run<T>::all(weight(z_c, k)), dC)));
        }
        T* const to = sums + lane * columns;
        AB.store(to), C.store(to + 2 * length);
        dA.store(to + 3 * length), dB.store(to + 4 * length), dC.store(to + 5 * length);
      }
      Real column[columns];
      for (std::size_t k = 0; k < columns; k += width)
        transpose<T>([&](std::size_t lane) { return Real::load(sums + lane * columns + k); },
                     column + k);
      Vec3<Real> field, change;
      for (std::size_t k = 0; k < order; ++k) {
        const Real A = column[k], B = column[length + k], C = column[2 * length + k];
        const Real dA = column[3 * length + k], dB = column[4 * length + k],
                   dC = column[5 * length + k];
        const Real wx = w[0][k], sx = s[0][k], along_x = v.x * sx;
        field += Vec3<Real>{sx * A, wx * B, wx * C};
        change += Vec3<Real>{sx * (dA + v.y * B + v.z * C) + v.x * c[0][k] * A,
                             wx * dB + along_x * B, wx * dC + along_x * C};
      }
      for (std::size_t d = 0; d < 3; ++d) {
        const double points = static_cast<double>(job.grid.points[d]);
        const Real factor(static_cast<T>(-job.bodies.charges[site] * points / job.box.edge[d]));
        field[d] = select(present, factor * field[d], Real());
        change[d] = select(present, factor * change[d], Real());
      }
      df += change;
      dtau += cross(places.arm(site), change) + cross(moves.arm(site), field);
    }
    add_to_records(std::array{df.x, df.y, df.z, dtau.x, dtau.y, dtau.z}, [&](std::size_t lane) {
      return job.sums + (slot + lane) * ChunkSums<T>::stride;
    });
  }
}

template <class T>
void spread_in_order(const SpreadDipolesJob<T>& job) {
  with_order(job.charges.order, [&]<int order>() { spread<T, order>(job); });
}
template <class T>
void gather_in_order(const GatherDerivativeJob<T>& job) {
  with_order(job.forces.order, [&]<int order>() { gather<T, order>(job); });
}

}  // namespace

void spread_dipoles(const SpreadDipolesJob<double>& job) { spread_in_order(job); }
void spread_dipoles(const SpreadDipolesJob<float>& job) { spread_in_order(job); }
void gather_derivative(const GatherDerivativeJob<double>& job) { gather_in_order(job); }
void gather_derivative(const GatherDerivativeJob<float>& job) { gather_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
