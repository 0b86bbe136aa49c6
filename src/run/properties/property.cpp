// SPDX-License-Identifier: MIT
#include "run/properties/property.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/suggest.hpp"
#include "io/settings/quantity.hpp"
#include "model/dipole.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

using Means = std::span<const double>;

double kT(const PropertyConditions& c) { return units::boltzmann * c.at.temperature; }
double per_molecule(double x, const PropertyConditions& c) {
  return x / static_cast<double>(c.molecules);
}

/// The covariance of the volume with the configurational part U + pV of the enthalpy. The kinetic
/// part is independent of the volume.
double covariance_with_volume(Means m, const PropertyConditions& c) {
  return m[potential_by_volume] - m[potential] * m[volume] +
         c.at.pressure * (m[volume_squared] - m[volume] * m[volume]);
}
double variance_of_enthalpy(Means m, const PropertyConditions& c) {
  const double p = c.at.pressure;
  return m[potential_squared] - m[potential] * m[potential] +
         2 * p * (m[potential_by_volume] - m[potential] * m[volume]) +
         p * p * (m[volume_squared] - m[volume] * m[volume]);
}

double density(Means m, const PropertyConditions& c) { return in_kg_m3(c.mass / m[volume]); }
double molar_volume(Means m, const PropertyConditions& c) {
  return per_molecule(m[volume], c) / cm3_per_mol;
}
double potential_energy(Means m, const PropertyConditions& c) {
  return per_molecule(m[potential], c);
}
/// The pressure at constant volume. In a run, the centre of mass is at rest, so the kinetic part
/// lacks one of N molecules.
double pressure_of_all(Means m, const PropertyConditions& c) {
  return m[mean_pressure] + kT(c) / m[volume];
}
double enthalpy(Means m, const PropertyConditions& c) {
  const double p = c.at.constant_volume() ? pressure_of_all(m, c) : c.at.pressure;
  return per_molecule(m[potential] + c.degrees_of_freedom / 2 * kT(c) + p * m[volume], c);
}
double pressure(Means m, const PropertyConditions& c) { return in_bar(pressure_of_all(m, c)); }
double enthalpy_of_vaporization(Means m, const PropertyConditions& c) {
  return kT(c) - per_molecule(m[potential] + c.at.pressure * m[volume], c);
}
/// The heat capacity from the variance of the configurational part of the energy or the enthalpy.
double heat_capacity_of(double variance, const PropertyConditions& c) {
  const double configurational = variance / (kT(c) * c.at.temperature);  // [kJ/mol/K]
  return 1000 * per_molecule(configurational + c.degrees_of_freedom / 2 * units::boltzmann, c);
}
double heat_capacity(Means m, const PropertyConditions& c) {
  return heat_capacity_of(variance_of_enthalpy(m, c), c);
}
double isochoric_heat_capacity(Means m, const PropertyConditions& c) {
  return heat_capacity_of(m[potential_squared] - m[potential] * m[potential], c);
}
double expansivity(Means m, const PropertyConditions& c) {
  return 1e6 * covariance_with_volume(m, c) / (kT(c) * c.at.temperature * m[volume]);
}
double compressibility(Means m, const PropertyConditions& c) {
  return 1e6 * (m[volume_squared] - m[volume] * m[volume]) / (kT(c) * m[volume]) /
         unit("1/bar", Dimension::compressibility);
}
double dielectric_constant(Means m, const PropertyConditions& c) {
  return 1 + 4 * units::pi * units::coulomb * m[dipole_squared] / (3 * m[volume] * kT(c));
}

using In = MeasuredIn;
using At = DefinedAt;

