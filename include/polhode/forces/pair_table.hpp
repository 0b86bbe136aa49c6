// SPDX-License-Identifier: MIT
// Which sites of two molecule types interact, and with which strengths.
#pragma once

#include <vector>

#include "polhode/forces/laws.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The most interacting sites that one molecule may have: the pair loops keep them on the stack.
inline constexpr std::size_t most_sites = 128;

/// The sites of a molecule that interact, in the order of the molecule.
std::vector<Site> interacting_sites(const Molecule& molecule);

/// The interacting pairs of sites of two molecule types, for each site b of the second those a of
/// the first.
struct PairTable {
  struct Term {
    std::size_t a = 0;
    double charges = 0;  ///< K q_a q_b [kJ/mol nm]
    LennardJones lennard_jones;
    bool charged = false, dispersive = false;
  };
  std::size_t sites_a = 0, sites_b = 0;
  std::vector<std::vector<Term>> of_b;

  /// Lorentz-Berthelot mixing: σ by arithmetic, ε by geometric mean.
  PairTable(const Molecule& first, const Molecule& second);
};

/// The tables of all pairs of molecule types of a topology.
class PairTables {
 public:
  explicit PairTables(const Topology& topology);
  const PairTable& operator()(std::size_t part_a, std::size_t part_b) const {
    return tables_[part_a * parts_ + part_b];
  }

 private:
  std::size_t parts_;
  std::vector<PairTable> tables_;
};

}  // namespace polhode
