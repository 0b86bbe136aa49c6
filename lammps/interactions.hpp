// SPDX-License-Identifier: MIT
// The kinds of molecules in a LAMMPS input, with charges and short-range potentials in the form
// that the library needs. Lengths are in nm, and energies in the unit of the input.
#pragma once

#include <cstddef>
#include <vector>

#include "kinds.hpp"
#include "polhode/forces/laws/mixing.hpp"

namespace polhode::lammps {

/// Parameters of all pairs of atom types, in LAMMPS units.
class PairCoefficients {
 public:
  struct Values {
    double epsilon = 0, sigma = 0;
    ShortRangeLaw law{};
    bool is_zero() const { return polhode::is_zero(epsilon, law); }
  };
  PairCoefficients() = default;
  explicit PairCoefficients(int types)
      : types_(static_cast<std::size_t>(types) + 1), values_(types_ * types_) {}
  Values& operator()(int i, int j) { return values_[at(i) * types_ + at(j)]; }
  const Values& operator()(int i, int j) const { return values_[at(i) * types_ + at(j)]; }
  /// Whether a type has a short-range interaction with any type.
  bool is_used(int type) const {
    for (std::size_t j = 1; j < types_; ++j)
      if (!values_[at(type) * types_ + j].is_zero()) return true;
    return false;
  }

 private:
  static std::size_t at(int type) { return static_cast<std::size_t>(type); }
  std::size_t types_ = 0;
  std::vector<Values> values_;
};

/// Charges of the sites of each kind [e].
using KindCharges = std::vector<std::vector<double>>;

/// Conversion from LAMMPS units.
struct PairUnits {
  double nm = 1;          ///< unit of length [nm]
  double coulomb = 1;     ///< energy of two unit charges at a unit distance
  double charge() const;  ///< The charge in the library [e] that stands for a unit charge, so that
                          ///< the library's energy K q q is correct.
};

/// The kinds as molecules with interactions. explicit_pairs() gives the potentials of
/// pairs, which replace any parameters of sites.
std::vector<Molecule> interacting_molecules(const std::vector<Kind>& kinds,
                                            const KindCharges& charges,
                                            const PairCoefficients& coefficients,
                                            const PairUnits& units);

/// The parameters of all pairs of sites with short-range potentials.
Mixing explicit_pairs(const std::vector<Kind>& kinds, const PairCoefficients& coefficients,
                      const PairUnits& units);

}  // namespace polhode::lammps