constexpr std::array all = {
    Property{"density", "kg/m3", In::averages,
             "mass over the mean volume at constant temperature and pressure", "allen2017", density,
             At::constant_pressure},
    Property{"molar-volume", "cm3/mol", In::averages, "mean volume of a mole of molecules",
             "allen2017", molar_volume, At::constant_pressure},
    Property{"potential-energy", "kJ/mol", In::averages,
             "mean intermolecular energy per molecule, with the dispersion correction", "allen2017",
             potential_energy},
    Property{"enthalpy", "kJ/mol", In::averages,
             "mean potential and kinetic energy of rigid molecules, plus pressure times volume",
             "allen2017", enthalpy},
    Property{"enthalpy-of-vaporization", "kJ/mol", In::averages,
             "enthalpy of an ideal gas of the rigid molecules, minus the enthalpy of the liquid; "
             "without "
             "polarization, vibration or quantum terms",
             "horn2004", enthalpy_of_vaporization, At::constant_pressure},
    Property{"heat-capacity", "J/mol/K", In::averages,
             "heat capacity at constant pressure of classical rigid molecules, from the "
             "fluctuations of the enthalpy",
             "allen2017", heat_capacity, At::constant_pressure, true},
    Property{"expansivity", "1e-6/K", In::averages,
             "isobaric thermal expansivity, from the covariance of volume and enthalpy",
             "allen2017", expansivity, At::constant_pressure},
    Property{"compressibility", "1e-6/bar", In::averages,
             "isothermal compressibility, from the fluctuations of the volume", "allen2017",
             compressibility, At::constant_pressure, true},
    Property{"pressure", "bar", In::averages,
             "mean pressure at constant volume, with the dispersion correction", "allen2017",
             pressure, At::constant_volume},
    Property{"isochoric-heat-capacity", "J/mol/K", In::averages,
             "heat capacity at constant volume of classical rigid molecules, from the fluctuations "
             "of the potential energy",
             "allen2017", isochoric_heat_capacity, At::constant_volume, true},
    Property{"dielectric-constant", "", In::averages,
             "static dielectric constant, from the fluctuations of the total dipole with "
             "conducting surroundings",
             "neumann1983", dielectric_constant, At::any, true},
    Property{"diffusion", "1e-9 m2/s", In::dynamics,
             "self-diffusion coefficient of an infinite system, from the slope of the mean-square "
             "displacement; the Yeh-Hummer correction uses the viscosity of the same runs; in a "
             "mixture, of the first kind of molecule",
             "yeh2004"},
    Property{"viscosity", "mPa s", In::dynamics,
             "shear viscosity by the Green-Kubo relation, from the spectrum of five components of "
             "the molecular pressure tensor at zero frequency",
             "toraman2025"},
    Property{
        "thermal-conductivity", "W/m/K", In::conduction,
        "thermal conductivity of rigid molecules by the Green-Kubo relation, from the spectrum "
        "of the heat flux at zero frequency; of a pure substance",
        "evans1989"},
    Property{"diffusion-orthoboxy", "1e-9 m2/s", In::elongated,
             "self-diffusion coefficient of an infinite system, from the mean-square displacements "
             "along the short axes of a box with Lz/Lx = Lz/Ly = 2.7933596497, where the "
             "finite-size correction vanishes; in a mixture, of the first kind of molecule",
             "busch2023"},
    Property{"viscosity-orthoboxy", "mPa s", In::elongated,
             "shear viscosity from the difference of the diffusion coefficients along the axes of "
             "the same box",
             "busch2023"},
    Property{"rotational-relaxation", "ps", In::dynamics,
             "integral of the P2 reorientation function (second Legendre polynomial) of the "
             "slowest molecular axis",
             "allen2017"},
    Property{"coordination-number", "", In::dynamics,
             "mean number of molecules of the same kind around a molecule, with centres closer "
             "than the first minimum of their radial distribution function; in a mixture, of the "
             "first kind",
             "allen2017"},
    Property{"chemical-potential", "kJ/mol", In::coupling,
             "residual chemical potential of the first kind of molecule, relative to an ideal gas "
             "of the same density, by coupling one molecule to all others in stages",
             "bennett1976"},
    Property{"solvation-free-energy", "kJ/mol", In::coupling,
             "free energy of the transfer of one molecule, the solute, from an ideal gas into the "
             "liquid, at equal number densities of the solute",
             "bennett1976"},
    Property{"vapour-pressure", "bar", In::coupling,
             "pressure at which the vapour, with its second virial coefficient, has the chemical "
             "potential of the liquid; for pure substances far below the critical temperature",
             "bennett1976", nullptr, At::constant_pressure, true},
    Property{"surface-tension", "mN/m", In::slab,
             "tension of the two surfaces of a slab of the liquid in its vapour, from the "
             "pressures normal and parallel to them",
             "janecek2006"},
    Property{"saturated-liquid-density", "kg/m3", In::slab,
             "density of the liquid in the middle of the slab, in coexistence with its vapour",
             "janecek2006"},
    Property{"saturated-vapour-density", "kg/m3", In::slab,
             "density of the vapour in coexistence with the slab", "janecek2006"},
    Property{"saturation-pressure", "bar", In::slab,
             "pressure normal to the surfaces of the slab, which is the pressure of its vapour",
             "janecek2006"},
    Property{"second-virial-coefficient", "cm3/mol", In::pair,
             "integral of the Mayer function of two molecules, times −1/2, without a cutoff",
             "allen2017"}};

bool is_ion(const Molecule& molecule) { return std::abs(molecule.charge()) > 1e-9; }

