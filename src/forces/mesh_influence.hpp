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
/// energy wanted, 4 π K ρ(k)/(k² V). Of γ the aliases are left out: they are smaller than the error
/// that remains. What multiplies γ then depends on the shape of the box alone, so the derivative by
/// volume is that of γ and as exact as forces are.
class Influence {
 public:
  Influence(const MeshSettings& settings, const Box& box);

  /// The wave number of index n along an edge [1/nm]: n or, beyond half of all, n − points.
  double k(std::size_t d, std::size_t n) const { return axes_[d][n].k; }
  InfluenceValue operator()(const std::array<std::size_t, 3>& n) const;

 private:
  struct Wave {
    double k;
    double share;        // U² [1]
    double all, all_k2;  // Σ U² and Σ U² k² over aliases
  };
  CompactSplit split_;
  double volume_;
  std::array<std::vector<Wave>, 3> axes_;
};

}  // namespace polhode
