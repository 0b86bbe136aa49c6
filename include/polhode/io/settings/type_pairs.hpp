// SPDX-License-Identifier: MIT
// Short-range potentials that a file gives for pairs of atom types, translated to the sites of
// molecules.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "polhode/forces/laws/mixing.hpp"
#include "polhode/io/settings/text_place.hpp"

namespace polhode {

struct TypedSite {
  std::string name;  ///< molecule and site: "SOL.OW"
  std::string type;
  double epsilon;  ///< ε of the site [kJ/mol]
  ShortRangeLaw law{};
};

struct TypePair {
  std::string first, second;  ///< atom types of the pair, in either order
  double sigma = 0;           ///< diameter σ of the pair [nm]
  double epsilon = 0;  ///< well depth [kJ/mol]; negative if no σ and ε give the interaction
  TextPlace place;
  ShortRangeLaw law{};
};

/// Translates the parameters of pairs of atom types to pairs of sites.
/// @throws Error  if a pair of types cannot be translated to sites, or is given twice with
/// different
///   parameters
std::vector<PairOverride> overrides(std::span<const TypedSite> sites,
                                    std::span<const TypePair> pairs);

}  // namespace polhode
