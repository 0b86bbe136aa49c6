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
    std::optional<Molecule> own{};  ///< the molecule itself, if the run file defines it
    std::size_t count = 0;          ///< 0: as many as the initial configuration contains
  };
  std::vector<Component> molecules;
  TopologySettings topology;        ///< alternative to `molecules`
  std::optional<double> density;    ///< [u/nm³], if there is no initial configuration
  std::optional<Vec3<double>> box;  ///< [nm], if there is no initial configuration
  double temperature = 297;         ///< [K]
  /// Whether velocities are drawn; if false, the initial configuration must have them; empty: drawn
  /// unless it has some.
  std::optional<bool> new_velocities{};
  std::uint64_t seed = 1;
  /// Path of a coordinate file; "w512" is the built-in one; empty: lattice.
  std::string initial_configuration;
  /// Path of a checkpoint with the state of the initial configuration at full precision; empty:
  /// none.
  std::string checkpoint{};
};

/// The molecule of a component: its own, or the molecule of its model.
/// @throws Error  if there is no such model
Molecule molecule_of(const SystemSettings::Component& component);

struct IntegratorSettings {
  NamedScheme scheme = "hoa2";
  /// If set, the adviser chooses the step, and the scheme unless one is given.
  std::optional<Requirement> accuracy;
  /// Schemes that the adviser chooses from.
  std::vector<NamedScheme> candidates = {"velocity-verlet", "hoa2", "bcss3", "gier4-fd"};
  double step = 0.002;  ///< [ps]
  /// Displacement of the finite-difference gradient [vanzon2008, Eq. 6]. The default is 1e-4 in
  /// double precision, and 1 in mixed precision, because 1/lambda amplifies the rounding of the
  /// forces. The order of a scheme does not depend on it.
  double lambda = 1e-4;
};

struct RunSettings {
  bool minimise = false;   ///< the energy of the initial configuration, before all else
  double equilibrate = 0;  ///< [ps], with velocity rescaling
  double length = 15;      ///< [ps]
  double sample = 0.004;   ///< interval between samples of the energies [ps]
  /// Interval between samples of the shadow energy [ps]; 0: none; default: 100 steps, for schemes
  /// that have a shadow energy.
  std::optional<double> shadow_sample;
  double configurational_sample = 0;  ///< interval of configurational temperatures [ps]; 0: none
};

/// Lengths of the parts of a preparation.
struct PreparationSettings {
  double nvt = 20;   ///< length at constant volume [ps]
  double npt = 100;  ///< length at constant pressure after it, with a barostat [ps]
};

struct OutputSettings {
  std::string prefix = "polhode-run";  ///< prefix of all output files
  double trajectory_every = 0.1;       ///< [ps]; 0: no trajectory
  std::vector<std::string> formats = {"xyz", "gro"};
  bool massless_sites = true;     ///< writes massless sites to trajectories
  bool velocities = true;         ///< writes velocities to trajectories, if the format has them
  std::string plot = "svg";       ///< "svg", "png" or "none"
  double checkpoint_every = 300;  ///< interval in wall-clock time [s]

  FrameChoice choice() const {
    return {massless_sites ? MasslessSites::keep : MasslessSites::omit, velocities};
  }
};

/// The ensemble whose averages a study measures.
enum class StudyEnsemble : std::uint8_t {
  nve,  ///< accuracy is R, of energy conservation
  nvt   ///< accuracy is the bias of canonical averages
};

template <>
inline constexpr std::array<std::string_view, 2> enum_names<StudyEnsemble> = {"nve", "nvt"};

struct StudySettings {
  std::vector<NamedScheme> schemes = {"velocity-verlet", "hoa2", "gier4"};
  std::vector<double> steps;  ///< [ps]; empty: a default ladder per scheme
  bool coarse = false;        ///< a ladder with fewer steps
  StudyEnsemble ensemble = StudyEnsemble::nve;
  int runs = 10;                      ///< independent initial configurations per point
  double length = 15;                 ///< length of each run [ps]
  double decorrelate = 10;            ///< equilibration of each initial configuration after drawing
                                      ///< new momenta [ps]
  double configurational_sample = 0;  ///< interval of configurational temperatures [ps]; 0: none
};

/// Schemes with names given in the run file: name, and text such as "mine: B(1/2) A(1) B(1/2)".
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
  EnsembleSettings ensemble;         ///< thermostat, barostat, hybrid Monte Carlo
  std::string source;                ///< path of the file, or "default"
  std::string text;                  ///< text as read; its hash identifies outputs
  std::vector<std::string> notes{};  ///< notes on what an overlay selected by default

  /// A setting as the run file has it.
  struct Given {
    std::string value;  ///< value as written, "\"1 nm\""
    std::string place;  ///< "water.toml:9, forces.cutoff"
  };
  std::map<std::string, Given, std::less<>> given;  ///< settings by path, such as "forces.cutoff"

  bool gives(std::string_view path) const { return given.contains(path); }
  /// The place of a setting, for errors; the source if it has its default.
  const std::string& place(std::string_view path) const {
    const auto found = given.find(path);
    return found == given.end() ? source : found->second.place;
  }
};

/// A text with the names of such schemes, alone or on either side of a slash, replaced by their
/// texts.
std::string with_own_schemes(const std::string& text, const OwnSchemes& own);

/// Reason why the temperature of a run is invalid; empty if it is valid. 0 K needs a
/// thermostat.
std::string wrong_temperature(const Config& config);

/// Default of lambda in mixed precision, and the smallest accepted value.
inline constexpr double lambda_in_mixed = 1, min_lambda_in_mixed = 0.1;

/// Sets the precision of a run, overriding the run file, and a suitable lambda if the run file has
/// none.
/// @throws Error  if the run file's lambda is too small for mixed precision
void set_precision(Config& config, Precision precision);

/// Reads and checks a run file. A relative path in it is relative to the file.
/// @param overlay  settings that override the file; the place of an error names the option
/// @throws Error  with file, line and key; also if its name has control characters
Config read_config(const std::string& path, const Overlay& overlay = {});

/// Parses the text of a run file; `file` is its name in errors.
Config parse_config(std::string_view text, const std::string& file, const Overlay& overlay = {});

/// The default run: 512 TIP4P waters from the built-in configuration.
Config default_config(const Overlay& overlay = {});

}  // namespace polhode
