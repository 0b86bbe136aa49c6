// SPDX-License-Identifier: MIT
// The path along which a molecule is coupled to all others: first its short-range potentials grow
// from nothing to their full size, then its charges.
#pragma once

#include "polhode/run/properties/measure.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// All stages from which a path can choose.
/// @param molecule  the molecule that is coupled
CouplingPath possible_stages(const Molecule& molecule);

/// A system in which the last molecule of the first kind is coupled to all others as in a stage.
/// Bodies keep their order.
System coupled(const System& whole, const CouplingStage& stage);

}  // namespace polhode
