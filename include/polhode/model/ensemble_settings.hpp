// SPDX-License-Identifier: MIT
// Settings of temperature and pressure control, for run files and for the thermostats and barostats
// of polhode/ensemble. Each type of thermostat and barostat has a title, and a name as in run
// files.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace polhode {

/// Langevin thermostat, which acts on each momentum separately [davidchack2009].
struct Langevin {
  static constexpr std::string_view name = "langevin", title = "Langevin thermostat";
  double friction = 1;             ///< friction γ of translation [1/ps]
  double rotational_friction = 1;  ///< friction γ of rotation [1/ps]
  friend bool operator==(const Langevin&, const Langevin&) = default;
};

/// Stochastic velocity rescaling, with one factor for all momenta [bussi2007].
struct Rescaling {
  static constexpr std::string_view name = "rescaling", title = "stochastic velocity rescaling";
  double time_constant = 0.5;  ///< time constant τ [ps]
  friend bool operator==(const Rescaling&, const Rescaling&) = default;
};

/// Stochastic velocity rescaling with separate factors for translation and rotation.
struct SeparateRescaling {
  static constexpr std::string_view name = "separate-rescaling";
  static constexpr std::string_view title =
      "separate stochastic velocity rescaling of translation and rotation";
  double time_constant = 0.5;  ///< time constant τ of both factors [ps]
  friend bool operator==(const SeparateRescaling&, const SeparateRescaling&) = default;
};

using ThermostatSettings = std::variant<Langevin, Rescaling, SeparateRescaling>;

/// Whether a common factor scales the box edge, for each of the edges along x, y and z.
using CoupledEdges = std::array<bool, 3>;

/// Barostat by stochastic cell rescaling [bernetti2020].
struct CellRescaling {
  static constexpr std::string_view name = "cell-rescaling", title = "stochastic cell rescaling";
  double time_constant = 2;  ///< time constant τ of the volume [ps]
  /// Whether moves can be rejected, which makes the distribution exact for any interval
  /// [roberts1996]. If false, every move is accepted, as in the published method.
  bool metropolis = true;
  friend bool operator==(const CellRescaling&, const CellRescaling&) = default;
};

/// Monte Carlo barostat: volume moves of random size, which are accepted or rejected.
struct VolumeMoves {
  static constexpr std::string_view name = "monte-carlo", title = "Monte Carlo moves";
  friend bool operator==(const VolumeMoves&, const VolumeMoves&) = default;
};

using BoxMoves = std::variant<CellRescaling, VolumeMoves>;

struct BarostatSettings {
  BoxMoves type{};
  double pressure = 0;         ///< target pressure [kJ/mol/nm³]
  double compressibility = 0;  ///< estimated isothermal compressibility, which sets the size of
                               ///< moves [nm³ mol/kJ]
  double every = 0.1;          ///< time between two moves [ps]
  std::vector<CoupledEdges> edges = {
      {true, true, true}};  ///< groups of coupled edges; each move scales one group, in turn
  friend bool operator==(const BarostatSettings&, const BarostatSettings&) = default;
};

struct HybridMonteCarloSettings {
  std::size_t steps = 10;  ///< steps of each trajectory, which is then accepted or rejected
  double refresh = 1;      ///< fraction of the momenta that is replaced by new momenta; 1 replaces
                           ///< all
  friend bool operator==(const HybridMonteCarloSettings&,
                         const HybridMonteCarloSettings&) = default;
};

/// Settings of an ensemble. Without a thermostat, barostat or hybrid Monte Carlo, the ensemble has
/// constant energy.
struct EnsembleSettings {
  double temperature = 0;  ///< target temperature of thermostat, barostat and hybrid Monte Carlo
                           ///< [K]
  std::optional<ThermostatSettings> thermostat;
  std::optional<BarostatSettings> barostat;
  std::optional<HybridMonteCarloSettings> hybrid_monte_carlo;
  bool constant_energy() const { return !thermostat && !barostat && !hybrid_monte_carlo; }
  friend bool operator==(const EnsembleSettings&, const EnsembleSettings&) = default;
};

}  // namespace polhode
