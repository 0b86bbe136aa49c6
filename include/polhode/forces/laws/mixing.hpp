// SPDX-License-Identifier: MIT
// The short-range law of two sites: mixed from their own by a rule, or given explicitly.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/short_range.hpp"

namespace polhode {

struct Topology;

enum class MixingRule {
  lorentz_berthelot,  ///< arithmetic mean of σ, geometric mean of ε
  geometric,          ///< geometric means of σ and ε
};

/// Explicit parameters for two sites, instead of the result of the mixing rule.
struct PairOverride {
  std::string first, second;  ///< The two sites in either order, each as molecule and site name:
                              ///< "tip4p.OW" means all sites of that name.
  double sigma = 0;           ///< diameter of Lennard-Jones and Mie laws [nm]
  double epsilon = 0;         ///< well depth of Lennard-Jones and Mie laws [kJ/mol]; 0 for no
                              ///< interaction
  ShortRangeLaw law{};
};

struct Mixing {
  MixingRule rule = MixingRule::lorentz_berthelot;
  std::vector<PairOverride> pairs;
};

/// @throws Error  if an override names an unknown site or a site without a short-range law, occurs
///   twice, or has a number out of its domain
void check(const Mixing& mixing, const Topology& topology);

/// The mixing rule and overrides as text, such as "geometric mixing; tip4p.OW with argon.Ar: sigma
/// 0.33 nm, epsilon 0.8 kJ/mol". Empty for the default.
std::string description(const Mixing& mixing);

}  // namespace polhode
