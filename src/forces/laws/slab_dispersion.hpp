// SPDX-License-Identifier: MIT
// Long-range dispersion of a system whose density depends on z.
#pragma once

#include <complex>
#include <vector>

#include "forces/laws/tail.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// The energy of the short-range potentials that the switching function removes, for sites whose
/// density depends on z alone:
///   E = 1/(2V) Σ_k Σ_ab v̂_ab(k) ρ_a(−k) ρ_b(k),  ρ_a(k) = Σ exp(ikz) over the sites of a kind,
/// with the wavenumbers k = 2πn/L_z. The sum over planes of [janecek2006] is the same energy in
/// real space. The mode k = 0 is dispersion_tail(), which is not included here. Forces are exact
/// derivatives of the energy for any number of modes, so energy is conserved.
class SlabDispersion {
 public:
  /// @throws Error  for a tabulated potential, which has no values at longer distances
  SlabDispersion(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Adds forces and torques; with `energies` also energy and virial.
  void add(const State& state, Load& load, bool energies);
  /// Adds the virials of the bodies along each axis [kJ/mol]. Each site of a pair has half of the
  /// virial of the pair, and a body has the part f_z z of the arms z of its own sites.
  void add_virials(const State& state, Vec3Column& virials);
  /// Adds the derivative of forces and torques along a displacement, see
  /// ForceField::directional_derivative().
  void add_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                      Load& slope);

 private:
  using Complex = std::complex<double>;
  /// Equal sites of all bodies of a kind of molecule.
  struct Kind {
    std::size_t first, count;  // bodies
    Vec3<double> place;        // in the body frame
  };
  /// A quantity of each kind and mode, with the modes of a kind in succession.
  using Modes = std::vector<Complex>;

  template <class Site>
  void each_site(const State& state, const Site& site) const;
  template <class Add>
  void each_mode(double z, const Add& add) const;
  void densities(const State& state);
  Modes potentials_of(const Modes& densities,
                      double TailTransform::Mode::*of = &TailTransform::Mode::value) const;
  double energy_at(const Modes& potentials, std::size_t kind, double z) const;
  double slope_at(const Modes& potentials, std::size_t kind, double z) const;
  void add_energies(Load& load, const Modes& potentials, double moments) const;

  Box box_;
  double k1_;  // the smallest wavenumber [1/nm]
  std::size_t modes_;
  std::vector<Kind> kinds_;
  std::vector<TailTransform::Mode> transforms_;  // of each pair of kinds and mode
  Modes densities_;
};

}  // namespace polhode
