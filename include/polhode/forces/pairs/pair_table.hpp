// SPDX-License-Identifier: MIT
// Which sites of two molecule types interact, and how strongly.
#pragma once

#include <type_traits>
#include <vector>

#include "polhode/forces/laws/laws.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Maximum number of interacting sites per molecule: the pair loops keep them on the stack.
inline constexpr std::size_t max_sites = 64;

/// The interacting sites of a molecule in the order of the pair loops: first those with a charge
/// only, then those with charge and Lennard-Jones, then those with Lennard-Jones only.
struct InteractionSites {
  std::vector<Site> sites;
  std::size_t charged = 0;     ///< number of sites with a charge, at the front
  std::size_t dispersive = 0;  ///< number of sites with Lennard-Jones, at the back
  std::size_t size() const { return sites.size(); }

  /// @throws Error  if there are more than max_sites
  explicit InteractionSites(const Molecule& molecule);
};

/// The strengths of all pairs of a site of one molecule type with one of another: dense, the index
/// of the first molecule's site running fastest; 0 for pairs that do not interact.
template <class T>
struct PairStrengths {
  std::vector<T> charge;  ///< K q_a q_b [kJ/mol nm]
  std::vector<T> c6;      ///< [kJ/mol nm⁶]
  std::vector<T> c12;     ///< [kJ/mol nm¹²]
};

/// The site pairs of two molecule types.
class PairTable {
 public:
  PairTable(const Molecule& first, const Molecule& second, const Mixing& mixing = {});

  std::size_t sites_a, sites_b, charged_a, charged_b, dispersive_a, dispersive_b;

  template <class T>
  const PairStrengths<T>& strengths() const {
    if constexpr (std::is_same_v<T, float>)
      return rounded_;
    else
      return exact_;
  }

 private:
  PairStrengths<double> exact_;
  PairStrengths<float> rounded_;
};

/// The tables for all pairs of molecule types of a topology.
class PairTables {
 public:
  /// @throws Error  if an override of the mixing does not fit the topology
  explicit PairTables(const Topology& topology, const Mixing& mixing = {});
  const PairTable& operator()(std::size_t part_a, std::size_t part_b) const {
    return tables_[part_a * parts_ + part_b];
  }

 private:
  std::size_t parts_;
  std::vector<PairTable> tables_;
};

}  // namespace polhode
