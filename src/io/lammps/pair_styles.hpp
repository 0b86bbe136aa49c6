// SPDX-License-Identifier: MIT
// The pair styles of LAMMPS whose parameters are read from data files.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

enum class LammpsLaw { lennard_jones, buckingham, mie };

/// The short-range potential of a LAMMPS pair style, with any accelerator suffix and any treatment
/// of charges. The potential is Lennard-Jones if no style is given, and empty for unsupported
/// styles.
std::optional<LammpsLaw> law_of_pair_style(std::string_view style);

}  // namespace polhode
