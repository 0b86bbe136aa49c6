// SPDX-License-Identifier: MIT
// What controls temperature and pressure of a run: settings only, for run files and for the
// thermostats and barostats of polhode/ensemble.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace polhode {

/// Thermostats each momentum separately [davidchack2009].
struct Langevin {
  double friction = 1;             ///< γ of translation [1/ps]
  double rotational_friction = 1;  ///< γ of rotation [1/ps]
  friend bool operator==(const Langevin&, const Langevin&) = default;
};

/// Rescales all momenta by one factor [bussi2007].
struct Rescaling {
  double time_constant = 0.5;  ///< τ [ps]
  friend bool operator==(const Rescaling&, const Rescaling&) = default;
};

/// Rescales translation and rotation separately.
struct SeparateRescaling {
  double time_constant = 0.5;  ///< τ of both [ps]
  friend bool operator==(const SeparateRescaling&, const SeparateRescaling&) = default;
};

using ThermostatSettings = std::variant<Langevin, Rescaling, SeparateRescaling>;

/// Edges of the box that are scaled by one factor: true for x, y, z.
using CoupledEdges = std::array<bool, 3>;

/// Stochastic cell rescaling [bernetti2020].
struct CellRescaling {
  double time_constant = 2;  ///< τ of the volume [ps]
  /// Moves are accepted or rejected, so the distribution is exact for any interval [roberts1996].
  /// If false, every move is accepted, as published.
  bool metropolis = true;
  friend bool operator==(const CellRescaling&, const CellRescaling&) = default;
};

/// Volume moves of random size, accepted or rejected.
struct VolumeMoves {
  friend bool operator==(const VolumeMoves&, const VolumeMoves&) = default;
};

using BoxMoves = std::variant<CellRescaling, VolumeMoves>;

struct BarostatSettings {
  BoxMoves type{};
  double pressure = 0;         ///< [kJ/mol/nm³]
  double compressibility = 0;  ///< isothermal, estimated: sets the size of moves [nm³ mol/kJ]
  double every = 0.1;          ///< time between two moves [ps]
  std::vector<CoupledEdges> edges = {{true, true, true}};  ///< groups, moved in turn
  friend bool operator==(const BarostatSettings&, const BarostatSettings&) = default;
};

struct HybridMonteCarloSettings {
  std::size_t steps = 10;  ///< steps per trajectory, between two decisions
  double refresh = 1;      ///< part of the momenta that is replaced by new ones; 1: all
  friend bool operator==(const HybridMonteCarloSettings&,
                         const HybridMonteCarloSettings&) = default;
};

/// Settings of an ensemble; without thermostat, barostat and hybrid Monte Carlo constant energy.
struct EnsembleSettings {
  double temperature = 0;  ///< temperature of all settings below [K]
  std::optional<ThermostatSettings> thermostat;
  std::optional<BarostatSettings> barostat;
  std::optional<HybridMonteCarloSettings> hybrid_monte_carlo;
  bool constant_energy() const { return !thermostat && !barostat && !hybrid_monte_carlo; }
  friend bool operator==(const EnsembleSettings&, const EnsembleSettings&) = default;
};

}  // namespace polhode
