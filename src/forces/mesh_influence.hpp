// SPDX-License-Identifier: MIT
// The influence function: what a mesh multiplies the waves of its charges by.
#pragma once

#include <array>
#include <vector>

#include "polhode/forces/ewald_split.hpp"
#include "polhode/forces/mesh_settings.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

struct InfluenceValue {
  double factor;  ///< G: E = ½ Σ G |S|² [kJ/mol/e²]
  double slope;  ///< H: −dE/dε = ½ Σ |S|² (G + H k ⊗ k) for a strain that moves charges along
};

/// With forces that are the gradient of the energy, the factor that makes their mean square error
/// least [ballenegger2012] is
///   G = Σ U² k² γ / (Σ U² · Σ U² k²),
/// where the sums are over k and its aliases, U(k) is the transform of a charge's share and γ the
/// energy wanted, 4 π K ρ(k)/(k² V). U depends on the grid alone, so G's derivative by volume is
/// that of ρ and k², and the trace of the virial as exact as forces are.
class Influence {
 public:
  Influence(const MeshSettings& settings, const Box& box);

  /// The wave number of index n along an edge [1/nm]: n or, beyond half of all, n − points.
  double k(std::size_t d, std::size_t n) const { return axes_[d][n].k; }
  InfluenceValue operator()(const std::array<std::size_t, 3>& n) const;

 private:
  struct Alias {
    double k;
    double share;  // U²
  };
  struct Wave {
    double k;
    std::array<Alias, 2> near;  // itself and the alias that has the next largest share
    double all, all_k2;         // Σ U² and Σ U² k² over aliases
  };
  CompactSplit split_;
  double volume_;
  std::array<std::vector<Wave>, 3> axes_;
};

}  // namespace polhode
