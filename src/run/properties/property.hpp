// SPDX-License-Identifier: MIT
// The properties that can be measured: each is a row with its definition.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/settings/quantity.hpp"
#include "polhode/base/units.hpp"
#include "polhode/model/topology.hpp"
#include "polhode/run/properties/measure.hpp"

namespace polhode {

/// Units that only properties have.
inline constexpr double cm3_per_mol =
    1e21 / units::avogadro;  ///< 1 cm³/mol as a volume per molecule [nm³]
inline constexpr double W_per_m_K = units::avogadro * 1e-24;  ///< [kJ/mol/(nm ps K)]
inline constexpr double nm2_per_ns = 1e-3;                    ///< 1e-9 m²/s [nm²/ps]

inline double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }
inline double in_kg_m3(double density) { return density / unit("kg/m3", Dimension::density); }

/// Quantities of the whole system that are averaged at constant pressure.
enum AverageOf : std::size_t {
  potential,  ///< potential energy U [kJ/mol]
  volume,     ///< volume V [nm³]
  potential_squared,
  volume_squared,
  potential_by_volume,
  dipole_squared,  ///< squared total dipole moment M² [e² nm²]
  averages_count,
  mean_pressure = averages_count,  ///< pressure [kJ/mol/nm³], only at constant volume
  averages_count_at_constant_volume
};

/// The smallest number of molecules of a system that is simulated. With fewer, fluctuations of the
/// volume would make the box too small for a cutoff that is longer than the diameter of a molecule.
inline constexpr std::size_t min_of_liquid = 32;

/// The conditions that determine the value of a property, besides averages.
struct PropertyConditions {
  StatePoint at;
  std::size_t molecules = 0;
  double mass = 0;  ///< total mass [u]
  /// Degrees of freedom of all motions of the molecules. The three of the centre of mass, which is
  /// at rest in a run, are included, as in a large system.
  double degrees_of_freedom = 0;
};

/// Sampling and scheme of averages in words.
inline std::string text_of(Sampling sampling, const std::string& scheme) {
  return (sampling == Sampling::hybrid_monte_carlo ? "hybrid Monte Carlo by " : "") + scheme;
}

/// The kind of run in which a property is measured.
enum class MeasuredIn {
  averages,    ///< runs at constant temperature, and at constant pressure or volume
  dynamics,    ///< runs at the density found there, with a weak rescaling of all momenta
  elongated,   ///< the same in the long box of OrthoBoXY, with three times as many molecules
  coupling,    ///< runs in which a molecule is coupled to all others in stages
  slab,        ///< runs of a slab of the liquid between its vapour, at constant volume
  conduction,  ///< dynamics with the heat flux
  pair         ///< no run: an integral over two molecules
};
/// Whether a kind of run is dynamics. Such runs keep the mean volume of the averages, so its error
/// is one of the property.
constexpr bool is_dynamics(MeasuredIn kind) {
  return kind == MeasuredIn::dynamics || kind == MeasuredIn::elongated ||
         kind == MeasuredIn::conduction;
}

/// The state points at which a property is defined.
enum class DefinedAt { any, constant_pressure, constant_volume };

struct Property {
  const char* name;  ///< name, such as "heat-capacity"
  const char* unit;  ///< unit, such as "J/mol/K"
  MeasuredIn measured_in;
  const char* definition;  ///< definition in a sentence
  const char* sources;     ///< keys of docs/references.bib
  /// Computes the value in `unit` from the means of averages; null for properties of other runs.
  double (*value)(std::span<const double> means, const PropertyConditions& conditions) = nullptr;
  DefinedAt at = DefinedAt::any;
  bool logarithmic = false;  ///< whether the logarithm of the value has the distribution of a mean,
                             ///< as variances have nearly
};

/// All properties, in the order of results.
std::span<const Property> properties();

/// Finds a property by its name.
/// @throws Error  if there is none of this name; the message suggests a name
const Property& property(std::string_view name);

/// Whether a site has a charge.
bool has_charges(const Molecule& molecule);
bool has_charges(const Topology& topology);

/// The reason why a system does not have a property; empty if it has the property.
std::string why_not(const Property& property, const Topology& topology,
                    const ForceSettings& forces);
/// The reason why a property is not defined at a state point; empty if it is.
std::string why_not(const Property& property, const StatePoint& at);

}  // namespace polhode
