// SPDX-License-Identifier: MIT
// Short-range laws that a file gives for pairs of atom types, translated to the sites of
// molecules.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "polhode/forces/laws/mixing.hpp"
#include "polhode/io/settings/text_place.hpp"

namespace polhode {

struct TypedSite {
  std::string name;  ///< "SOL.OW"
  std::string type;
  double epsilon;  ///< ε of the site [kJ/mol]
  ShortRangeLaw law{};
};

struct TypePair {
  std::string first, second;  ///< types, in either order
  double sigma = 0;           ///< [nm]
  double epsilon = 0;         ///< [kJ/mol]; negative: the pair cannot be expressed by sigma and
                              ///< epsilon
  TextPlace place;
  ShortRangeLaw law{};
};

/// The parameters of pairs of sites; if a pair is given twice, the last one applies.
/// @throws Error  if a pair of types cannot be translated to sites
std::vector<PairOverride> overrides(std::span<const TypedSite> sites,
                                    std::span<const TypePair> pairs);

}  // namespace polhode
