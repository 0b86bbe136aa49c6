// SPDX-License-Identifier: MIT
// Run files: TOML, with units for all quantities. The full description of a run or a study, in
// internal units.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/enum_names.hpp"
#include "polhode/base/vec3.hpp"
#include "polhode/forces/laws/settings.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/io/settings/overlay.hpp"
#include "polhode/io/settings/requirement.hpp"
#include "polhode/io/topology/topology_file.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

struct SystemSettings {
  struct Component {
    std::string model;              ///< name of a model, or path of a molecule file
    std::optional<Molecule> own{};  ///< molecule of the component, if the run file defines it
    std::size_t count = 0;          ///< number of molecules; 0: as in the initial configuration
  };
  std::vector<Component> molecules;
  TopologySettings topology;        ///< topology file, as an alternative to `molecules`
  std::optional<double> density;    ///< density of the start lattice [u/nm³]
  std::optional<Vec3<double>> box;  ///< box edges, if there is no initial configuration [nm]
  double temperature = 297;         ///< temperature of initial velocities, and of a thermostat [K]
  /// Whether velocities are drawn. If false, the initial configuration must have velocities. If
  /// this setting is not given, velocities are drawn unless the initial configuration contains
  /// velocities.
  std::optional<bool> new_velocities{};
  std::uint64_t seed = 1;
  /// Path of a coordinate file, or "w512" for the built-in configuration. If empty, molecules are
  /// placed on a lattice.
  std::string initial_configuration;
  /// Path of a checkpoint that stores the initial configuration at full precision; may be empty.
  std::string checkpoint{};
};

/// The molecule of a component, which the run file or a built-in model defines.
/// @throws Error  if the model does not exist
Molecule molecule_of(const SystemSettings::Component& component);

struct IntegratorSettings {
  NamedScheme scheme = "hoa2";
  /// Accuracy for which the adviser chooses the time step, and also the scheme if the run file
  /// gives no scheme. May be empty.
  std::optional<Requirement> accuracy;
  /// Schemes from which the adviser chooses.
  std::vector<NamedScheme> candidates = {"velocity-verlet", "hoa2", "bcss3", "gier4-fd"};
  double step = 0.002;  ///< time step [ps]
  /// Displacement factor λ of the finite-difference gradient [vanzon2008, Eq. 6]. The default is
  /// 1e-4 in double precision, and 1 in mixed precision, because 1/λ amplifies the round-off of the
  /// forces. The order of a scheme does not depend on λ.
  double lambda = 1e-4;
};

struct RunSettings {
  bool minimise = false;   ///< whether the energy is minimised before the run
  double equilibrate = 0;  ///< length of the equilibration with velocity rescaling [ps]
  double length = 15;      ///< length of the trajectory [ps]
  double sample = 0.004;   ///< interval between samples of the energies [ps]
  /// Interval between samples of the shadow energy [ps]; 0 for no samples. By default, the interval
  /// is 100 steps for schemes that have a shadow energy.
  std::optional<double> shadow_sample;
  double configurational_sample = 0;  ///< interval between samples of configurational temperatures
                                      ///< [ps]; 0: none
};

/// Lengths of the equilibration stages of polhode prepare.
struct PreparationSettings {
  double nvt = 20;   ///< length at constant volume [ps]
  double npt = 100;  ///< length of the NPT stage after it, if there is a barostat [ps]
};

struct OutputSettings {
  std::string prefix = "polhode-run";  ///< prefix of all output files
  double trajectory_every = 0.1;       ///< interval between frames [ps]; 0: no trajectory
  std::vector<std::string> formats = {"xyz", "gro"};
  bool massless_sites = true;     ///< whether to write massless sites to trajectories
  bool velocities = true;         ///< whether to write velocities, if the format has them
  bool pressure_tensor = false;   ///< whether the energies file has the pressure tensor
  bool processed = false;         ///< whether samples are read through a postprocessor
  std::string plot = "svg";       ///< format of figures: "svg", "png" or "none"
  double checkpoint_every = 300;  ///< interval between checkpoints in wall-clock time [s]

  FrameChoice choice() const {
    return {massless_sites ? MasslessSites::keep : MasslessSites::omit, velocities};
  }
};

/// The ensemble for the averages that a study measures.
enum class StudyEnsemble : std::uint8_t {
  nve,  ///< constant energy: accuracy is measured by the energy fluctuation ratio R
  nvt   ///< constant temperature: accuracy is measured by the bias of averages
};

template <>
inline constexpr std::array<std::string_view, 2> enum_names<StudyEnsemble> = {"nve", "nvt"};

struct StudySettings {
  std::vector<NamedScheme> schemes = {"velocity-verlet", "hoa2", "gier4"};
  std::vector<double> steps;  ///< time steps [ps]; empty: a default list for each scheme
  bool coarse = false;        ///< whether the default list has fewer steps
  StudyEnsemble ensemble = StudyEnsemble::nve;
  int runs = 10;                      ///< number of independent initial configurations per point
  double length = 15;                 ///< length of each run [ps]
  double decorrelate = 10;            ///< length of the equilibration with new momenta [ps]
  double configurational_sample = 0;  ///< interval between samples of configurational temperatures
                                      ///< [ps]; 0: none
};

/// Schemes that the run file names: the name of each, and its text such as "mine: B(1/2) A(1)
/// B(1/2)".
using OwnSchemes = std::map<std::string, std::string, std::less<>>;

struct Config {
  SystemSettings system;
  ForceSettings forces;
  IntegratorSettings integrator;
  RunSettings run;
  PreparationSettings prepare;
  OutputSettings output;
  StudySettings study;
  OwnSchemes schemes;
  EnsembleSettings ensemble;         ///< settings of thermostat, barostat and hybrid Monte Carlo
  std::string source;                ///< path of the run file, or "default"
  std::string text;                  ///< text of the run file as read; its hash identifies outputs
  std::vector<std::string> notes{};  ///< notes on settings that the overlay implies

  /// A setting as written in the run file.
  struct Given {
    std::string value;  ///< value as written, such as "\"1 nm\""
    std::string place;  ///< place of the setting, such as "water.toml:9, forces.cutoff"
  };
  std::map<std::string, Given, std::less<>> given;  ///< settings by path: "forces.cutoff"

  bool gives(std::string_view path) const { return given.contains(path); }
  /// The place of a setting for error messages. If the setting has its default, the result is the
  /// source of the run file.
  const std::string& place(std::string_view path) const {
    const auto found = given.find(path);
    return found == given.end() ? source : found->second.place;
  }
};

/// Value of λ in mixed precision: the default, which is also the smallest accepted value.
inline constexpr double lambda_in_mixed = 1, min_lambda_in_mixed = 0.1;

/// Reads and checks a run file. Relative paths in the file are relative to its folder.
/// @param overlay  settings that override the file; a message about such a setting names its option
/// @throws Error  with file, line and key; also if the file name has control characters
Config read_config(const std::string& path, const Overlay& overlay = {});

/// Parses the text of a run file; `file` is the file name in error messages.
Config parse_config(std::string_view text, const std::string& file, const Overlay& overlay = {});

/// The settings of the default run: 512 TIP4P waters from the built-in configuration.
Config default_config(const Overlay& overlay = {});

}  // namespace polhode
