// SPDX-License-Identifier: MIT
// The pair styles of LAMMPS whose parameters are read from data files.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

enum class LammpsLaw { lennard_jones, buckingham, mie };

/// The short-range law of a style, with any accelerator suffix and any treatment of charges;
/// Lennard-Jones if no style is given; none for other styles.
std::optional<LammpsLaw> law_of_pair_style(std::string_view style);

}  // namespace polhode