/// The reason why the first kind of molecule cannot be coupled in stages; empty if it can.
std::string why_not_coupled(const Topology& topology) {
  const Molecule& molecule = topology.parts.front().molecule;
  if (topology.size() < 2) return "there is no other molecule";
  if (is_ion(molecule))
    return fmt::format(
        "'{}' has a charge of {:g} e, and the free energy of an ion depends on the size of the box",
        molecule.name, molecule.charge());
  if (std::ranges::none_of(molecule.sites, &Site::has_short_range))
    return fmt::format("'{}' has no short-range potential, without which its charges collapse",
                       molecule.name);
  for (const Site& site : molecule.sites)
    if (std::holds_alternative<TabulatedLaw>(site.law))
      return fmt::format("site '{}.{}' has a tabulated potential, whose distances cannot be scaled",
                         molecule.name, site.name);
  return "";
}

}  // namespace

bool has_charges(const Molecule& molecule) {
  return std::ranges::any_of(molecule.sites, [](const Site& site) { return site.charge != 0; });
}

bool has_charges(const Topology& topology) {
  return std::ranges::any_of(topology.parts,
                             [](const auto& part) { return has_charges(part.molecule); });
}

std::span<const Property> properties() { return all; }

const Property& property(std::string_view name) {
  const auto found = std::ranges::find_if(all, [&](const Property& p) { return name == p.name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Property& p : all) names.emplace_back(p.name);
  const std::string near = did_you_mean(std::string(name), names);
  throw Error(fmt::format(
      "there is no property '{}'{}", name,
      near.empty() ? "; there are " + fmt::format("{}", fmt::join(names, ", ")) : near));
}

std::string why_not(const Property& p, const Topology& topology, const ForceSettings& forces) {
  const std::string_view name = p.name;
  const bool has_mesh = forces.electrostatics == Electrostatics::pme;
  const auto any = [&](const auto& has) {
    return std::ranges::any_of(topology.parts,
                               [&](const auto& part) { return has(part.molecule); });
  };
  if (name == "dielectric-constant" && any(is_ion))
    return "the total dipole of ions is not defined in a periodic box";
  if (name == "dielectric-constant" && !any(has_dipole)) return "no molecule has a dipole";
  if (name == "dielectric-constant" && !has_mesh)
    return "this property requires electrostatics = \"pme\"";
  if (name == "solvation-free-energy" && topology.parts.front().count > 1)
    return fmt::format(
        "the first kind of molecule is the solute, and there are {} of '{}'; give the option "
        "solute",
        topology.parts.front().count, topology.parts.front().molecule.name);
  if (name == "vapour-pressure" && topology.parts.size() > 1)
    return "the vapour of a mixture differs in composition from the liquid";
  if (p.measured_in == MeasuredIn::conduction && forces.slab_dispersion)
    return "the heat flux does not include slab_dispersion; use dispersion_correction";
  if (p.measured_in == MeasuredIn::conduction && topology.parts.size() > 1)
    return "the heat flux of a mixture needs the partial enthalpies of all kinds of molecules";
  if (p.measured_in == MeasuredIn::coupling) return why_not_coupled(topology);
  if (p.measured_in == MeasuredIn::slab && !has_mesh && has_charges(topology))
    return "charges attract each other across a surface beyond any cutoff; this property requires "
           "electrostatics = \"pme\"";
  if (name == "rotational-relaxation" && !any([](const Molecule& m) { return m.top != Top::atom; }))
    return "atoms do not rotate";
  if (p.measured_in == MeasuredIn::pair && any(is_ion))
    return "the potential of two ions decays as 1/r, so the integral over their distance diverges";
  if (p.measured_in == MeasuredIn::pair && topology.parts.size() > 1)
    return "a mixture has one coefficient for each pair of molecules; measure each pair separately";
  // Half of the box edge is then below 1.65 mean distances of molecules.
  constexpr std::size_t min_molecules = 36;
  if (name == "coordination-number" && topology.size() < min_molecules)
    return fmt::format(
        "the box of {} molecules ends before the first minimum of g(r); give at "
        "least {} molecules",
        topology.size(), min_molecules);
  if (name == "coordination-number" && topology.parts.front().count < 2)
    return "there is only one molecule of the first kind";
  if (name == "enthalpy-of-vaporization" && topology.parts.size() > 1)
    return "the vapour of a mixture differs in composition from the liquid";
  return "";
}

std::string why_not(const Property& p, const StatePoint& at) {
  if (p.at == DefinedAt::constant_pressure && at.constant_volume())
    return fmt::format(
        "it requires constant pressure, but the density given in '{}' fixes the volume; give a "
        "pressure in place of the density",
        at.text());
  if (p.at == DefinedAt::constant_volume && !at.constant_volume())
    return fmt::format(
        "it requires constant volume, but '{}' has a pressure; give a density in place of the "
        "pressure, as in \"{:g} K, 1 g/cm3\"",
        at.text(), at.temperature);
  return "";
}

}  // namespace polhode
