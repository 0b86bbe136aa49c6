// SPDX-License-Identifier: MIT
// Long-range dispersion correction.
#pragma once

#include <vector>

#include "forces/laws/short_range.hpp"
#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The coefficient C in the long-range dispersion correction C/V [kJ/mol nm³]. The correction is
/// the energy of the short-range potentials that the switching function removes, for a uniform
/// density of sites: C = Σ 2π N_a N_b ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites
/// [allen2017, section 2.8]. Its virial is isotropic. The correction is meaningless for a shifted
/// potential, because the shift also changes the energy at short distances.
/// @throws Error  for a tabulated potential, which has no values at longer distances
double dispersion_tail(const Topology& topology, const ForceSettings& settings);

/// The Fourier transform v̂(k) = 4π ∫ (1 − w(r)) u(r) r² sin(kr)/(kr) dr of the part of a potential
/// that the switching function removes.
class TailTransform {
 public:
  TailTransform(const ForceSettings& settings, const ShortRange<double>& law);

  struct Mode {
    double value = 0;  ///< v̂(k) [kJ/mol nm³]
    double slope = 0;  ///< k dv̂/dk [kJ/mol nm³]
  };
  /// @param k  wavenumber, not 0 [1/nm]
  Mode at(double k) const;

  /// Whether two potentials are equal beyond the start of the switch.
  friend bool operator==(const TailTransform&, const TailTransform&) = default;

 private:
  std::vector<double> r_, value_;  // points of a quadrature, with (1 − w) u r² times their weights
};

}  // namespace polhode
