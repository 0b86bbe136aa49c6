// SPDX-License-Identifier: MIT
// The directional derivatives of the spread and gather loops: charges on the grid, and forces from
// the potential there, differentiated along a displacement of the charges. They need one more
// derivative of the splines.
#include "mesh_charges.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Per unit of a displacement along v, in grid spacings, a charge q adds to a grid point at u
// q (v·∇) w_x w_y w_z = q [v_x s_x w_y w_z + w_x (v_y s_y w_z + w_y v_z s_z)], s the slopes of w.
enum Share { y_w, y_vs, z_w, z_vs, shares };

// One charge of a pack; x and dx are q w_x and q v_x s_x.
template <class T, std::size_t order>
[[gnu::always_inline]] inline void add_dipole(const SpreadJob<T>& job,
                                              const std::int32_t (&index)[3][Pack<T>::width],
                                              std::size_t lane, const Run<T>& x, const Run<T>& dx,
                                              const ChargeWeights<T, order, shares>& share) {
  T* const origin = job.grid.values.data() + index[0][lane];
  const std::ptrdiff_t* const row_at = job.grid.row_at.data() + index[1][lane];
  Run<T> y[order], dy[order];
  T* rows[order];
  for (std::size_t j = 0; j < order; ++j) {
    y[j] = Run<T>::all(share(y_w, j, lane));
    dy[j] = Run<T>::all(share(y_vs, j, lane));
    rows[j] = origin + row_at[j];
  }
  const std::ptrdiff_t* const plane_at = job.plane_at + index[2][lane];
  for (std::size_t k = 0; k < order; ++k) {
    const std::ptrdiff_t plane = plane_at[k];
    if (plane < 0) continue;
    const Run<T> z = Run<T>::all(share(z_w, k, lane)), dz = Run<T>::all(share(z_vs, k, lane));
    const Run<T> by_y = fma(x, dz, dx * z), by_dy = x * z;
    for (std::size_t j = 0; j < order; ++j)
      fma(by_y, y[j], fma(by_dy, dy[j], Run<T>::load(rows[j] + plane))).store(rows[j] + plane);
  }
}

template <class T, std::size_t order>
void spread(const SpreadDipolesJob<T>& dipoles) {
  using Real = Pack<T>;
  const SpreadJob<T>& job = dipoles.charges;
  constexpr std::size_t width = Real::width, stride = std::max(width, Run<T>::length);
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  GridPositions<T> moves(job.box, job.grid.points, job.bodies.charges.size());
  alignas(pack_bytes) T along_x[2][width * stride];  // q w and q v s
  ChargeWeights<T, order, shares> along;
  std::int32_t index[3][width];
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
          along.set(y_w + which, k, share[which][1][k]);
          along.set(z_w + which, k, share[which][2][k]);
        }
      }
      for (std::size_t lane = 0; lane < lanes; ++lane)
        add_dipole<T, order>(job, index, lane, Run<T>::load(along_x[0] + lane * stride),
                             Run<T>::load(along_x[1] + lane * stride), along);
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
enum Weight { w_y, s_y, vc_y, w_z, s_z, vc_z, s_z_by_y, s_z_by_z, weights };

// Around one charge, for each point along x: A, B, C, A', B' + P and C' + Q.
template <class T, std::size_t order>
[[gnu::always_inline]] inline void sum_over_rows(const GridPoints<T>& potential, const T* change,
                                                 const ChargeWeights<T, order, weights>& weight,
                                                 std::size_t lane, T* sums) {
  RunPair<T> y[order];  // w and s
  Run<T> yc[order];
  for (std::size_t j = 0; j < order; ++j) {
    y[j] = RunPair<T>::all(weight(w_y, j, lane), weight(s_y, j, lane));
    yc[j] = Run<T>::all(weight(vc_y, j, lane));
  }
  RunPair<T> AB = RunPair<T>::all(0, 0);
  Run<T> C = Run<T>::zero(), dA = C, dB = C, dC = C;
  for (std::size_t k = 0; k < order; ++k) {
    RunPair<T> of_potential = RunPair<T>::all(0, 0), of_change = of_potential;
    Run<T> curved = Run<T>::zero();
    for (std::size_t j = 0; j < order; ++j) {
      const std::ptrdiff_t at = potential.row_at[j] + potential.plane_at[k];
      of_potential = fma(RunPair<T>::twice(potential.values + at), y[j], of_potential);
      curved = fma(Run<T>::load(potential.values + at), yc[j], curved);
      of_change = fma(RunPair<T>::twice(change + at), y[j], of_change);
    }
    const T zw = weight(w_z, k, lane);
    const Run<T> z = Run<T>::all(zw), zs = Run<T>::all(weight(s_z, k, lane));
    const Run<T> by_w = of_potential.first(), by_s = of_potential.second();
    const Run<T> change_by_w = of_change.first();
    AB = fma(of_potential, RunPair<T>::all(zw, zw), AB);
    C = fma(by_w, zs, C);
    dA = fma(change_by_w, z, dA);
    dB = fma(curved, z,
             fma(by_s, Run<T>::all(weight(s_z_by_z, k, lane)), fma(of_change.second(), z, dB)));
    dC = fma(change_by_w, zs,
             fma(by_s, Run<T>::all(weight(s_z_by_y, k, lane)),
                 fma(by_w, Run<T>::all(weight(vc_z, k, lane)), dC)));
  }
  constexpr std::size_t length = Run<T>::length;
  AB.store(sums), C.store(sums + 2 * length);
  dA.store(sums + 3 * length), dB.store(sums + 4 * length), dC.store(sums + 5 * length);
}

