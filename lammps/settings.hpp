// SPDX-License-Identifier: MIT
// The arguments of fix polhode.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kinds.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace polhode::lammps {

/// The types of baths: the Ornstein-Uhlenbeck flow, and stochastic velocity rescaling.
enum class BathType { langevin, rescale };

/// The arguments of the bath, in LAMMPS units.
struct BathArguments {
  BathType type = BathType::langevin;
  double temperature = 0;
  double time_constant = 0;  ///< 1/γ of translation and rotation, or the time constant τ
  std::uint64_t seed = 0;
  std::optional<double> last{};  ///< temperature at the end of each run, which the temperature
                                 ///< approaches linearly; empty if it is constant
};

/// The arguments of the barostat, stochastic cell rescaling, in LAMMPS units.
struct BarostatArguments {
  double pressure = 0;
  double time_constant = 0;
  double compressibility = 0;  ///< estimated isothermal compressibility
  std::uint64_t every = 10;    ///< steps of the scheme between two moves of the box
  std::vector<CoupledEdges> edges = {
      {true, true, true}};  ///< groups of coupled edges; each move scales one group, in turn
};

/// The arguments for particles of a type. Each particle is a molecule with the sites of a molecule
/// file.
struct ParticleArguments {
  int type = 0;
  MoleculeFile file;
  std::string path;
};

struct FixSettings {
  Scheme scheme =
      scheme_of("velocity-verlet");  ///< scheme, including the stages of an optional bath
  double lambda = 1;  ///< displacement factor of finite differences; it is large because forces of
                      ///< other pair styles are not smooth
  double tolerance = default_tolerance;
  std::vector<bool> massless;  ///< for each atom type, whether its atoms are massless
  std::optional<BathArguments> bath;
  std::optional<BarostatArguments> barostat;
  std::vector<ParticleArguments> particles;
};

/// Reads the settings of the fix.
/// @param arguments  the `count` arguments that follow the style
/// @throws Error  with the invalid argument, or if the scheme needs features that LAMMPS does not
///   have
FixSettings fix_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps);

}  // namespace polhode::lammps
