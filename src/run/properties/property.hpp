// SPDX-License-Identifier: MIT
// The properties that can be measured: each is a row with its definition.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/model/topology.hpp"
#include "polhode/run/properties/measure.hpp"

namespace polhode {

/// Units that only properties have.
inline constexpr double cm3_per_mol = 1e21 / units::avogadro;  ///< of one molecule [nm³]
inline constexpr double nm2_per_ns = 1e-3;                     ///< 1e-9 m²/s [nm²/ps]

/// Quantities of the whole system that are averaged at constant pressure.
enum AverageOf : std::size_t {
  potential,  ///< U [kJ/mol]
  volume,     ///< V [nm³]
  potential_squared,
  volume_squared,
  potential_by_volume,
  dipole_squared,  ///< M² [e² nm²]
  averages_count
};

/// What the value of a property depends on besides its averages.
struct Conditions {
  StatePoint at;
  std::size_t molecules = 0;
  double mass = 0;                ///< of all [u]
  double degrees_of_freedom = 0;  ///< of all motions
};

/// The runs that a property is measured in.
enum class MeasuredIn {
  averages,  ///< constant temperature and pressure
  dynamics,  ///< the density found there, with a weak rescaling of all momenta
  pair       ///< none: an integral over two molecules
};

struct Property {
  const char* name;  ///< "heat-capacity"
  const char* unit;  ///< "J/mol/K"
  MeasuredIn measured_in;
  const char* definition;    ///< a sentence
  const char* sources;       ///< keys of docs/references.bib
  bool of_dipoles = false;   ///< whether molecules must have a dipole, and PME
  bool of_rotation = false;  ///< whether molecules must rotate
  /// From the means of averages, in `unit`; empty for other properties.
  double (*value)(std::span<const double> means, const Conditions& conditions) = nullptr;
};

/// All properties, in the order of results.
std::span<const Property> properties();

/// @throws Error  with a suggestion, if there is none of this name
const Property& property(std::string_view name);

/// Why a system does not have a property; empty if it has.
std::string why_not(const Property& property, const Topology& topology, bool has_mesh);

}  // namespace polhode