// The gradient of the potential at a pack of charges, and its derivative.
template <class Real>
struct Gradient {
  Vec3<Real> value, change;

  // From the sums over rows, with the splines along x and the displacement v.
  template <std::size_t order>
  [[gnu::always_inline]] void sum_over_x(const Real* column, const Real (&w)[order],
                                         const Real (&s)[order], const Real (&c)[order],
                                         const Vec3<Real>& v) {
    constexpr std::size_t length = Run<typename Real::value_type>::length;
    for (std::size_t k = 0; k < order; ++k) {
      const Real A = column[k], B = column[length + k], C = column[2 * length + k];
      const Real dA = column[3 * length + k], dB = column[4 * length + k],
                 dC = column[5 * length + k];
      const Real along_x = v.x * s[k];
      value += Vec3<Real>{s[k] * A, w[k] * B, w[k] * C};
      change += Vec3<Real>{s[k] * (dA + v.y * B + v.z * C) + v.x * c[k] * A,
                           w[k] * dB + along_x * B, w[k] * dC + along_x * C};
    }
  }
};

template <class T, std::size_t order>
void gather(const GatherDerivativeJob<T>& derivative) {
  using Real = Pack<T>;
  const GatherJob<T>& job = derivative.forces;
  constexpr std::size_t width = Real::width;
  GridPositions<T> places(job.box, job.grid.points, job.bodies.charges.size());
  GridPositions<T> moves(job.box, job.grid.points, job.bodies.charges.size());
  ChargeWeights<T, order, weights> along;
  RowSums<T, 6> sums;
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
        along.set(w_y, k, w[1][k]), along.set(s_y, k, s[1][k]), along.set(vc_y, k, v.y * c[1][k]);
        along.set(w_z, k, w[2][k]), along.set(s_z, k, s[2][k]), along.set(vc_z, k, v.z * c[2][k]);
        along.set(s_z_by_y, k, v.y * s[2][k]), along.set(s_z_by_z, k, v.z * s[2][k]);
      }
      for (std::size_t lane = 0; lane < width; ++lane)
        sum_over_rows<T, order>({job.grid, index, lane},
                                derivative.derivative.values.data() + index[0][lane], along, lane,
                                sums.of(lane));
      Real column[RowSums<T, 6>::columns];
      sums.transpose_to(column);
      Gradient<Real> gradient;
      gradient.sum_over_x(column, w[0], s[0], c[0], v);
      const Vec3<Real> force = force_of(gradient.value, job, site, present),
                       change = force_of(gradient.change, job, site, present);
      df += change;
      dtau += cross(places.arm(site), change) + cross(moves.arm(site), force);
    }
    add_to_records(std::array{df.x, df.y, df.z, dtau.x, dtau.y, dtau.z}, [&](std::size_t lane) {
      return job.sums + (slot + lane) * ChunkSums<T>::stride;
    });
  }
}

template <class T>
void spread_in_order(const SpreadDipolesJob<T>& job) {
  with_order(job.charges.order, [&]<std::size_t order>() { spread<T, order>(job); });
}
template <class T>
void gather_in_order(const GatherDerivativeJob<T>& job) {
  with_order(job.forces.order, [&]<std::size_t order>() { gather<T, order>(job); });
}

}  // namespace

void spread_dipoles(const SpreadDipolesJob<double>& job) { spread_in_order(job); }
void spread_dipoles(const SpreadDipolesJob<float>& job) { spread_in_order(job); }
void gather_derivative(const GatherDerivativeJob<double>& job) { gather_in_order(job); }
void gather_derivative(const GatherDerivativeJob<float>& job) { gather_in_order(job); }

}  // namespace polhode::POLHODE_LOOPS
