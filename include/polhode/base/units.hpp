// SPDX-License-Identifier: MIT
// The unit system of the program: nm, ps, u, e, K, kJ/mol. These units are consistent (1 kJ/mol = 1
// u nm²/ps²), so no conversion factor appears in any formula. Values in other units are converted
// once, in src/io.
#pragma once

namespace polhode::units {

// CODATA 2018. The first three constants are exact by definition of the SI.
inline constexpr double avogadro = 6.02214076e23;                // 1/mol
inline constexpr double boltzmann = 1.380649e-26 * avogadro;     // kJ/mol/K
inline constexpr double elementary_charge = 1.602176634e-19;     // C
inline constexpr double vacuum_permittivity = 8.8541878128e-12;  // F/m
inline constexpr double pi = 3.14159265358979323846;

/// Coulomb's constant 1/(4 π ε₀) [kJ/mol nm/e²].
inline constexpr double coulomb =
    elementary_charge * elementary_charge * avogadro / (4 * pi * vacuum_permittivity) * 1e6;

/// One gram per cubic centimetre [u/nm³]: 10⁻²¹ g/nm³ divided by the unified mass unit in grams.
inline constexpr double gram_per_cm3 = avogadro * 1e-21;

}  // namespace polhode::units
