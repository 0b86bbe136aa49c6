// SPDX-License-Identifier: MIT
// Run files: TOML, quantities with units. Everything a run or a study needs, in internal units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/forces/settings.hpp"
#include "polhode/io/frame_file.hpp"
#include "polhode/io/topology_file.hpp"

namespace polhode {

struct SystemSettings {
  struct Component {
    std::string model;      ///< name of a model, or path of a molecule file
    std::size_t count = 0;  ///< 0: as many as the start configuration holds
  };
  std::vector<Component> molecules;
  TopologySettings topology;        ///< in place of `molecules`
  std::optional<double> density;    ///< [u/nm³], without a start configuration
  std::optional<Vec3<double>> box;  ///< [nm], without a start configuration
  double temperature = 297;         ///< [K]
  std::uint64_t seed = 1;
  /// Path of a coordinate file; "w512" is the one within the program; empty: lattice.
  std::string start;
};

struct IntegratorSettings {
  std::string scheme = "hoa2";  ///< name, or stages as text
  bool scheme_given = false;
  /// R that the run is to keep [1]; then the adviser chooses the step, and the scheme if none is
  /// given.
  std::optional<double> accuracy;
  /// Schemes from which the adviser chooses, names or texts.
  std::vector<std::string> candidates = {"velocity-verlet", "hoa2", "bcss3", "gier4-fd"};
  double step = 0.002;  ///< [ps]
  /// Of the finite-difference gradient (vanzon2008, Eq. 6). Without a word 1e-4 in double
  /// precision, and 1 in mixed: rounding of the forces enters divided by lambda, while the order of
  /// a scheme does not depend on it.
  double lambda = 1e-4;
  bool lambda_given = false;
  std::string lambda_place;  ///< "water.toml:12, integrator.lambda"
};

struct RunSettings {
  double equilibrate = 0;  ///< [ps], with velocity rescaling
  double length = 15;      ///< [ps]
  double sample = 0.004;   ///< between samples of the energies [ps]
  /// Between those of the shadow energy [ps]; 0: none; without a word a hundred steps, where the
  /// scheme has one.
  std::optional<double> shadow_sample;
  double configurational_sample = 0;  ///< of configurational temperatures [ps]; 0: none
};

struct OutputSettings {
  std::string prefix = "polhode-run";  ///< of all output files
  double trajectory_every = 0.1;       ///< [ps]; 0: no trajectory
  std::vector<std::string> formats = {"xyz", "gro"};
  bool massless_sites = true;     ///< in trajectories
  bool velocities = true;         ///< in trajectories, where the format has them
  std::string plot = "svg";       ///< "svg", "png" or "none"
  double checkpoint_every = 300;  ///< [s] of wall-clock time

  FrameChoice choice() const {
    return {massless_sites ? MasslessSites::kept : MasslessSites::left_out, velocities};
  }
};

struct StudySettings {
  std::vector<std::string> schemes = {"velocity-verlet", "hoa2", "gier4"};
  std::vector<double> steps;          ///< [ps]; empty: a ladder per scheme
  bool coarse = false;                ///< a ladder with fewer steps
  int runs = 10;                      ///< independent starts per point
  double length = 15;                 ///< of each run [ps]
  double decorrelate = 10;            ///< preparation of each start from new momenta [ps]
  double configurational_sample = 0;  ///< of configurational temperatures [ps]; 0: none
};

struct Config {
  SystemSettings system;
  ForceSettings forces;
  IntegratorSettings integrator;
  RunSettings run;
  OutputSettings output;
  StudySettings study;
  std::string source;         ///< path of the file, or "default"
  std::string text;           ///< as read: its hash names outputs
  bool mixing_given = false;  ///< whether the file has a mixing rule
  std::string cutoff_place;   ///< "water.toml:9, forces.cutoff": only the box tells if it fits
};

/// The smallest lambda that is accepted in mixed precision.
inline constexpr double least_lambda_in_mixed = 0.1;

/// Sets the precision of a run, as an option in place of the run file's word does, and a lambda
/// that suits it where the run file has none.
/// @throws Error  if the run file's lambda is below the least one for mixed precision
void set_precision(Config& config, Precision precision);

/// Reads and checks a run file. A relative path in it is relative to the file.
/// @throws Error  with file, line and key
Config read_config(const std::string& path);

/// The run that the text of a run file describes; `file` is its name in errors.
Config parse_config(std::string_view text, const std::string& file);

/// The default run: 512 TIP4P waters from the configuration within the program.
Config default_config();

}  // namespace polhode
