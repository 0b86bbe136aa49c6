// SPDX-License-Identifier: MIT
// A direct computation of forces, over every pair of molecules and every periodic image within
// range, without neighbour list and packs. The pair loops are tested against the direct
// computation. With dual numbers, the direct computation gives exact derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "forces/pairs/molecule_pair.hpp"
#include "math/dual.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Position and orientation of a body. With dual numbers, position and orientation also contain the
/// displacement of the body.
template <class Real>
struct Pose {
  Vec3<Real> q;
  Quaternion<Real> orientation;
};

template <class Real>
struct ReferenceLoad {
  std::vector<Vec3<Real>> f, tau;
  Mat3<Real> virial;
  Real van_der_waals{0.0}, coulomb{0.0};
  Real potential() const { return van_der_waals + coulomb; }
};

template <CutoffTreatment treatment, class Real>
ReferenceLoad<Real> all_pairs_load(const Topology& topology, const ForceSettings& settings,
                                   const Box& box, const std::vector<Pose<Real>>& poses) {
  const std::size_t n = poses.size();
  const PairLaws<> laws(settings);
  const PairTables tables(topology, settings.mixing);
  const Bodies bodies(topology);
  std::vector<std::vector<Site>> sites;
  for (const auto& part : topology.parts) sites.push_back(InteractionSites(part.molecule).sites);

  std::vector<std::vector<Vec3<Real>>> arms(n);
  for (std::size_t i = 0; i < n; ++i)
    for (const Site& site : sites[bodies.part[i]])
      arms[i].push_back(
          to_lab(poses[i].orientation, Vec3<Real>{Real(site.r.x), Real(site.r.y), Real(site.r.z)}));

  ReferenceLoad<Real> load{std::vector<Vec3<Real>>(n), std::vector<Vec3<Real>>(n), {}};
  const Vec3<Real> edge{Real(box.edge.x), Real(box.edge.y), Real(box.edge.z)};
  const auto nearest = [](Real x) {  // rounds to the nearest integer, which is a constant in
                                     // derivatives
    double k = 0;
    while (x > Real(k + 0.5)) k += 1;
    while (x < Real(k - 0.5)) k -= 1;
    return Real(k);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const PairTable& table = tables(bodies.part[i], bodies.part[j]);
      const AnyShape<4> shape(table);
      const double range = std::max(settings.cutoff, cutoff_of_charges(settings)) +
                           topology.parts[bodies.part[i]].molecule.extent() +
                           topology.parts[bodies.part[j]].molecule.extent();
      Vec3<Real> R0 = poses[j].q - poses[i].q;
      R0 -= Vec3<Real>{nearest(R0.x / edge.x) * edge.x, nearest(R0.y / edge.y) * edge.y,
                       nearest(R0.z / edge.z) * edge.z};
      for (int image = 0; image < 27; ++image) {
        const Vec3<Real> shift{Real(image % 3 - 1), Real(image / 3 % 3 - 1), Real(image / 9 - 1)};
        const Vec3<Real> R = R0 + scaled(shift, edge);
        if (norm2(R) > Real(range * range)) continue;
        const PairLoad<Real> pair = molecule_pair<treatment, true>(
            shape, table.any_law<double>(), laws, R, [&](std::size_t k) { return arms[i][k]; },
            [&](std::size_t k) { return arms[j][k]; });
        load.f[i] -= pair.f;
        load.f[j] += pair.f;
        if (topology.parts[bodies.part[i]].molecule.extent() > 0) load.tau[i] += pair.tau_a(R);
        load.tau[j] += pair.tau_b;
        for (std::size_t k = 0; k < 3; ++k) load.virial[k] += R[k] * pair.f;
        load.van_der_waals += pair.van_der_waals;
        load.coulomb += pair.coulomb;
      }
    }
  return load;
}

/// Computes forces, torques, energies and virial of all pairs by a direct sum, as a reference for
/// tests. For PME, only the pairs within the cutoff are included. The cost grows with the square of
/// the number of bodies.
template <class Real>
ReferenceLoad<Real> reference_load(const Topology& topology, const ForceSettings& settings,
                                   const Box& box, const std::vector<Pose<Real>>& poses) {
  switch (cutoff_treatment(settings)) {
    case CutoffTreatment::molecule_switch:
      return all_pairs_load<CutoffTreatment::molecule_switch>(topology, settings, box, poses);
    case CutoffTreatment::site_switch:
      return all_pairs_load<CutoffTreatment::site_switch>(topology, settings, box, poses);
    case CutoffTreatment::smooth:
      return all_pairs_load<CutoffTreatment::smooth>(topology, settings, box, poses);
    default:
      return all_pairs_load<CutoffTreatment::site_shift>(topology, settings, box, poses);
  }
}

/// Computes the derivative of the reference forces and torques along a displacement: centres move
/// by dq, and orientations rotate by dtheta in the body frame.
inline Load reference_derivative(const Topology& topology, const ForceSettings& settings,
                                 const State& state, const Vec3Column& dq,
                                 const Vec3Column& dtheta) {
  std::vector<Pose<Dual<double>>> poses(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> a = state.orientation[i];
    const Vec3<double> v = dtheta[i];
    const Quaternion<double> da = scaled(a * Quaternion<double>{0, v.x, v.y, v.z}, 0.5);
    poses[i] = {dual(state.q[i], dq[i]), {{a.w, da.w}, {a.x, da.x}, {a.y, da.y}, {a.z, da.z}}};
  }
  const ReferenceLoad<Dual<double>> exact = reference_load(topology, settings, state.box, poses);
  Load derivative(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    derivative.f.set(i, slope(exact.f[i]));
    derivative.tau.set(i, slope(exact.tau[i]));
  }
  derivative.van_der_waals = exact.van_der_waals.slope;
  derivative.coulomb = exact.coulomb.slope;
  for (std::size_t k = 0; k < 3; ++k) derivative.virial[k] = slope(exact.virial[k]);
  return derivative;
}

}  // namespace polhode
