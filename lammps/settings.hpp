// SPDX-License-Identifier: MIT
// The arguments of fix polhode.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kinds.hpp"
#include "polhode/integrate/scheme.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace polhode::lammps {

/// The Ornstein-Uhlenbeck bath of the ensembles, in the units of LAMMPS.
struct LangevinArguments {
  double temperature = 0;
  double damping_time = 0;  ///< 1/γ of translation and rotation
  std::uint64_t seed = 0;
};

/// Particles of a type, each a molecule with the sites of a molecule file.
struct ParticleArguments {
  int type = 0;
  MoleculeFile file;
  std::string path;
};

struct FixSettings {
  Scheme scheme;      ///< with the stages of the bath, if there is one
  double lambda = 1;  ///< of finite differences: forces of other pair styles are not smooth
  double tolerance = default_tolerance;
  std::vector<bool> massless;  ///< [type]
  std::optional<LangevinArguments> langevin;
  std::vector<ParticleArguments> particles;
};

/// Settings without arguments.
FixSettings default_settings();

/// @param arguments  behind the style, `count` of them
/// @throws Error  with the argument that is wrong, or if the scheme needs what LAMMPS cannot do
FixSettings fix_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps);

}  // namespace polhode::lammps
