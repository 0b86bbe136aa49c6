// SPDX-License-Identifier: MIT
// The short-range potential of two sites: mixed by a rule from the potentials of both sites, or
// given explicitly.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/short_range.hpp"

namespace polhode {

struct Topology;

/// Explicit parameters for two sites, instead of the result of the mixing rule.
struct PairOverride {
  std::string first, second;  ///< The two sites in either order, each as molecule and site name:
                              ///< "tip4p.OW" means all sites of that name.
  double sigma = 0;           ///< diameter of Lennard-Jones and Mie potentials [nm]
  double epsilon = 0;         ///< well depth of Lennard-Jones and Mie potentials [kJ/mol]; 0 for no
                              ///< interaction
  ShortRangeLaw law{};
};

struct Mixing {
  MixingRule rule = MixingRule::lorentz_berthelot;
  std::vector<PairOverride> pairs;
};

/// @throws Error  if an override occurs twice, has a number out of its domain, or names an unknown
///   site or a site without a short-range potential
void check(const Mixing& mixing, const Topology& topology);

/// The mixing rule and overrides as text, such as "geometric mixing; tip4p.OW with argon.Ar: sigma
/// 0.33 nm, epsilon 0.8 kJ/mol". Empty for the default.
std::string description(const Mixing& mixing);

}  // namespace polhode
