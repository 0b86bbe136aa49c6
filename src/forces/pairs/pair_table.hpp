// SPDX-License-Identifier: MIT
// Which sites of two molecule types interact, and how strongly.
#pragma once

#include <tuple>
#include <vector>

#include "forces/laws/laws.hpp"
#include "forces/laws/short_range.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Maximum number of interacting sites per molecule; the limit exists because the pair loops keep
/// the sites on the stack.
inline constexpr std::size_t max_sites = 64;

/// The interacting sites of a molecule, ordered for the pair loops: sites with only a charge, sites
/// with a charge and a short-range potential, and sites with only a short-range potential.
struct InteractionSites {
  std::vector<Site> sites;
  std::size_t charged = 0;     ///< number of sites with a charge, at the beginning
  std::size_t dispersive = 0;  ///< number of sites with a short-range potential, at the end
  std::size_t size() const { return sites.size(); }

  /// @throws Error  if more than max_sites sites interact
  explicit InteractionSites(const Molecule& molecule);
};

/// The interactions of all pairs of sites of two molecule types, as a dense table. The site index
/// of the first molecule runs fastest. Entries are 0 for pairs that do not interact.
/// @tparam Law  LennardJones<T> or, for any law, ShortRange<T>
template <class Law>
struct PairStrengths;
template <template <class> class Law, class T>
struct PairStrengths<Law<T>> {
  std::vector<T> charge;  ///< charge factors K q_a q_b [kJ/mol nm]
  std::vector<Law<T>> law;
};

/// The interactions of all site pairs of two molecule types.
class PairTable {
 public:
  /// @throws Error  if the potentials of two sites cannot be mixed
  PairTable(const Molecule& first, const Molecule& second, const Mixing& mixing = {});

  std::size_t sites_a, sites_b, charged_a, charged_b, dispersive_a, dispersive_b;

  /// Whether all short-range potentials are Lennard-Jones potentials.
  bool has_lennard_jones_alone() const { return !lennard_jones<double>().law.empty(); }
  /// The interactions of pairs that have only Lennard-Jones potentials or no short-range potential.
  template <class T>
  const PairStrengths<LennardJones<T>>& lennard_jones() const {
    return std::get<PairStrengths<LennardJones<T>>>(strengths_);
  }
  /// The interactions of pairs with any other short-range potential.
  template <class T>
  const PairStrengths<ShortRange<T>>& any_law() const {
    return std::get<PairStrengths<ShortRange<T>>>(strengths_);
  }

 private:
  std::tuple<PairStrengths<LennardJones<double>>, PairStrengths<LennardJones<float>>,
             PairStrengths<ShortRange<double>>, PairStrengths<ShortRange<float>>>
      strengths_;
};

/// The tables for all pairs of molecule types of a topology.
class PairTables {
 public:
  /// @throws Error  if an override of the mixing does not fit the topology, or if the potentials of
  ///   two sites cannot be mixed
  explicit PairTables(const Topology& topology, const Mixing& mixing = {});
  const PairTable& operator()(std::size_t part_a, std::size_t part_b) const {
    return tables_[part_a * parts_ + part_b];
  }

 private:
  std::size_t parts_;
  std::vector<PairTable> tables_;
};

}  // namespace polhode
