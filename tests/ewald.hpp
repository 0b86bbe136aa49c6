// SPDX-License-Identifier: MIT
// Electrostatics of a periodic box by direct Ewald summation over all pairs and wave vectors, in
// double precision, for any split of 1/r: the reference for the particle mesh. The boundary is
// conducting ("tin foil"), so there is no term for the dipole of the box [ewald1921].
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "forces/laws/ewald_split.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Ewald's split of 1/r with a Gaussian density of width 1/(√2 α). The short-range part u(r) =
/// erfc(α r)/r is positive at all r.
struct GaussianSplit {
  double alpha;  ///< [1/nm]

  RadialValue smooth(double r) const {
    const double gaussian = 2 * alpha / std::sqrt(units::pi) * std::exp(-alpha * alpha * r * r);
    if (alpha * r < 1e-4) return {smooth_at_zero(), 2 * alpha * alpha / 3 * smooth_at_zero()};
    const double u = std::erf(alpha * r) / r;
    return {u, (u - gaussian) / (r * r)};
  }
  RadialValue pair(double r) const {
    const double gaussian = 2 * alpha / std::sqrt(units::pi) * std::exp(-alpha * alpha * r * r);
    const double u = std::erfc(alpha * r) / r;
    return {u, (u + gaussian) / (r * r)};
  }
  double smooth_at_zero() const { return 2 * alpha / std::sqrt(units::pi); }
  TransformValue transform(double k) const {
    const double x = k * k / (4 * alpha * alpha), value = std::exp(-x);
    return {value, -2 * x * value};
  }
  /// The integral ∫ u dV over all space [nm²].
  double integral() const { return units::pi / (alpha * alpha); }
};

/// Point charges; those of one body are consecutive and belong to the same periodic image.
struct PointCharges {
  std::vector<Vec3<double>> r;    ///< [nm]
  std::vector<double> q;          ///< [e]
  std::vector<std::size_t> body;  ///< charges of the same body do not interact

  std::size_t size() const { return q.size(); }
};

/// The charged sites of all bodies of a state, body by body, in the order of InteractionSites.
PointCharges point_charges(const Topology& topology, const State& state);

/// The energies of an Ewald sum by term [kJ/mol].
struct EwaldEnergies {
  double pairs = 0;           ///< short-range part: pairs of different bodies, and a body with its
                              ///< images
  double reciprocal = 0;      ///< smooth part, summed over wave vectors
  double self = 0;            ///< self-energy: minus the smooth part of each charge with itself
  double intramolecular = 0;  ///< exclusions: minus the smooth part between charges of the same
                              ///< body
  double background = 0;      ///< of a net charge with the uniform neutralizing background
  double total() const { return pairs + reciprocal + self + intramolecular + background; }
};

struct EwaldSum {
  EwaldEnergies energy;
  std::vector<Vec3<double>> f;  ///< on each charge [kJ/mol/nm]
  /// −dE/dε for a strain ε that moves charges with the box [kJ/mol].
  Mat3<double> virial{};
};

/// Range of an Ewald sum: pairs closer than `cutoff` [nm], wave vectors shorter than `longest`
/// [1/nm].
struct EwaldRange {
  double cutoff;
  double k_max;
};

/// The reciprocal part of the sum alone, with its forces and virial.
template <class Split>
EwaldSum reciprocal_sum(const PointCharges& charges, const Box& box, const Split& split,
                        double k_max);

/// The complete sum.
template <class Split>
EwaldSum ewald_sum(const PointCharges& charges, const Box& box, const Split& split,
                   const EwaldRange& range);

}  // namespace polhode
