// SPDX-License-Identifier: MIT
// The second virial coefficient of rigid molecules.
#pragma once

#include <functional>

#include "polhode/base/workers.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// Computes the second virial coefficient B(T) = −½ ∫ (⟨exp(−u/kT)⟩ − 1) 4π r² dr [nm³] without any
/// cutoff [allen2017, section 2.2], with the standard error of the integration. Up to 4 nm between
/// the centres, orientations are averaged by quasi-Monte Carlo with random shifts. At
/// longer distances, the leading terms of dipoles and of dispersion are integrated.
/// @param temperature  temperature [K]
/// @param points       number of orientations for each of 16 random shifts
/// @param stop         ends the computation if it returns true; the value is then not finite
Estimate second_virial(const Molecule& molecule, const Mixing& mixing, double temperature,
                       std::size_t points = 4096, Workers& workers = Workers::serial(),
                       const std::function<bool()>& stop = {});

}  // namespace polhode
