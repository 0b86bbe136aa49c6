// SPDX-License-Identifier: MIT
// The influence function: the factor of each Fourier coefficient of the mesh.
#pragma once

#include <array>
#include <vector>

#include "forces/laws/ewald_split.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

struct InfluenceValue {
  double factor;  ///< factor G in the energy E = ½ Σ G |S|² [kJ/mol/e²]
  double slope;  ///< factor H in −dE/dε = ½ Σ |S|² (G + H k ⊗ k), for a strain that also moves the
                 ///< charges
};

/// Computes the optimal influence function of a mesh. If forces are the gradient of the energy, the
/// factor G = Σ U² k² γ / (Σ U² · Σ U² k²) gives the smallest mean square error of forces
/// [ballenegger2012]. Sums are over k and its aliases. U(k) is the transform of the assignment
/// function, and γ is the required energy 4 π K ρ(k)/(k² V). U depends only on the grid, so the
/// volume derivative of G follows from the derivatives of ρ and k². The trace of the virial is
/// therefore as accurate as the forces.
class Influence {
 public:
  Influence(const MeshSettings& settings, const Box& box);

  /// The wave number of index n along edge d [1/nm]. An index n above half the number of points
  /// stands for the negative index n − points.
  double k(std::size_t d, std::size_t n) const { return axes_[d][n].k; }
  InfluenceValue operator()(const std::array<std::size_t, 3>& n) const;

 private:
  struct Alias {
    double k;
    double share;  // share U² of the alias
  };
  struct Wave {
    double k;
    std::array<Alias, 2> near;  // the wave and the alias with the next largest share
    double all, all_k2;         // sums Σ U² and Σ U² k² over all aliases
  };
  CompactSplit split_;
  double volume_;
  std::array<std::vector<Wave>, 3> axes_;
};

/// The influence function for all waves of a mesh. The influence function does not depend on the
/// signs of the wave numbers and, in a cubic box, not on their order. The function is computed only
/// once for each set of magnitudes |k|, because a barostat needs it for every new box.
class InfluenceTable {
 public:
  InfluenceTable(const Influence& influence, const std::array<std::size_t, 3>& points,
                 const Box& box, Workers& workers);
  InfluenceValue operator()(std::array<std::size_t, 3> n) const;

 private:
  std::size_t half(std::size_t d) const { return points_[d] / 2 + 1; }
  std::size_t place(const std::array<std::size_t, 3>& n) const {
    return (n[0] * half(1) + n[1]) * half(2) + n[2];
  }

  std::array<std::size_t, 3> points_;
  bool cubic_;
  std::vector<InfluenceValue> values_;
};

}  // namespace polhode
