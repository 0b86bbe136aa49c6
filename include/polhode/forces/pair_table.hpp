// SPDX-License-Identifier: MIT
// Which sites of two molecule types interact, and with which strengths.
#pragma once

#include <vector>

#include "polhode/forces/laws.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The most arms that one molecule may have: the pair loops keep them on the stack.
inline constexpr std::size_t most_arms = 128;

/// The interacting sites of a molecule as the pair loops take them: first all that carry charge,
/// then all with Lennard-Jones; a site with both stands in both groups.
struct Arms {
  std::vector<Site> sites;
  std::size_t charged = 0;  ///< the first so many
  std::size_t dispersive() const { return sites.size() - charged; }

  /// @throws Error  if there are more than most_arms
  explicit Arms(const Molecule& molecule);
};

/// The strengths of all pairs of a charged site of one molecule type with one of another, and of a
/// Lennard-Jones site with another: dense tables, the index of the first molecule's site running
/// faster.
struct PairTable {
  std::size_t charged_a = 0, charged_b = 0, dispersive_a = 0, dispersive_b = 0;
  std::vector<double> charges;              ///< K q_a q_b [kJ/mol nm]
  std::vector<LennardJones> lennard_jones;  ///< Lorentz-Berthelot: σ arithmetic, ε geometric mean

  PairTable(const Molecule& first, const Molecule& second);
  std::size_t arms_a() const { return charged_a + dispersive_a; }
  std::size_t arms_b() const { return charged_b + dispersive_b; }
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
