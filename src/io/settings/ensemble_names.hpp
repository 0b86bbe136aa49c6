// SPDX-License-Identifier: MIT
// Names and bounds of the settings of an ensemble, as in run files.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "polhode/base/enum_names.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<ThermostatKind> = {
    "langevin", "rescaling", "separate-rescaling"};

template <>
inline constexpr std::array<std::string_view, 2> enum_names<BarostatKind> = {"cell-rescaling",
                                                                             "monte-carlo"};

/// What is wrong with a friction [1/ps]; empty if nothing.
std::string wrong_friction(double rate);

/// Of one trajectory of hybrid Monte Carlo.
inline constexpr std::size_t max_hybrid_steps = 1'000'000;

/// That of liquid water [nm³ mol/kJ], and the range that is accepted.
double default_compressibility();
double min_compressibility();
double max_compressibility();

/// A barostat at a pressure [kJ/mol/nm³], with the compressibility of liquid water.
BarostatSettings default_barostat(double pressure = 0);

}  // namespace polhode
