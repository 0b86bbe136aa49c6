// SPDX-License-Identifier: MIT
// A system as input for LAMMPS: a data file of atom_style full in units real, and the pair
// potentials. The pair potentials are tables, or commands for pair_style polhode.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The mass of massless sites in data files [u], because LAMMPS requires a mass above 0.
inline constexpr double lammps_massless = 1e-20;

/// The atom types of a topology. Equal sites of a molecule share a type.
class LammpsTypes {
 public:
  struct Type {
    std::size_t part;  ///< index of the part of the topology
    Site site;
    std::string name;  ///< name such as "tip4p.OW"
  };
  /// Assigns types to sites.
  /// @param share  whether equal sites share a type; false for mixing rules with exceptions for
  ///   single sites
  LammpsTypes(const Topology& topology, bool share);
  const std::vector<Type>& types() const { return types_; }
  /// The number of the type of a site, counted from 1.
  int number(std::size_t part, std::size_t site) const { return numbers_[part][site]; }

 private:
  std::vector<Type> types_;
  std::vector<std::vector<int>> numbers_;  // type numbers by [part][site]
};

/// Writes the data file, including velocities, with enough digits that positions read back differ
/// only by round-off. Bonds of zero strength join the sites of a molecule, so that LAMMPS excludes
/// the interactions between them. Lennard-Jones parameters are included if all sites have a
/// Lennard-Jones potential.
void write_lammps_data(std::ostream& out, const std::string& title, const State& state,
                       const Topology& topology, const LammpsTypes& types);

/// Writes the data file of a system with one particle per molecule, in atom_style atomic. The types
/// of particles are numbered after the types of the sites. The orientations and angular momenta of
/// particles are in a section for `fix property/atom`.
void write_lammps_particles(std::ostream& out, const std::string& title, const State& state,
                            const Topology& topology, const LammpsTypes& types);
inline constexpr std::string_view lammps_particle_section = "Orientations";

/// Writes the molecule file of a part, with the molecule in its principal frame.
void write_lammps_molecule(std::ostream& out, const Topology& topology, std::size_t part,
                           const LammpsTypes& types);

/// The number of distances in a table. The distances of a table are equally spaced in r² from
/// lammps_table_start to the cutoff [nm].
inline constexpr std::size_t lammps_table_size = 20000;
inline constexpr double lammps_table_start = 0.03;

/// A molecule with a single site of a given type. The pair table of two molecules with one site
/// each has one pair, which follows from the mixing rule or an exception.
Molecule lone_site(const LammpsTypes::Type& type, const Topology& topology, double charge);

/// Writes the tables of all interacting pairs of types, for pair_style table.
/// @return  name of the section for each pair of types i ≤ j, empty if they do not interact
/// @throws Error  if the settings truncate between centres of mass, which is not possible with
///   tables
std::vector<std::string> write_lammps_tables(std::ostream& out, const Topology& topology,
                                             const ForceSettings& settings,
                                             const LammpsTypes& types, bool charges);

/// The force settings as a line of an input script, for pair_style polhode in units real.
std::string lammps_pair_style(const ForceSettings& settings);

/// Writes the Lennard-Jones parameters of all pairs of types, as lines of an input script in units
/// real.
/// @throws Error  if a pair has another potential
void write_lammps_pair_coefficients(std::ostream& out, const Topology& topology,
                                    const ForceSettings& settings, const LammpsTypes& types);

/// The argument of the LAMMPS command `dielectric` that reproduces polhode's Coulomb constant.
/// LAMMPS divides its Coulomb constant in units real, 332.06371 kcal/mol Å, by the argument of
/// `dielectric`. The quotient is polhode's Coulomb constant.
double lammps_dielectric();

}  // namespace polhode
