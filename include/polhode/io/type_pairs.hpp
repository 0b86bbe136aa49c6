// SPDX-License-Identifier: MIT
// Lennard-Jones parameters that a file gives for pairs of atom types, said of the sites of
// molecules.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "polhode/forces/mixing.hpp"
#include "polhode/io/text_place.hpp"

namespace polhode {

struct TypedSite {
  std::string name;  ///< "SOL.OW"
  std::string type;
  double epsilon;  ///< of its own [kJ/mol]
};

struct TypePair {
  std::string first, second;  ///< types, in either order
  double sigma = 0;           ///< [nm]
  double epsilon = 0;         ///< [kJ/mol]; negative: no sigma and epsilon say what is given
  TextPlace place;
};

/// What the pairs mean for the sites.
/// @throws Error  if a pair cannot be said of sites, or is given twice with other parameters
std::vector<PairOverride> overrides(std::span<const TypedSite> sites,
                                    std::span<const TypePair> pairs);

}  // namespace polhode
