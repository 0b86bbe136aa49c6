// SPDX-License-Identifier: MIT
#include "interactions.hpp"

#include <cmath>
#include <set>
#include <string>

#include "polhode/base/units.hpp"

namespace polhode::lammps {
namespace {

std::string name_of(std::size_t kind) { return "kind" + std::to_string(kind); }
std::string name_of_type(int type) { return "type" + std::to_string(type); }

ShortRangeLaw with_lengths_in_nm(ShortRangeLaw law, double nm) {
  if (auto* const exp6 = std::get_if<BuckinghamLaw>(&law)) {
    exp6->B /= nm;
    exp6->C *= std::pow(nm, 6);
  }
  return law;
}

}  // namespace

double PairUnits::charge() const { return std::sqrt(coulomb * nm / units::coulomb); }

std::vector<Molecule> interacting_molecules(const std::vector<Kind>& kinds,
                                            const KindCharges& charges,
                                            const PairCoefficients& coefficients,
                                            const PairUnits& units) {
  std::vector<Molecule> molecules;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    Molecule molecule = kinds[k].molecule;
    molecule.name = name_of(k);
    for (std::size_t s = 0; s < molecule.sites.size(); ++s) {
      Site& site = molecule.sites[s];
      const int type = kinds[k].types[s];
      site.name = name_of_type(type);
      site.r = units.nm * site.r;
      site.charge = units.charge() * charges[k][s];
      site.sigma = site.epsilon = coefficients.is_used(type) ? 1 : 0;
    }
    molecules.push_back(std::move(molecule));
  }
  return molecules;
}

Mixing explicit_pairs(const std::vector<Kind>& kinds, const PairCoefficients& coefficients,
                      const PairUnits& units) {
  struct TypeOfKind {
    std::size_t kind;
    int type;
  };
  std::vector<TypeOfKind> all;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const int type : std::set<int>(kinds[k].types.begin(), kinds[k].types.end()))
      if (coefficients.is_used(type)) all.push_back({k, type});
  Mixing mixing;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a; b < all.size(); ++b) {
      const PairCoefficients::Values values = coefficients(all[a].type, all[b].type);
      mixing.pairs.push_back({name_of(all[a].kind) + '.' + name_of_type(all[a].type),
                              name_of(all[b].kind) + '.' + name_of_type(all[b].type),
                              units.nm * values.sigma, values.epsilon,
                              with_lengths_in_nm(values.law, units.nm)});
    }
  return mixing;
}

}  // namespace polhode::lammps
