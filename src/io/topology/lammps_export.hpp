// SPDX-License-Identifier: MIT
// A system as LAMMPS reads it: a data file of atom_style full in units real, and the pair laws as
// tables or as commands for pair_style polhode.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Masses of massless sites in data files [u]: LAMMPS requires one above 0.
inline constexpr double lammps_massless = 1e-20;

/// The atom types of a topology: sites of one molecule that are equal share one.
class LammpsTypes {
 public:
  struct Type {
    std::size_t part;  ///< of the topology
    Site site;
    std::string name;  ///< "tip4p.OW"
  };
  /// @param share  false: one for each site, for mixing rules with exceptions for single sites
  LammpsTypes(const Topology& topology, bool share);
  const std::vector<Type>& types() const { return types_; }
  /// The number of the type of a site, from 1.
  int number(std::size_t part, std::size_t site) const { return numbers_[part][site]; }

 private:
  std::vector<Type> types_;
  std::vector<std::vector<int>> numbers_;  // [part][site]
};

/// The data file, with velocities and all digits: read back, positions differ by rounding alone.
/// Bonds of strength zero join the sites of a molecule, so that LAMMPS leaves out the interactions
/// between them. Lennard-Jones parameters are in it if all sites have that law.
void write_lammps_data(std::ostream& out, const std::string& title, const State& state,
                       const Topology& topology, const LammpsTypes& types);

/// The data file of the same system with one particle a molecule, of atom_style atomic: particles
/// have types of their own, behind those of the sites, and their orientations and angular momenta
/// are in a section for `fix property/atom`.
void write_lammps_particles(std::ostream& out, const std::string& title, const State& state,
                            const Topology& topology, const LammpsTypes& types);
inline constexpr std::string_view lammps_particle_section = "Orientations";

/// The molecule file of a part's molecule, in its principal frame.
void write_lammps_molecule(std::ostream& out, const Topology& topology, std::size_t part,
                           const LammpsTypes& types);

/// Energy and force between two types at a distance r [nm], truncated as in the settings.
struct TabulatedPair {
  double u;  ///< [kJ/mol]
  double f;  ///< −u' [kJ/mol/nm]
};
/// @param charges  whether their Coulomb interaction is included
TabulatedPair pair_at(const LammpsTypes::Type& a, const LammpsTypes::Type& b,
                      const Topology& topology, const ForceSettings& settings, bool charges,
                      double r);

/// The distances of tables, equally spaced in r² from lammps_table_start to the cutoff [nm].
inline constexpr std::size_t lammps_table_size = 20000;
inline constexpr double lammps_table_start = 0.03;

/// The tables of all pairs of types that interact, for pair_style table.
/// @return  for each pair of types i ≤ j its section, empty if they do not interact
/// @throws Error  if the settings truncate between centres of mass, which no table can
std::vector<std::string> write_lammps_tables(std::ostream& out, const Topology& topology,
                                             const ForceSettings& settings,
                                             const LammpsTypes& types, bool charges);

/// The settings as a line of an input script, for pair_style polhode in units real.
std::string lammps_pair_style(const ForceSettings& settings);

/// The Lennard-Jones parameters of all pairs of types, as lines of an input script in units real.
/// @throws Error  if a pair has another law
void write_lammps_pair_coefficients(std::ostream& out, const Topology& topology,
                                    const ForceSettings& settings, const LammpsTypes& types);

/// By what LAMMPS has to divide its Coulomb constant in units real, 332.06371 kcal/mol Å, so that
/// it is that of polhode: its command `dielectric`.
double lammps_dielectric();

}  // namespace polhode
