// SPDX-License-Identifier: MIT
// Which sites of two molecule types interact, and with which strengths.
#pragma once

#include <type_traits>
#include <vector>

#include "polhode/forces/laws.hpp"
#include "polhode/forces/mixing.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The most interacting sites that one molecule may have: the pair loops keep them on the stack.
inline constexpr std::size_t most_sites = 64;

/// The interacting sites of a molecule as the pair loops take them: first those with a charge
/// alone, then those with charge and Lennard-Jones, then those with Lennard-Jones alone.
struct InteractionSites {
  std::vector<Site> sites;
  std::size_t charged = 0;     ///< the first so many have a charge
  std::size_t dispersive = 0;  ///< the last so many have Lennard-Jones
  std::size_t size() const { return sites.size(); }

  /// @throws Error  if there are more than most_sites
  explicit InteractionSites(const Molecule& molecule);
};

/// The strengths of all pairs of a site of one molecule type with one of another: dense, the index
/// of the first molecule's site running faster; 0 where a pair does not interact.
template <class T>
struct PairStrengths {
  std::vector<T> charge;  ///< K q_a q_b [kJ/mol nm]
  std::vector<T> c6;      ///< [kJ/mol nm⁶]
  std::vector<T> c12;     ///< [kJ/mol nm¹²]
};

/// Two molecule types.
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

/// The tables of all pairs of molecule types of a topology.
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
