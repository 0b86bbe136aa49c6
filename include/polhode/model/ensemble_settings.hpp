// SPDX-License-Identifier: MIT
// What controls temperature and pressure of a run: settings only, for run files and for the
// thermostats and barostats of polhode/ensemble.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

enum class ThermostatKind {
  langevin,           ///< each momentum by itself [davidchack2009]
  rescaling,          ///< all momenta by one factor [bussi2007]
  separate_rescaling  ///< translation and rotation by a factor each
};

struct ThermostatSettings {
  ThermostatKind kind = ThermostatKind::langevin;
  double friction = 1;             ///< γ of translation, Langevin [1/ps]
  double rotational_friction = 1;  ///< γ of rotation, Langevin [1/ps]
  double time_constant = 0.5;      ///< τ of rescaling [ps]
  friend bool operator==(const ThermostatSettings&, const ThermostatSettings&) = default;
};

enum class BarostatKind {
  cell_rescaling,  ///< stochastic cell rescaling [bernetti2020]
  monte_carlo      ///< volume moves of random size
};

/// Edges of the box that are scaled by one factor: true for x, y, z.
using CoupledEdges = std::array<bool, 3>;

struct BarostatSettings {
  BarostatKind kind = BarostatKind::cell_rescaling;
  double pressure = 0;         ///< [kJ/mol/nm³]
  double time_constant = 2;    ///< τ of cell rescaling [ps]
  double compressibility = 0;  ///< isothermal, estimated: sets the size of moves [nm³ mol/kJ]
  double every = 0.1;          ///< between two moves [ps]
  /// A cell-rescaling move is accepted or rejected, so that the distribution is exact whatever the
  /// interval [roberts1996]; without, every move is accepted, as published.
  bool metropolis = true;
  std::vector<CoupledEdges> edges = {{true, true, true}};  ///< groups, moved in turn
  friend bool operator==(const BarostatSettings&, const BarostatSettings&) = default;
};

struct HybridMonteCarloSettings {
  std::size_t steps = 10;  ///< per trajectory between two decisions
  double refresh = 1;      ///< part of the momenta that is replaced by new ones; 1: all
  friend bool operator==(const HybridMonteCarloSettings&,
                         const HybridMonteCarloSettings&) = default;
};

/// None of them: constant energy.
struct EnsembleSettings {
  double temperature = 0;  ///< of all that follows [K]
  std::optional<ThermostatSettings> thermostat;
  std::optional<BarostatSettings> barostat;
  std::optional<HybridMonteCarloSettings> hybrid_monte_carlo;
  bool constant_energy() const { return !thermostat && !barostat && !hybrid_monte_carlo; }
  friend bool operator==(const EnsembleSettings&, const EnsembleSettings&) = default;
};

}  // namespace polhode
