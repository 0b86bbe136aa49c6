// SPDX-License-Identifier: MIT
// Names of force field settings, as in run files.
#pragma once

#include <array>

#include "polhode/base/enum_names.hpp"
#include "polhode/forces/laws/settings.hpp"

namespace polhode {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<Truncation> = {
    "molecule-switch", "site-switch", "site-shift"};

template <>
inline constexpr std::array<std::string_view, 4> enum_names<Electrostatics> = {
    "coulomb", "reaction-field", "pme", "damped-shifted-force"};

template <>
inline constexpr std::array<std::string_view, 2> enum_names<Precision> = {"double", "mixed"};

template <>
inline constexpr std::array<std::string_view, 2> enum_names<MixingRule> = {"lorentz-berthelot",
                                                                           "geometric"};

}  // namespace polhode
